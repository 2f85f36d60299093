# A dashboard run of CTest: build, tests and measurements become files below build/release/Testing, as CDash takes
# them. Nothing leaves the machine unless it is asked to.
#   ctest -S .ci/experimental.cmake -V
#   ctest -S .ci/experimental.cmake,Nightly -V            another model than Experimental
#   ... -DREPORT=out/report        measurements of a report that is there (default: one is made, minutes)
#   ... -DTARGETS=history_tests    what is built (default: tests and history_tests)
#   ... -DTESTS=history/           tests whose names match (default: all but those that build again)
#   ... -DSUBMIT=https://my.cdash.org/submit.php?project=NAME
cmake_minimum_required(VERSION 3.25)
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH CTEST_SOURCE_DIRECTORY)
set(CTEST_BINARY_DIRECTORY "${CTEST_SOURCE_DIRECTORY}/build/release")
set(CTEST_CMAKE_GENERATOR Ninja)
cmake_host_system_information(RESULT CTEST_SITE QUERY HOSTNAME)
set(CTEST_BUILD_NAME "${CMAKE_HOST_SYSTEM_NAME} release")
set(model Experimental)
if(CTEST_SCRIPT_ARG)
  set(model "${CTEST_SCRIPT_ARG}")
endif()
if(NOT TARGETS)
  set(TARGETS tests history_tests)
endif()
if(NOT TESTS)
  set(TESTS .)
endif()

# must(<what> <result>): a dashboard that is half there says so.
function(must what result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${what} failed (${result}); what there is lies in ${CTEST_BINARY_DIRECTORY}/Testing")
  endif()
endfunction()

ctest_start("${model}")
ctest_configure(OPTIONS "-DCMAKE_BUILD_TYPE=Release;-DCMAKE_EXPORT_COMPILE_COMMANDS=ON" RETURN_VALUE failed)
must(configuration "${failed}")
foreach(target IN LISTS TARGETS)
  ctest_build(TARGET ${target} APPEND RETURN_VALUE failed)
  must("the build of ${target}" "${failed}")
endforeach()

# The tests history/measured print what this file has last.
set(ENV{HALFWAY_HISTORY} "${CTEST_BINARY_DIRECTORY}/experimental.sqlite")
if(NOT REPORT)
  set(REPORT "${CTEST_BINARY_DIRECTORY}/experimental")
  # A report with failures ends with 1, and is a report.
  execute_process(COMMAND "${CTEST_SOURCE_DIRECTORY}/halfway" report --out "${REPORT}")
endif()
execute_process(COMMAND "${CTEST_SOURCE_DIRECTORY}/halfway" history add "${REPORT}" --file "$ENV{HALFWAY_HISTORY}"
                RESULT_VARIABLE failed)
must("keeping ${REPORT}" "${failed}")

ctest_test(INCLUDE "${TESTS}" EXCLUDE_LABEL ci RETURN_VALUE tests_failed)
if(SUBMIT)
  set(CTEST_SUBMIT_URL "${SUBMIT}")
  ctest_submit(RETURN_VALUE failed)
  must("sending to ${SUBMIT}" "${failed}")
endif()
must("a test" "${tests_failed}")
