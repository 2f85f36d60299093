# Flags of our own targets, halfway_flags, and their precompiled headers.
# -ffp-contract=off keeps rounding the same on every machine.
add_library(halfway_flags INTERFACE)
target_compile_options(halfway_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -ffp-contract=off
                       -fno-math-errno $<$<BOOL:${HALFWAY_WERROR}>:-Werror>)
target_include_directories(halfway_flags INTERFACE "${PROJECT_SOURCE_DIR}")
# GCC 12 reports an impossible overlap inside std::string's operator+ (its bug 105651).
target_compile_options(halfway_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
# Eigen, JSON and the standard library are half of a small unit's compile time: precompiled once, for all
# targets of the same options (-O1: what nobody times); what is timed has headers of its own.
set(halfway_headers <Eigen/Geometry> <Eigen/LU> <array> <cmath> <functional> <optional> <string> <variant> <vector>)

# What is compiled in one go costs a third of what it does file by file: the front end reads and instantiates
# the same headers once. So names of a folder's files must not clash; a process stays below 1.5 GB.
option(HALFWAY_TOGETHER "Compile the files of a folder together; off, a change costs its own file alone" ON)

# in_groups(<target> <group> <most> <sources...>): together, at most so many at a time.
function(in_groups target group most)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  set(number 0)
  foreach(source IN LISTS ARGN)
    math(EXPR part "${number} / ${most}")
    set_property(SOURCE "${source}" TARGET_DIRECTORY ${target} PROPERTY UNITY_GROUP ${group}_${part})
    math(EXPR number "${number} + 1")
  endforeach()
endfunction()

# Generated units, four to a compilation.
function(compiled_together target)
  in_groups(${target} generated 4 ${ARGN})
endfunction()

# The sources of each folder, six at a time. What has flags of its own stays alone.
function(folders_together target)
  if(NOT HALFWAY_TOGETHER)
    return()
  endif()
  set(folders "")
  foreach(source IN LISTS ARGN)
    cmake_path(GET source PARENT_PATH folder)
    string(REPLACE "${PROJECT_SOURCE_DIR}/" "" folder "${folder}")
    string(MAKE_C_IDENTIFIER "${folder}" folder)
    list(APPEND folders ${folder})
    list(APPEND of_${folder} "${source}")
  endforeach()
  list(REMOVE_DUPLICATES folders)
  foreach(folder IN LISTS folders)
    in_groups(${target} ${folder} 6 ${of_${folder}})
  endforeach()
endfunction()

option(HALFWAY_WERROR "Treat warnings as errors" OFF)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
file(GENERATE OUTPUT "${PROJECT_BINARY_DIR}/generated/headers.cpp" CONTENT "// Compiled for its precompiled header alone.\n")
function(common_headers target)
  add_library(${target} OBJECT "${PROJECT_BINARY_DIR}/generated/headers.cpp")
  target_link_libraries(${target} PRIVATE formulations fmt::fmt nlohmann_json::nlohmann_json halfway_flags)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  target_precompile_headers(${target} PRIVATE ${halfway_headers} <fmt/format.h> ${ARGN})
endfunction()
# JSON apart: its parser is instantiated in every unit that sees it, half a second each.
common_headers(headers)
common_headers(headers_and_json <nlohmann/json.hpp>)
