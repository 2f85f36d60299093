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

# Generated units that instantiate the same templates, four to a compilation: their cost is the front end's,
# which then reads them once (0.3 to 0.6 of the seconds; a process stays below 1.5 GB).
function(compiled_together target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  set(number 0)
  foreach(unit IN LISTS ARGN)
    math(EXPR group "${number} / 4")
    set_property(SOURCE "${unit}" TARGET_DIRECTORY ${target} PROPERTY UNITY_GROUP together_${group})
    math(EXPR number "${number} + 1")
  endforeach()
endfunction()

option(HALFWAY_WERROR "Treat warnings as errors" OFF)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
file(GENERATE OUTPUT "${PROJECT_BINARY_DIR}/generated/headers.cpp" CONTENT "// Compiled for its precompiled header alone.\n")
add_library(headers OBJECT "${PROJECT_BINARY_DIR}/generated/headers.cpp")
target_link_libraries(headers PRIVATE formulations fmt::fmt nlohmann_json::nlohmann_json halfway_flags)
target_compile_options(headers PRIVATE $<$<CONFIG:Release>:-O1>)
target_precompile_headers(headers PRIVATE ${halfway_headers} <fmt/format.h> <nlohmann/json.hpp>)
