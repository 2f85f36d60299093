# No comment cites a file that is not there: paths are from the top, or as users include them.
#   cmake -DROOT=... -P cited.cmake
cmake_minimum_required(VERSION 3.25)

# cited_but_missing(<result> <text>): the paths in a text that lead nowhere.
function(cited_but_missing result text)
  string(REGEX MATCHALL "[a-z_0-9]+/[a-z_0-9/]*[a-z_0-9]\\.(hpp|cpp|cmake|def|toml|json|md)" paths "${text}")
  set(missing "")
  foreach(path IN LISTS paths)
    if(NOT EXISTS "${ROOT}/${path}" AND NOT EXISTS "${ROOT}/formulations/${path}")
      list(APPEND missing "${path}")
    endif()
  endforeach()
  set(${result} "${missing}" PARENT_SCOPE)
endfunction()

# The check itself: one that is there, one that is not.
cited_but_missing(none "// as halfway/joint.hpp and reference/scene/scene.hpp have it")
cited_but_missing(one "// as verify/checks/no_such_file.cpp has it")
if(none OR NOT one STREQUAL "verify/checks/no_such_file.cpp")
  message(FATAL_ERROR "cited: does not tell a file that is there (${none}) from one that is not (${one})")
endif()

set(wrong "")
foreach(room IN ITEMS formulations reference verify bench reports)
  file(GLOB_RECURSE sources RELATIVE "${ROOT}" "${ROOT}/${room}/*.hpp" "${ROOT}/${room}/*.cpp" "${ROOT}/${room}/*.in")
  foreach(source IN LISTS sources)
    file(STRINGS "${ROOT}/${source}" comments REGEX "//.*/.*\\.")
    list(JOIN comments "\n" comments)
    cited_but_missing(missing "${comments}")
    foreach(path IN LISTS missing)
      list(APPEND wrong "${source}: ${path}")
    endforeach()
  endforeach()
endforeach()
if(wrong)
  list(JOIN wrong "\n  " text)
  message(FATAL_ERROR "cited, but not there:\n  ${text}")
endif()
