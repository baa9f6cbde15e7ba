# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
# Sources of the run-time selectable models. They register themselves when
# loaded: the library that holds them must be shared or an object library.
set(CLAYFOAM_MODEL_SOURCES
  modelCoeffs/modelCoeffs.C
  modelCoeffs/savedPart.C
  modelCoeffs/savedState.C
  modelCoeffs/checkedNumber.C
  dispersedParticles/cellGeometry.C
  dispersedParticles/dispersedParticles.C
  voidFractionModels/voidFractionModel/voidFractionModel.C
  voidFractionModels/voidFractionModel/limitVoidFraction.C
  voidFractionModels/centre/centreVoidFraction.C
  voidFractionModels/divided/dividedVoidFraction.C
  voidFractionModels/exactOverlap/faceFacets.C
  voidFractionModels/exactOverlap/sphereFacet.C
  voidFractionModels/exactOverlap/exactOverlapVoidFraction.C
  dragModels/dragModel/dragModel.C
  dragModels/ergunWenYu/ergunWenYu.C
  dragModels/ergunWenYuBlended/ergunWenYuBlended.C
  dragModels/SchillerNaumann/SchillerNaumann.C
  dragModels/Gidaspow/Gidaspow.C
  dragModels/DiFelice/DiFelice.C
  dragModels/Beetstra/Beetstra.C
  dragModels/KochHill/KochHill.C
  dragModels/WenYu/WenYu.C
  dragModels/Ergun/Ergun.C
  dragModels/Stokes/Stokes.C
  dragModels/SyamlalOBrien/SyamlalOBrien.C
  smoothingModels/smoothingModel/smoothingModel.C
  smoothingModels/none/noSmoothing.C
  smoothingModels/diffusion/diffusionSmoothing.C
  selfDisturbanceModels/selfDisturbanceModel/selfDisturbanceModel.C
  selfDisturbanceModels/none/noSelfDisturbance.C
  selfDisturbanceModels/latticeMemory/latticeHeat.C
  selfDisturbanceModels/latticeMemory/latticeWeights.C
  selfDisturbanceModels/latticeMemory/latticeResponse.C
  selfDisturbanceModels/latticeMemory/disturbanceHistory.C
  selfDisturbanceModels/latticeMemory/latticeMemory.C
  dispersedParticles/handOver.C)

set(CLAYFOAM_MODEL_INCLUDE_DIRS
  modelCoeffs dispersedParticles
  voidFractionModels/voidFractionModel voidFractionModels/centre
  voidFractionModels/divided voidFractionModels/exactOverlap
  dragModels/dragModel dragModels/ergunWenYu dragModels/ergunWenYuBlended
  dragModels/SchillerNaumann dragModels/Gidaspow dragModels/DiFelice
  dragModels/Beetstra dragModels/KochHill
  dragModels/WenYu dragModels/Ergun
  dragModels/Stokes dragModels/SyamlalOBrien
  smoothingModels/smoothingModel smoothingModels/none smoothingModels/diffusion
  selfDisturbanceModels/selfDisturbanceModel selfDisturbanceModels/none
  selfDisturbanceModels/latticeMemory)
set(CLAYFOAM_MODEL_DIR ${CMAKE_CURRENT_LIST_DIR})
list(TRANSFORM CLAYFOAM_MODEL_INCLUDE_DIRS PREPEND ${CLAYFOAM_MODEL_DIR}/)

# Adds the models' tests; call it once the library clayCoupling is defined.
macro(clayfoam_model_tests)
  # OpenFOAM's libraries look for their etc/ as they are loaded
  set(environment ${CLAYFOAM_MODEL_DIR}/clayFoam/environment.C)

  add_library(clayTestMesh STATIC ${CLAYFOAM_MODEL_DIR}/tests/testMesh.C
    ${CLAYFOAM_MODEL_DIR}/tests/meshCase.C
    ${CLAYFOAM_MODEL_DIR}/tests/testMain.C)
  target_include_directories(clayTestMesh PUBLIC ${CLAYFOAM_MODEL_DIR}/tests)
  target_compile_definitions(clayTestMesh PUBLIC
    CLAYFOAM_TEST_DATA="${CLAYFOAM_MODEL_DIR}/tests/data")
  target_link_libraries(clayTestMesh PUBLIC clayCoupling GTest::gtest Eigen3::Eigen)

  foreach(test
      modelCoeffs/checkedNumberTest
      dragModels/dragModelTest
      forceModels/forceModelTest
      voidFractionModels/exactOverlap/sphereFacetTest
      voidFractionModels/voidFractionModelTest
      voidFractionModels/limitVoidFractionTest
      dispersedParticles/dispersedParticlesTest
      smoothingModels/smoothingModelTest
      selfDisturbanceModels/selfDisturbanceTest
      coupling/leftOutTest
      coupling/momentumLedgerTest
      coupling/particleSumsTest
      coupling/voidFractionHistoryTest
      coupling/particleForcesTest
      coupling/cellWavesTest
      coupling/particleTurnoverTest
      coupling/meshPeriodTest
      coupling/viscosityLawTest
      coupling/particleResponseTest)
    get_filename_component(name ${test} NAME)
    add_executable(${name} ${CLAYFOAM_MODEL_DIR}/${test}.C ${environment})
    target_link_libraries(${name} PRIVATE clayTestMesh)
    add_test(NAME ${name} COMMAND ${name})
  endforeach()

  # no collective call behind what ranks may see differently
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  add_test(NAME collectives
    COMMAND Python3::Interpreter ${CLAYFOAM_MODEL_DIR}/tests/collectives.py)
  set_tests_properties(collectives PROPERTIES TIMEOUT 60)

  # the solver's own operators
  add_executable(faceOperatorsTest
    ${CLAYFOAM_MODEL_DIR}/clayFoam/faceOperatorsTest.C
    ${CLAYFOAM_MODEL_DIR}/clayFoam/faceOperators.C
    ${CLAYFOAM_MODEL_DIR}/clayFoam/uncarriedForce.C
    ${CLAYFOAM_MODEL_DIR}/clayFoam/keptFactorPreconditioner.C ${environment})
  target_link_libraries(faceOperatorsTest PRIVATE clayTestMesh Eigen3::Eigen)
  add_test(NAME faceOperatorsTest COMMAND faceOperatorsTest)

  add_executable(carryingFluxTest
    ${CLAYFOAM_MODEL_DIR}/clayFoam/carryingFluxTest.C
    ${CLAYFOAM_MODEL_DIR}/clayFoam/carryingFlux.C
    ${CLAYFOAM_MODEL_DIR}/clayFoam/keptFactorPreconditioner.C ${environment})
  target_link_libraries(carryingFluxTest PRIVATE clayTestMesh Eigen3::Eigen)
  add_test(NAME carryingFluxTest COMMAND carryingFluxTest)

  # the same on several ranks
  foreach(test parallelMappingTest parallelHandOverTest)
    add_executable(${test} ${CLAYFOAM_MODEL_DIR}/tests/${test}.C ${environment})
    target_link_libraries(${test} PRIVATE clayTestMesh)
    foreach(ranks 2 3 4)
      add_test(NAME ${test}_${ranks}
        COMMAND ${MPIEXEC_EXECUTABLE} ${MPIEXEC_NUMPROC_FLAG} ${ranks}
          $<TARGET_FILE:${test}>)
      set_tests_properties(${test}_${ranks} PROPERTIES
        PROCESSORS ${ranks} TIMEOUT 120
        ENVIRONMENT "${CLAYFOAM_MPI_ENVIRONMENT}")
    endforeach()
  endforeach()

  # not a test: prints what each scheme costs a particle
  add_executable(mappingCost
    ${CLAYFOAM_MODEL_DIR}/tests/mappingCost.C ${environment})
  target_link_libraries(mappingCost PRIVATE clayTestMesh)
endmacro()
