# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
# Finds the LIGGGHTS library and headers; defines the target LIGGGHTS::LIGGGHTS.
find_path(LIGGGHTS_INCLUDE_DIR lammps.h PATH_SUFFIXES liggghts)
find_library(LIGGGHTS_LIBRARY liggghts)
if(LIGGGHTS_LIBRARY)
  get_filename_component(_liggghts_real ${LIGGGHTS_LIBRARY} REALPATH)
  string(REGEX MATCH "[0-9]+\\.[0-9]+\\.[0-9]+$" LIGGGHTS_VERSION "${_liggghts_real}")
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(LIGGGHTS
  REQUIRED_VARS LIGGGHTS_LIBRARY LIGGGHTS_INCLUDE_DIR VERSION_VAR LIGGGHTS_VERSION
  REASON_FAILURE_MESSAGE "install the packages liggghts and libliggghts-dev")
if(LIGGGHTS_FOUND AND NOT TARGET LIGGGHTS::LIGGGHTS)
  add_library(LIGGGHTS::LIGGGHTS UNKNOWN IMPORTED)
  set_target_properties(LIGGGHTS::LIGGGHTS PROPERTIES
    IMPORTED_LOCATION ${LIGGGHTS_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${LIGGGHTS_INCLUDE_DIR}
    INTERFACE_LINK_LIBRARIES MPI::MPI_CXX)
endif()
