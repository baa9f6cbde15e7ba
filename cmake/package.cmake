# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
# The Debian package: `cpack --config build/CPackConfig.cmake -B build/packages`
# makes clayfoam (programs, cases, clay) and clayfoam-dev (to build against) of
# the system's LIGGGHTS and OpenFOAM.
if(NOT CLAYFOAM_DEM_HALF OR NOT CLAYFOAM_CFD_HALF OR OpenFOAM_VERSION MATCHES "^v")
  return()  # one half, or a sourced OpenFOAM, which no package can depend on
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME clayfoam)
set(CPACK_PACKAGE_CONTACT "The clayFoam authors <clayfoam@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL programs development)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)

# libraries by what the programs are linked with: libliggghts, libopenmpi; that of OpenFOAM, which does not say
# so itself, in the version that was built against
math(EXPR _next "${OpenFOAM_API} + 1")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME clayfoam)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/lib)
# what they start: blockMesh and its kin, mpirun, packmol, Python with its modules
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_DEPENDS "libopenfoam (>= ${OpenFOAM_API}), libopenfoam (<< ${_next}), openfoam, openmpi-bin, \
packmol, python3, python3-jinja2, python3-matplotlib, python3-meshio, python3-numpy, python3-scipy")
set(CPACK_COMPONENT_PROGRAMS_DESCRIPTION "Charged clumps of spheres (illite, kaolinite) settle in water: LIGGGHTS moves \
them, OpenFOAM\n solves the flow around them, side by side in one mpirun. `clay run --list` names the cases.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME clayfoam-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "clayfoam (= ${PROJECT_VERSION}), libeigen3-dev, zlib1g-dev, libliggghts-dev, \
libopenmpi-dev, librandom123-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Headers, libraries and CMake files of clayFoam, to build programs of one's \
own on them.")
include(CPack)
