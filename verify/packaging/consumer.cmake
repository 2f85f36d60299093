# Installs the header library to a fresh prefix, builds README's program against it in its own project
# and compares what it prints.
#   cmake -DBUILD=... -DSOURCE=... -DWORK=... -DCXX=... -P consumer.cmake
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE "${WORK}")
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE failed OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(failed)
    message(FATAL_ERROR "${ARGV}: ${failed}\n${output}")
  endif()
endfunction()
run("${CMAKE_COMMAND}" --install "${BUILD}/formulations" --prefix "${WORK}/prefix")
run("${CMAKE_COMMAND}" -S "${SOURCE}/consumer" -B "${WORK}/build" -G Ninja -DCMAKE_BUILD_TYPE=Release
    "-DCMAKE_CXX_COMPILER=${CXX}" "-DCMAKE_PREFIX_PATH=${WORK}/prefix")
run("${CMAKE_COMMAND}" --build "${WORK}/build")
execute_process(COMMAND "${WORK}/build/consumer" RESULT_VARIABLE failed OUTPUT_VARIABLE printed)
file(READ "${SOURCE}/consumer/expected.txt" expected)
if(failed OR NOT printed STREQUAL expected)
  message(FATAL_ERROR "the consumer printed (exit ${failed})\n${printed}instead of\n${expected}")
endif()

# README shows this program and this output.
file(READ "${README}" readme)
file(READ "${SOURCE}/consumer/main.cpp" program)
foreach(text IN ITEMS program expected)
  string(STRIP "${${text}}" wanted)
  string(FIND "${readme}" "${wanted}" found)
  if(found EQUAL -1)
    message(FATAL_ERROR "README.md does not show the consumer's ${text}:\n${wanted}")
  endif()
endforeach()
