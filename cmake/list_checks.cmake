# Writes OUTPUT, a ctest include file, from `PROGRAM --list` ("label name" per line).
execute_process(COMMAND "${PROGRAM}" --list OUTPUT_VARIABLE listing RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} --list failed: ${result}")
endif()
string(REPLACE "\n" ";" lines "${listing}")
set(text "")
foreach(line IN LISTS lines)
  if(line MATCHES "^([^ ]+) (.+)$")
    string(APPEND text "add_test([==[${CMAKE_MATCH_2}]==] [==[${PROGRAM}]==] --check [==[${CMAKE_MATCH_2}]==])\n"
                       "set_tests_properties([==[${CMAKE_MATCH_2}]==] PROPERTIES LABELS ${CMAKE_MATCH_1} TIMEOUT 300)\n")
  endif()
endforeach()
file(WRITE "${OUTPUT}" "${text}")
