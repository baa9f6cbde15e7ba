# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
# dem.clones.BYTES: the tests of the kernels that are compiled for several generations
# of processors, on each generation by itself; on which one the other tests run is the
# processor's choice. Of one that it lacks the tests' names are printed.
set(rooms ${CMAKE_CURRENT_SOURCE_DIR})
set(clones
  ${rooms}/clumps/body_rotation.cpp
  ${rooms}/clumps/body_spheres.cpp
  ${rooms}/contacts/contact_act.cpp
  ${rooms}/contacts/contact_kernel.cpp
  ${rooms}/coulomb/charge_tiles.cpp)
set_source_files_properties(${clones} PROPERTIES COMPILE_OPTIONS "${CLAY_SIMD_OPTIONS}")

# a source that has clones and is not in the list would go untested
file(GLOB sources ${rooms}/*/*.cpp)
foreach(source ${sources})
  file(STRINGS ${source} found REGEX "^(GENERATION |CLAY_CLONES |CLAY_TILES\\(CLAY_FOR)")
  if(found AND NOT source IN_LIST clones)
    message(FATAL_ERROR "${source} has CLAY_CLONES: add it to simd/clone_tests.cmake")
  endif()
endforeach()

foreach(bytes 16 32 64)
  # objects of its own come before those of the rooms' libraries
  add_executable(test_clones_${bytes} simd/test_clones_main.cpp ${clones}
    clumps/test_body_rotation.cpp
    clumps/test_body_spheres.cpp
    contacts/test_contact_kernel.cpp
    coulomb/test_coul_kernel.cpp
    coulomb/test_dlvo_law.cpp)
  target_compile_definitions(test_clones_${bytes} PRIVATE CLAY_ONLY_BYTES=${bytes})
  target_link_libraries(test_clones_${bytes} PRIVATE
    clay_coulomb clay_contacts clay_clumps GTest::gtest Threads::Threads)
  add_test(NAME dem.clones.${bytes} COMMAND test_clones_${bytes})
  set_tests_properties(dem.clones.${bytes} PROPERTIES TIMEOUT 60)
endforeach()
