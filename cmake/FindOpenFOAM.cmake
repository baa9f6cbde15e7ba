# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
# Finds OpenFOAM; defines OpenFOAM::finiteVolume, OpenFOAM::turbulence.
#
# A sourced environment of openfoam.com's OpenFOAM (WM_PROJECT_DIR) comes first;
# it must have headers. Without one Debian's package is used; its headers are
# made from the source package of the same version, once, in OpenFOAM_HEADERS_DIR.
# What is read of the environment stands in setup.sh, too.
set(OpenFOAM_HEADERS_DIR ${PROJECT_BINARY_DIR}/openfoam CACHE PATH
    "Where the headers of a packaged OpenFOAM are kept")
set(_first 1912)
set(_last 2512)

# Ends with one line: a setting and its value, what it must be, and the cure
function(_openfoam_refuse setting)
  # behind a blank CMake does not break the line
  message(FATAL_ERROR " OpenFOAM: ${setting}: source openfoam.com's v${_first} to v${_last}, with its headers "
    "and in double precision, or build in a new shell without OpenFOAM's environment for Debian's package")
endfunction()

string(REGEX REPLACE "/+$" "" _dir "$ENV{WM_PROJECT_DIR}")
# the package's own folder is no sourced environment
execute_process(COMMAND sh -c "dpkg -L openfoam 2> /dev/null | sed -n 's,/etc/controlDict$,,p'"
                OUTPUT_VARIABLE _packaged OUTPUT_STRIP_TRAILING_WHITESPACE)
if(_dir STREQUAL "" OR _dir STREQUAL _packaged)
  execute_process(COMMAND ${CMAKE_CURRENT_LIST_DIR}/openfoam-headers.sh ${OpenFOAM_HEADERS_DIR}
                  RESULT_VARIABLE _status)
  if(NOT _status EQUAL 0)
    message(FATAL_ERROR "OpenFOAM: no headers; see the lines above")
  endif()
  set(_src ${OpenFOAM_HEADERS_DIR}/src)
  file(READ ${OpenFOAM_HEADERS_DIR}/version OpenFOAM_VERSION)
  # 1912.200626-1 -> 1912
  string(REGEX MATCH "^[0-9][0-9][0-9][0-9]" OpenFOAM_API "${OpenFOAM_VERSION}")
  if(OpenFOAM_API STREQUAL "" OR OpenFOAM_API LESS _first OR OpenFOAM_API GREATER _last)
    _openfoam_refuse("the package openfoam is of version ${OpenFOAM_VERSION}")
  endif()
  set(OpenFOAM_LABEL_SIZE 32)
  set(_etc ${_packaged})
  set(_libdirs "")
  set(_only "")
  set(_cure "install the packages openfoam and libopenfoam")
else()
  set(OpenFOAM_VERSION "$ENV{WM_PROJECT_VERSION}")
  if(EXISTS ${_dir}/META-INFO/api-info)
    file(STRINGS ${_dir}/META-INFO/api-info _line REGEX "^api=")
    string(REGEX REPLACE "^api=" "" OpenFOAM_API "${_line}")
    set(_said "${_dir}/META-INFO/api-info says api=${OpenFOAM_API}")
  elseif(OpenFOAM_VERSION MATCHES "^([0-9]+|[0-9]+\\.[0-9x.]+|dev)$")
    _openfoam_refuse("WM_PROJECT_VERSION is ${OpenFOAM_VERSION}, of the OpenFOAM Foundation, which is not supported")
  else()
    string(REGEX REPLACE "^v" "" OpenFOAM_API "${OpenFOAM_VERSION}")
    set(_said "WM_PROJECT_VERSION is '${OpenFOAM_VERSION}'")
  endif()
  if(NOT OpenFOAM_API MATCHES "^[0-9][0-9][0-9][0-9]$" OR OpenFOAM_API LESS _first OR OpenFOAM_API GREATER _last)
    _openfoam_refuse("${_said}, which is not supported")
  endif()
  set(OpenFOAM_VERSION "v${OpenFOAM_API}")
  if(NOT EXISTS ${_dir}/src/OpenFOAM/lnInclude)
    _openfoam_refuse("WM_PROJECT_DIR is ${_dir}, which holds no headers (src/OpenFOAM/lnInclude)")
  endif()
  set(_precision "$ENV{WM_PRECISION_OPTION}")
  if(NOT _precision MATCHES "^(DP)?$")
    _openfoam_refuse("WM_PRECISION_OPTION is ${_precision}; it must be DP")
  endif()
  set(OpenFOAM_LABEL_SIZE "$ENV{WM_LABEL_SIZE}")
  if(OpenFOAM_LABEL_SIZE STREQUAL "")
    set(OpenFOAM_LABEL_SIZE 32)
  elseif(NOT OpenFOAM_LABEL_SIZE MATCHES "^(32|64)$")
    _openfoam_refuse("WM_LABEL_SIZE is ${OpenFOAM_LABEL_SIZE}; it must be 32 or 64")
  endif()
  set(_src ${_dir}/src)
  set(_etc ${_dir})
  set(_libdirs $ENV{FOAM_LIBBIN} $ENV{FOAM_LIBBIN}/$ENV{FOAM_MPI})
  # headers and libraries of one installation
  set(_only NO_DEFAULT_PATH)
  set(_cure "FOAM_LIBBIN is '$ENV{FOAM_LIBBIN}' and FOAM_MPI '$ENV{FOAM_MPI}': compile the sourced OpenFOAM or install its libraries")
endif()

set(_need OpenFOAM finiteVolume meshTools incompressibleTransportModels
    turbulenceModels incompressibleTurbulenceModels fvOptions)
set(_found "")
foreach(lib IN LISTS _need)
  find_library(OpenFOAM_${lib}_LIBRARY ${lib} HINTS ${_libdirs} ${_only})
  list(APPEND _found OpenFOAM_${lib}_LIBRARY)
endforeach()
# the real libPstream, not the serial stand-in
find_library(OpenFOAM_Pstream_LIBRARY Pstream HINTS ${_libdirs} PATH_SUFFIXES openmpi-system
             NAMES_PER_DIR ${_only})

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenFOAM
  REQUIRED_VARS ${_found} OpenFOAM_Pstream_LIBRARY _src OpenFOAM_API
  REASON_FAILURE_MESSAGE "${_cure}")

if(OpenFOAM_FOUND AND NOT TARGET OpenFOAM::finiteVolume)
  set(OpenFOAM_PROJECT_DIR ${_etc})

  add_library(OpenFOAM::finiteVolume INTERFACE IMPORTED)
  target_compile_definitions(OpenFOAM::finiteVolume INTERFACE
    OPENFOAM=${OpenFOAM_API} WM_DP WM_LABEL_SIZE=${OpenFOAM_LABEL_SIZE} NoRepository
    CLAYFOAM_OPENFOAM_DIR="${OpenFOAM_PROJECT_DIR}")
  # OpenFOAM's field loops promise the compiler that result and operands do not
  # overlap (__restrict__), and break the promise where a temporary operand is
  # used again for the result. With -O3, GCC 12 then gives wrong vectors, for one
  # in fvc::reconstruct on a skewed mesh. Without the promise all is well.
  target_compile_definitions(OpenFOAM::finiteVolume INTERFACE __restrict__=)
  target_compile_options(OpenFOAM::finiteVolume INTERFACE -ftemplate-depth-100)
  set(_dirs "")
  foreach(lib OpenFOAM OSspecific/POSIX finiteVolume meshTools)
    list(APPEND _dirs ${_src}/${lib}/lnInclude)
  endforeach()
  target_include_directories(OpenFOAM::finiteVolume SYSTEM INTERFACE ${_dirs})
  target_link_libraries(OpenFOAM::finiteVolume INTERFACE
    -Wl,--no-as-needed ${OpenFOAM_finiteVolume_LIBRARY} ${OpenFOAM_meshTools_LIBRARY}
    ${OpenFOAM_OpenFOAM_LIBRARY} ${OpenFOAM_Pstream_LIBRARY} MPI::MPI_CXX dl m)

  add_library(OpenFOAM::turbulence INTERFACE IMPORTED)
  set(_dirs "")
  foreach(lib transportModels transportModels/incompressible
              TurbulenceModels/turbulenceModels TurbulenceModels/incompressible)
    list(APPEND _dirs ${_src}/${lib}/lnInclude)
  endforeach()
  list(APPEND _dirs ${_src}/transportModels)
  target_include_directories(OpenFOAM::turbulence SYSTEM INTERFACE ${_dirs})
  target_link_libraries(OpenFOAM::turbulence INTERFACE OpenFOAM::finiteVolume
    ${OpenFOAM_incompressibleTurbulenceModels_LIBRARY}
    ${OpenFOAM_turbulenceModels_LIBRARY}
    ${OpenFOAM_incompressibleTransportModels_LIBRARY}
    ${OpenFOAM_fvOptions_LIBRARY})
endif()
