# Each header of the library compiles alone: its own includes are enough. The front end suffices to know.
#   cmake -DROOT=... -DCXX=... -DEIGEN=... -P headers_alone.cmake
cmake_minimum_required(VERSION 3.25)
file(GLOB_RECURSE headers RELATIVE "${ROOT}" "${ROOT}/halfway/*.hpp")
list(TRANSFORM EIGEN PREPEND -isystem OUTPUT_VARIABLE eigen)
set(failures "")
foreach(header IN LISTS headers)
  execute_process(COMMAND "${CXX}" -std=c++20 -fsyntax-only -Wall -Wextra -Wpedantic -Werror
                          "-I${ROOT}" ${eigen} -include "${header}" -x c++ /dev/null
                  RESULT_VARIABLE failed ERROR_VARIABLE said)
  if(failed)
    string(APPEND failures "${header}:\n${said}")
  endif()
endforeach()
list(LENGTH headers count)
if(count EQUAL 0 OR failures)
  message(FATAL_ERROR "${count} headers; these do not compile alone:\n${failures}")
endif()
message(STATUS "${count} headers compile alone")
