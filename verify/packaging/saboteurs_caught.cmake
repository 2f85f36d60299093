# Two wrong formulations, each one header and one catalog line, are failed by the tests that they get.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND "${VERIFY}" --list OUTPUT_VARIABLE tests COMMAND_ERROR_IS_FATAL ANY)

# caught(<formulation> <kind> <properties...>): each check fails, and says so in a finding of its name.
function(caught formulation kind)
  foreach(property IN LISTS ARGN)
    set(name "${formulation}/${kind}/${property}")
    if(NOT tests MATCHES "[a-z]+ ${name}\n")
      message(FATAL_ERROR "there is no check ${name}")
    endif()
    execute_process(COMMAND "${VERIFY}" --check "${name}" OUTPUT_VARIABLE output ERROR_VARIABLE output
                    RESULT_VARIABLE failed)
    if(NOT failed MATCHES "^[0-9]+$" OR failed EQUAL 0 OR NOT output MATCHES "(^|\n)fail: ${name}")
      message(FATAL_ERROR "${name} is to fail and to say so; exit ${failed}:\n${output}")
    endif()
  endforeach()
endfunction()

caught(trial_nan angular objectivity node_order tangent symmetry rounding)
caught(trial_nan linear_angular objectivity node_order tangent symmetry rounding moment_balance)
caught(trial_transposed angular tangent symmetry fingerprint_alpha)
caught(trial_transposed linear_angular tangent symmetry)
message(STATUS "two wrong headers: 16 checks failed, as they should")
