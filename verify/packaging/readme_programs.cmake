# README's table of real programs says what they are known to be and to do: rows, joints and words against
# verify/programs/verdicts.tsv, which the programs themselves are held to, counts against the kept answers.
#   cmake -DROOT=... -P readme_programs.cmake
cmake_minimum_required(VERSION 3.25)

# What the words of the table's last column stand for: the id that fails.
set(words
    "moments do not balance=level3/moment_balance"
    "work round a loop even with one stiffness=level3/loop_one"
    "work round loops=level3/loop_three"
    "[0-9]+ % of a loop's energy lost or won with one stiffness=level3/loop_one"
    "[0-9]+ % round a loop of turns and moves=level3/loop_six"
    "loads depend on the bodies' masses: no force law=level3/masses"
    "a quarter of the stiffness=level1/stiffness"
    "the order of the bodies matters=level3/body_order"
    "ends at 90 degrees=level4/range")
set(numbers none one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen
    seventeen eighteen nineteen twenty)

# table_of(<text>): the rows, with | and ; replaced, which are CMake's own.
function(table_of result text)
  string(REGEX MATCH "\\| program \\| its joint \\|[^\n]*\n(\\|[^\n]*\n)+" table "${text}")
  string(REPLACE ";" "," table "${table}")
  string(REGEX MATCHALL "[^\n]+" rows "${table}")
  list(LENGTH rows count)
  if(count LESS 5)
    message(FATAL_ERROR "readme_programs: README.md has no table of programs")
  endif()
  list(REMOVE_AT rows 0 1)
  set(${result} "${rows}" PARENT_SCOPE)
endfunction()

# id_of(<result> <phrase>): the id that these words stand for, or nothing.
function(id_of result phrase)
  set(${result} "" PARENT_SCOPE)
  foreach(pair IN LISTS words)
    string(REGEX MATCH "^(.*)=([^=]*)$" _ "${pair}")
    set(pattern "${CMAKE_MATCH_1}")
    set(id "${CMAKE_MATCH_2}")
    if(phrase MATCHES "^${pattern}$")
      set(${result} "${id}" PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

# wrong_in(<result> <README> <verdicts>): what the table says otherwise than the verdicts.
function(wrong_in result readme verdicts)
  set(wrong "")
  table_of(rows "${readme}")
  foreach(row IN LISTS rows)
    string(REGEX MATCH "^\\| ([^|]*) \\| ([^|]*) \\| ([^|]*) \\|$" _ "${row}")
    set(phrases "${CMAKE_MATCH_3}")
    string(REGEX MATCHALL "`[a-z0-9_]+`" joints "${CMAKE_MATCH_2}")
    string(REPLACE ", " ";" phrases "${phrases}")
    if(NOT joints OR NOT phrases)
      list(APPEND wrong "cannot be read: ${row}")
    endif()
    foreach(joint IN LISTS joints)
      string(REPLACE "`" "" joint "${joint}")
      string(REGEX MATCHALL "\n[a-z0-9_]+\t${joint}\t[^\n]*" cases "${verdicts}")
      if(NOT cases)
        list(APPEND wrong "${joint}: no program is told that")
      endif()
      foreach(phrase IN LISTS phrases)
        id_of(id "${phrase}")
        if(NOT id)
          list(APPEND wrong "'${phrase}' stands for no id of a check")
        elseif(NOT "${cases} " MATCHES "[\t ]${id}[ \n;]")
          list(APPEND wrong "${joint}: '${phrase}', but ${id} holds")
        endif()
      endforeach()
    endforeach()
  endforeach()
  set(${result} "${wrong}" PARENT_SCOPE)
endfunction()

file(READ "${ROOT}/README.md" readme)
file(READ "${ROOT}/verify/programs/verdicts.tsv" verdicts)

# The check itself: a row that praises, one that blames, a joint that no program has.
foreach(change IN ITEMS "moments do not balance=loads depend on the bodies' masses: no force law" "`dart_free`=`dart_fre`"
        "a quarter of the stiffness=half of the stiffness")
  string(REGEX MATCH "^(.*)=(.*)$" _ "${change}")
  string(REPLACE "${CMAKE_MATCH_1}" "${CMAKE_MATCH_2}" changed "${readme}")
  wrong_in(found "${changed}" "${verdicts}")
  if(changed STREQUAL readme OR NOT found)
    message(FATAL_ERROR "readme_programs: does not see '${change}'")
  endif()
endforeach()

wrong_in(wrong "${readme}" "${verdicts}")

# "Nineteen joints of nine real programs": cases, and first words of their programs.
string(REGEX MATCHALL "\n[a-z0-9_]+\t" cases "${verdicts}")
list(LENGTH cases joints)
set(programs "")
foreach(case IN LISTS cases)
  string(STRIP "${case}" case)
  file(READ "${ROOT}/reference/data/programs/${case}.json" answers)
  string(JSON program GET "${answers}" header program)
  string(REGEX MATCH "^[A-Za-z]+" program "${program}")
  list(APPEND programs "${program}")
endforeach()
list(REMOVE_DUPLICATES programs)
list(LENGTH programs count)
list(GET numbers ${joints} joints)
list(GET numbers ${count} count)
set(said "${joints} joints of ${count} real programs")
string(TOLOWER "${readme}" lower)
string(FIND "${lower}" "${said}" found)
if(found EQUAL -1)
  list(APPEND wrong "README.md does not say '${said}'")
endif()
if(wrong)
  list(JOIN wrong "\n" wrong)
  message(FATAL_ERROR "README.md's table of programs:\n${wrong}")
endif()
