# This file is part of clayFoam. SPDX-License-Identifier: GPL-3.0-or-later
# Runs liggghts-clay with a script that has one thing wrong: it must end with a
# non-zero exit and say what is wrong. Variables: program, script, says.
file(WRITE script.in "${script}\n")
execute_process(COMMAND ${program} -in script.in -log none
  RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE out)
if(status EQUAL 0)
  message(FATAL_ERROR "the run went through\n${out}")
endif()
string(FIND "${out}" "${says}" at)
if(at EQUAL -1)
  message(FATAL_ERROR "nothing was said of: ${says}\n${out}")
endif()
# one place in the sources, and nothing behind it but the line's end
string(REGEX MATCHALL "ERROR" errors "${out}")
list(LENGTH errors number)
string(REGEX MATCHALL "[a-z_]+[.]cpp:[0-9]+[)]" places "${out}")
list(LENGTH places ends)
if(NOT number EQUAL 1 OR NOT ends EQUAL 1)
  message(FATAL_ERROR "not one line of an error:\n${out}")
endif()
