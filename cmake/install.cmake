# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
# What `cmake --install` puts where, below its prefix:
#   bin/                  clay, clayFoam, liggghts-clay
#   lib/                  libclayCoupling and the libraries others may link
#   lib/cmake/clayFoam/   the CMake package
#   include/clayfoam/     headers
#   share/clayfoam/       cases, and the Python that runs them
# The prefix may be moved as a whole. What one builds against stands in the
# component `development`.
set(CMAKE_INSTALL_DOCDIR share/doc/clayfoam CACHE PATH "Documents of an installation")
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(_package ${CMAKE_INSTALL_LIBDIR}/cmake/clayFoam)
set(_include ${CMAKE_INSTALL_INCLUDEDIR}/clayfoam)
set(_share ${CMAKE_INSTALL_DATADIR}/clayfoam)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME programs)

# programs find this project's library from where they are; those of a sourced
# OpenFOAM or another LIGGGHTS stay where they were found
file(RELATIVE_PATH _to_lib /${CMAKE_INSTALL_BINDIR} /${CMAKE_INSTALL_LIBDIR})
function(_clay_hosts variable)
  set(found "")
  foreach(library ${ARGN})
    get_filename_component(folder ${library} DIRECTORY)
    if(NOT folder IN_LIST CMAKE_CXX_IMPLICIT_LINK_DIRECTORIES)
      list(APPEND found ${folder})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES found)
  set(${variable} "${found}" PARENT_SCOPE)
endfunction()
_clay_hosts(_liggghts ${LIGGGHTS_LIBRARY})
_clay_hosts(_openfoam ${OpenFOAM_OpenFOAM_LIBRARY} ${OpenFOAM_Pstream_LIBRARY})

# clay_install_set(NAME targets ...): libraries that NAME.cmake of the package defines
function(clay_install_set set)
  install(TARGETS ${ARGN} EXPORT clayFoam_${set}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
    OBJECTS DESTINATION ${CMAKE_INSTALL_LIBDIR}/clayfoam COMPONENT development)
  install(EXPORT clayFoam_${set} NAMESPACE clayFoam:: DESTINATION ${_package} COMPONENT development
    FILE ${set}.cmake)
endfunction()

install(DIRECTORY exchange/ DESTINATION ${_include}/exchange COMPONENT development
  FILES_MATCHING PATTERN "*.h" PATTERN "test_*" EXCLUDE)
set_target_properties(clay_exchange PROPERTIES EXPORT_NAME exchange)
set_target_properties(clay_world PROPERTIES EXPORT_NAME world)
clay_install_set(exchange clay_exchange clay_world)

if(CLAYFOAM_DEM_HALF)
  set_target_properties(liggghts-clay PROPERTIES INSTALL_RPATH "${_liggghts}")
  install(TARGETS liggghts-clay RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(DIRECTORY liggghts-fix/ DESTINATION ${_include}/liggghts-fix COMPONENT development
    FILES_MATCHING PATTERN "*.h" PATTERN "test*" EXCLUDE PATTERN "bench" EXCLUDE PATTERN "doc" EXCLUDE)
  install(DIRECTORY ${PROJECT_BINARY_DIR}/liggghts-fix/host DESTINATION ${_include} COMPONENT development)
  get_property(_rooms GLOBAL PROPERTY CLAY_ROOM_TARGETS)
  set_target_properties(clay_driver_styles PROPERTIES EXPORT_NAME styles)
  clay_install_set(styles ${_rooms})
endif()

if(CLAYFOAM_CFD_HALF)
  set_target_properties(clayFoam PROPERTIES INSTALL_RPATH "$ORIGIN/${_to_lib};${_openfoam}")
  set_target_properties(clayCoupling PROPERTIES INSTALL_RPATH "$ORIGIN;${_openfoam}" EXPORT_NAME coupling)
  install(TARGETS clayFoam RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  # as OpenFOAM has its own: all headers in one folder
  file(GLOB_RECURSE _headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/foam-coupling/*.H)
  list(FILTER _headers EXCLUDE REGEX "/(tests|clayFoam)/|Test\\.H$")
  file(GLOB_RECURSE _templates CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/foam-coupling/*Templates.C)
  install(FILES ${_headers} ${_templates} DESTINATION ${_include}/foam-coupling COMPONENT development)
  clay_install_set(coupling clayCoupling)
endif()

configure_package_config_file(cmake/clayFoamConfig.cmake.in ${PROJECT_BINARY_DIR}/clayFoamConfig.cmake
  INSTALL_DESTINATION ${_package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/clayFoamConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/clayFoamConfig.cmake ${PROJECT_BINARY_DIR}/clayFoamConfigVersion.cmake
  cmake/FindLIGGGHTS.cmake cmake/FindOpenFOAM.cmake DESTINATION ${_package} COMPONENT development)
install(PROGRAMS cmake/openfoam-headers.sh DESTINATION ${_package} COMPONENT development)

# the cases and what runs them; installed.json tells Python where it is
file(RELATIVE_PATH _share_bin /${_share} /${CMAKE_INSTALL_BINDIR})
file(RELATIVE_PATH _share_lib /${_share} /${CMAKE_INSTALL_LIBDIR})
file(RELATIVE_PATH _to_share /${CMAKE_INSTALL_BINDIR} /${_share})
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/installed.json CONTENT
  "{\"version\": \"@PROJECT_VERSION@\", \"bin\": \"@_share_bin@\", \"lib\": \"@_share_lib@\"}\n" @ONLY)
configure_file(cmake/clay.in ${PROJECT_BINARY_DIR}/installed/clay @ONLY)
install(PROGRAMS ${PROJECT_BINARY_DIR}/installed/clay DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES __main__.py ${PROJECT_BINARY_DIR}/installed.json DESTINATION ${_share})
install(DIRECTORY cases DESTINATION ${_share}
  REGEX "/(test_[^/]*[.]py|__pycache__|[^/]*[.]md)$" EXCLUDE
  REGEX "/cases/(run|report|pack|kynch|stages|consolidation|study|sweep|calibrate|scaling|figures|clay)$" EXCLUDE)
install(FILES cmake/clay.bash RENAME clay DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES LICENSE RENAME copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES README.md CHANGELOG.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
