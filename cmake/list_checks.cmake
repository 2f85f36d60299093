# Writes OUTPUT, a ctest include file, from `PROGRAM --list` ("room name" per line): a room is run once, by a test of
# its own, and keeps its records beside OUTPUT, where the test of each check reads one.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND "${PROGRAM}" --list OUTPUT_VARIABLE listing RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} --list failed: ${result}")
endif()
string(REPLACE "\n" ";" lines "${listing}")
cmake_path(GET OUTPUT PARENT_PATH folder)
set(text "")
set(rooms "")
foreach(line IN LISTS lines)
  if(NOT line MATCHES "^([^ ]+) (.+)$")
    continue()
  endif()
  set(room "${CMAKE_MATCH_1}")
  set(check "[==[${CMAKE_MATCH_2}]==]")
  set(kept "[==[${folder}/kept_${room}.jsonl]==]")
  if(NOT room IN_LIST rooms)
    list(APPEND rooms "${room}")
    # The limit of time guards against what hangs: a room takes seconds, the slowest a minute.
    string(APPEND text "add_test(room/${room} [==[${PROGRAM}]==] --room ${room} --keep ${kept})\n"
                       "set_tests_properties(room/${room} PROPERTIES LABELS ${room} FIXTURES_SETUP room_${room} TIMEOUT 1500)\n")
  endif()
  string(APPEND text "add_test(${check} [==[${PROGRAM}]==] --kept ${kept} --check ${check})\n"
                     "set_tests_properties(${check} PROPERTIES LABELS ${room} FIXTURES_REQUIRED room_${room} TIMEOUT 60)\n")
endforeach()
file(WRITE "${OUTPUT}" "${text}")
