# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
# Finds the LIGGGHTS library and headers; defines the target LIGGGHTS::LIGGGHTS.
find_path(LIGGGHTS_INCLUDE_DIR lammps.h PATH_SUFFIXES liggghts)
find_library(LIGGGHTS_LIBRARY liggghts)
if(LIGGGHTS_LIBRARY)
  get_filename_component(_liggghts_real ${LIGGGHTS_LIBRARY} REALPATH)
  string(REGEX MATCH "[0-9]+\\.[0-9]+\\.[0-9]+$" LIGGGHTS_VERSION "${_liggghts_real}")
endif()
# LIGGGHTS-PFM parted from LIGGGHTS before its clumps had volume weights and added mass
if(LIGGGHTS_INCLUDE_DIR)
  set(_weights "")
  if(EXISTS ${LIGGGHTS_INCLUDE_DIR}/multisphere.h)
    file(STRINGS ${LIGGGHTS_INCLUDE_DIR}/multisphere.h _weights REGEX "volumeweight")
  endif()
  if("${_weights}" STREQUAL "")
    # behind a blank CMake does not break the line
    message(FATAL_ERROR " LIGGGHTS: LIGGGHTS_INCLUDE_DIR is ${LIGGGHTS_INCLUDE_DIR}, whose clumps have no volume weights, "
      "as in LIGGGHTS-PFM, which is not supported: give LIGGGHTS_INCLUDE_DIR and LIGGGHTS_LIBRARY of LIGGGHTS-PUBLIC 3.8, "
      "or install the packages liggghts and libliggghts-dev")
  endif()
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
