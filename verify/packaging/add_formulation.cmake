# The trial formulation, one header and one catalog line, appears in tests, benchmarks, the command
# line and the report, and passes the tests that it gets.
cmake_minimum_required(VERSION 3.25)
file(MAKE_DIRECTORY "${WORK}")

# said(<variable> <input> <command...>): its stdout; anything but exit 0 is a failure.
function(said result input)
  file(WRITE "${WORK}/input" "${input}")
  execute_process(COMMAND ${ARGN} INPUT_FILE "${WORK}/input" WORKING_DIRECTORY "${WORK}"
                  OUTPUT_VARIABLE output ERROR_VARIABLE errors RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "${ARGN}: ${failed}\n${output}${errors}")
  endif()
  set(${result} "${output}" PARENT_SCOPE)
endfunction()

function(expect text pattern where)
  if(NOT text MATCHES "${pattern}")
    message(FATAL_ERROR "no match of '${pattern}' in ${where}:\n${text}")
  endif()
endfunction()

said(real "" "${REAL}" --list)
if(real MATCHES "[ /]trial/")
  message(FATAL_ERROR "the suite itself knows 'trial': this test would show nothing")
endif()

said(tests "" "${VERIFY}" --list)
expect("${tests}" "(^|\n)joints trial/angular/" "the list of tests")
expect("${tests}" "(^|\n)joints trial/linear_angular/" "the list of tests")
string(REGEX MATCHALL "[a-z]+ trial/[^\n]+" lines "${tests}")
foreach(line IN LISTS lines)
  string(REGEX REPLACE "^[a-z]+ " "" name "${line}")
  said(output "" "${VERIFY}" --check "${name}")
endforeach()
list(LENGTH lines count)

said(benchmarks "" "${BENCH}" --benchmark_list_tests)
foreach(kind IN ITEMS angular linear linear_angular)
  expect("${benchmarks}" "(^|\n)trial/${kind}/residual\n" "the list of benchmarks")
  expect("${benchmarks}" "(^|\n)trial/${kind}/residual_tangent\n" "the list of benchmarks")
endforeach()
said(timed "" "${BENCH}" --benchmark_filter=^trial/ --benchmark_min_time=0.001)
if(timed MATCHES "ERROR")
  message(FATAL_ERROR "a benchmark of the trial fails its check:\n${timed}")
endif()

said(listing "" "${CLI}" list)
expect("${listing}" "trial" "halfway list")
said(answer "{\"id\": 1, \"formulation\": \"trial\", \"kind\": \"angular\", \"law\": {\"type\": \"linear\", \"K\": [[1,0,0],[0,2,0],[0,0,3]]}, \"a\": {\"x\": [0,0,0], \"q\": [1,0,0,0]}, \"b\": {\"x\": [0,0,0], \"q\": [1,0,0,0]}}\n"
     "${CLI}" eval)
expect("${answer}" "\"loads\"" "halfway eval")

said(reported "" "${CLI}" report --quick --formulation trial --out "${WORK}/report")
file(READ "${WORK}/report/results.json" results)
expect("${results}" "\"trial/angular/tangent\"" "results.json")
expect("${results}" "\"trial/linear_angular/residual\"" "results.json")
file(READ "${WORK}/report/summary.md" summary)
expect("${summary}" "trial" "summary.md")
message(STATUS "trial: ${count} tests passed, benchmarks checked, listed, evaluated and reported")
