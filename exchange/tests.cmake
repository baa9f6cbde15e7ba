# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
include(GoogleTest)

# What mpirun needs where the tests run as root or have few cores; Open MPI reads
# it from the environment, others ignore it. For the tests of all folders.
set(CLAYFOAM_MPI_ENVIRONMENT
  OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
  OMPI_MCA_rmaps_base_oversubscribe=1
  PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe # in Open MPI 5
  CACHE INTERNAL "environment of tests that call mpirun")

add_executable(test_terms test_terms.cpp)
target_link_libraries(test_terms PRIVATE clay_exchange GTest::gtest_main)
gtest_add_tests(TARGET test_terms TEST_PREFIX exchange. TEST_LIST terms_tests)
set_tests_properties(${terms_tests} PROPERTIES TIMEOUT 20)

add_executable(test_waiting test_waiting.cpp)
target_link_libraries(test_waiting PRIVATE clay_exchange GTest::gtest_main)
gtest_add_tests(TARGET test_waiting TEST_PREFIX exchange. TEST_LIST waiting_tests)
set_tests_properties(${waiting_tests} PROPERTIES TIMEOUT 20)

# damaged messages, by the decoders alone
add_executable(test_decode test_decode.cpp)
target_link_libraries(test_decode PRIVATE clay_exchange GTest::gtest_main)
add_test(NAME exchange.decode COMMAND test_decode)
set_tests_properties(exchange.decode PROPERTIES TIMEOUT 20)

# the same decoders under libFuzzer: whatever bytes come in, they refuse or decode
if(CLAYFOAM_FUZZ)
  find_program(CLAYFOAM_CLANGXX NAMES clang++ clang++-14)
  if(CLAYFOAM_CLANGXX)
    set(fuzz_decode ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/fuzz_decode)
    set(decoders fuzz_decode.cpp decode.cpp packing.cpp fields.cpp terms.cpp agreement.cpp)
    list(TRANSFORM decoders PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
    file(GLOB exchange_headers ${CMAKE_CURRENT_SOURCE_DIR}/*.h)
    add_custom_command(OUTPUT ${fuzz_decode} DEPENDS ${decoders} ${exchange_headers}
      COMMAND ${CLAYFOAM_CLANGXX} -std=c++17 -O1 -g -fsanitize=fuzzer,address,undefined
        -fsanitize=float-cast-overflow -fno-sanitize-recover=all -I${PROJECT_SOURCE_DIR}
        ${decoders} -o ${fuzz_decode})
    add_custom_target(fuzz_decode_program ALL DEPENDS ${fuzz_decode})
    add_test(NAME exchange.fuzz
      COMMAND ${fuzz_decode} -max_total_time=10 -max_len=4096 -print_final_stats=0)
    set_tests_properties(exchange.fuzz PROPERTIES TIMEOUT 60)
  endif()
endif()

add_executable(test_saved_pair test_saved_pair.cpp)
target_link_libraries(test_saved_pair PRIVATE clay_exchange GTest::gtest_main)
gtest_add_tests(TARGET test_saved_pair TEST_PREFIX exchange. TEST_LIST saved_pair_tests)
set_tests_properties(${saved_pair_tests} PROPERTIES TIMEOUT 20)

# particles that several ranks hold
add_executable(test_shared test_shared.cpp)
target_link_libraries(test_shared PRIVATE clay_world clay_exchange GTest::gtest)
add_test(NAME exchange.shared
  COMMAND ${MPIEXEC_EXECUTABLE} ${MPIEXEC_NUMPROC_FLAG} 3 $<TARGET_FILE:test_shared>)
set_tests_properties(exchange.shared PROPERTIES
  TIMEOUT 60 PROCESSORS 3 ENVIRONMENT "${CLAYFOAM_MPI_ENVIRONMENT}")

# the two programs of the test runs
foreach(half test_dem_half test_cfd_half)
  add_executable(${half} ${half}.cpp test_damage.cpp)
  target_link_libraries(${half} PRIVATE clay_world clay_exchange ${CMAKE_DL_LIBS})
endforeach()

# a program that splits the world by itself has no wrappers
add_executable(test_adopt_half test_adopt_half.cpp)
target_link_libraries(test_adopt_half PRIVATE clay_exchange)

add_executable(test_runs test_runs.cpp)
add_executable(test_damage_runs test_damage_runs.cpp)
list(JOIN CLAYFOAM_MPI_ENVIRONMENT " " mpi_environment)
foreach(runs test_runs test_damage_runs)
  target_include_directories(${runs} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${runs} PRIVATE GTest::gtest_main)
  target_compile_definitions(${runs} PRIVATE
    MPIRUN="env ${mpi_environment} ${MPIEXEC_EXECUTABLE}"
    ADOPT_HALF="$<TARGET_FILE:test_adopt_half>"
    DEM_HALF="$<TARGET_FILE:test_dem_half>" CFD_HALF="$<TARGET_FILE:test_cfd_half>")
  add_dependencies(${runs} test_dem_half test_cfd_half test_adopt_half)
endforeach()
add_test(NAME exchange.damage_runs COMMAND test_damage_runs)
# these mostly wait, for mpirun and for time-outs: each counts as one process
set_tests_properties(exchange.damage_runs PROPERTIES TIMEOUT 600)
gtest_add_tests(TARGET test_runs TEST_PREFIX exchange. TEST_LIST run_tests)
set_tests_properties(${run_tests} PROPERTIES TIMEOUT 60)

# The libraries of the host codes that call MPI, from a sourced OpenFOAM first
set(host_libraries "")
find_library(CLAYFOAM_HOST_LIGGGHTS liggghts)
foreach(lib Pstream ptscotchDecomp)
  find_library(CLAYFOAM_HOST_${lib} ${lib} PATHS $ENV{FOAM_LIBBIN}/$ENV{FOAM_MPI} NO_DEFAULT_PATH)
  find_library(CLAYFOAM_HOST_${lib} ${lib} PATH_SUFFIXES openmpi-system NO_CMAKE_ENVIRONMENT_PATH)
endforeach()
foreach(lib LIGGGHTS Pstream ptscotchDecomp)
  if(CLAYFOAM_HOST_${lib})
    list(APPEND host_libraries ${CLAYFOAM_HOST_${lib}})
  endif()
endforeach()
find_file(CLAYFOAM_MPI_HEADER mpi.h HINTS ${MPI_CXX_INCLUDE_DIRS} REQUIRED)

add_executable(test_wrappers test_wrappers.cpp)
target_link_libraries(test_wrappers PRIVATE clay_world clay_exchange GTest::gtest ${CMAKE_DL_LIBS})
add_test(NAME exchange.wrappers
  COMMAND test_wrappers ${CLAYFOAM_MPI_HEADER} ${host_libraries})

# the same test in a program without the wrappers must fail
add_executable(test_no_wrappers test_wrappers.cpp)
target_include_directories(test_no_wrappers PRIVATE ${PROJECT_SOURCE_DIR})
target_link_libraries(test_no_wrappers PRIVATE MPI::MPI_CXX GTest::gtest ${CMAKE_DL_LIBS})
add_test(NAME exchange.wrappers_can_fail
  COMMAND test_no_wrappers ${CLAYFOAM_MPI_HEADER} ${host_libraries})
set_tests_properties(exchange.wrappers_can_fail PROPERTIES WILL_FAIL ON)
set_tests_properties(exchange.wrappers exchange.wrappers_can_fail PROPERTIES TIMEOUT 60)
