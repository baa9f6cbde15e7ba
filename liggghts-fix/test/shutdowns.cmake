# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
# Runs liggghts-clay with a script that ends before it couples, beside a CFD half that waits
# for it: both end within 10 s of the end, and the other half says why.
# Variables: mpirun, program, other, script, says.
file(WRITE script.in "${script}\n")
string(TIMESTAMP begin "%s")
execute_process(COMMAND ${mpirun} 1 ${program} -in script.in -log none : -np 1 ${other} echo 1
  RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE out TIMEOUT 50)
string(TIMESTAMP end "%s")
math(EXPR seconds "${end} - ${begin}")
if(status STREQUAL "0")
  message(FATAL_ERROR "the run went through\n${out}")
endif()
if(seconds GREATER 25)
  message(FATAL_ERROR "it took ${seconds} s\n${out}")
endif()
string(FIND "${out}" "test_cfd_half: stopped: the DEM half ended: liggghts-clay ${says}" at)
if(at EQUAL -1)
  message(FATAL_ERROR "the other half did not say: ${says}\n${out}")
endif()
