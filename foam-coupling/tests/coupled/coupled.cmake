# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
# Tests of clayFoam beside a small DEM half made for them
set(_coupled ${CMAKE_CURRENT_LIST_DIR})

add_executable(standInDem ${_coupled}/standInDem.cpp $<TARGET_OBJECTS:clay_world>)
target_link_libraries(standInDem PRIVATE clay_exchange nlohmann_json::nlohmann_json)
set_target_properties(standInDem PROPERTIES ENABLE_EXPORTS ON)

foreach(test coupled features input ranks refusals)
  add_executable(test_${test} ${_coupled}/test_${test}.cpp ${_coupled}/coupledRun.cpp)
  target_link_libraries(test_${test} PRIVATE GTest::gtest_main nlohmann_json::nlohmann_json)
  target_compile_definitions(test_${test} PRIVATE
    CLAYFOAM_TEST_BOX="${_coupled}/box"
    CLAYFOAM_TEST_RUNS="${CMAKE_CURRENT_BINARY_DIR}/runs-${test}"
    CLAYFOAM_OPENFOAM_DIR="${OpenFOAM_PROJECT_DIR}"
    CLAYFOAM_MPIEXEC="${MPIEXEC_EXECUTABLE}"
    CLAYFOAM_STANDIN="$<TARGET_FILE:standInDem>"
    CLAYFOAM_PROGRAM="$<TARGET_FILE:clayFoam>")
  target_compile_options(test_${test} PRIVATE -Wall -Wextra)
  add_dependencies(test_${test} standInDem clayFoam)
  add_test(NAME ${test} COMMAND test_${test})
  # a half that waits for ever ends its test soon
  set_tests_properties(${test} PROPERTIES TIMEOUT 600
    ENVIRONMENT CLAYFOAM_TIMEOUT=60)
endforeach()
# the others mostly wait, for mpirun or for an end, or have one rank at work
set_tests_properties(coupled ranks PROPERTIES PROCESSORS 2)
