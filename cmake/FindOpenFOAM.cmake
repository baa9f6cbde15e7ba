# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
# Finds OpenFOAM; defines OpenFOAM::finiteVolume, OpenFOAM::turbulence.
#
# A sourced OpenFOAM environment (WM_PROJECT_DIR with its sources) comes first.
# Otherwise Debian's package is used; its headers are made from the source
# package of the same version, once, in OpenFOAM_HEADERS_DIR.
set(OpenFOAM_HEADERS_DIR ${PROJECT_BINARY_DIR}/openfoam CACHE PATH
    "Where the headers of a packaged OpenFOAM are kept")

if(DEFINED ENV{WM_PROJECT_DIR} AND EXISTS $ENV{WM_PROJECT_DIR}/src/OpenFOAM/lnInclude)
  set(_src $ENV{WM_PROJECT_DIR}/src)
  set(_etc $ENV{WM_PROJECT_DIR})
  set(_libdirs $ENV{FOAM_LIBBIN} $ENV{FOAM_LIBBIN}/$ENV{FOAM_MPI})
  # headers and libraries of one installation
  set(_only NO_DEFAULT_PATH)
  set(OpenFOAM_VERSION "$ENV{WM_PROJECT_VERSION}")
  set(_how sourced)
else()
  execute_process(COMMAND ${PROJECT_SOURCE_DIR}/cmake/openfoam-headers.sh ${OpenFOAM_HEADERS_DIR}
                  RESULT_VARIABLE _status)
  if(NOT _status EQUAL 0)
    message(FATAL_ERROR "OpenFOAM: no headers; see the lines above")
  endif()
  set(_src ${OpenFOAM_HEADERS_DIR}/src)
  file(READ ${OpenFOAM_HEADERS_DIR}/version OpenFOAM_VERSION)
  execute_process(COMMAND sh -c "dpkg -L openfoam | sed -n 's,/etc/controlDict$,,p'"
                  OUTPUT_VARIABLE _etc OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(_libdirs "")
  set(_only "")
  set(_how installed)
endif()
# v1912 -> 1912, 1912.200626-1 -> 1912
string(REGEX MATCH "[0-9][0-9][0-9][0-9]" OpenFOAM_API "${OpenFOAM_VERSION}")
if(NOT OpenFOAM_API STREQUAL 1912)
  message(FATAL_ERROR "OpenFOAM ${OpenFOAM_VERSION} is ${_how}; it must be v1912: "
    "source v1912, or none to use Debian 12's package")
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
  REASON_FAILURE_MESSAGE "install the packages openfoam and libopenfoam")

if(OpenFOAM_FOUND AND NOT TARGET OpenFOAM::finiteVolume)
  set(OpenFOAM_PROJECT_DIR ${_etc})

  add_library(OpenFOAM::finiteVolume INTERFACE IMPORTED)
  target_compile_definitions(OpenFOAM::finiteVolume INTERFACE
    OPENFOAM=${OpenFOAM_API} WM_DP WM_LABEL_SIZE=32 NoRepository
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
