# Writes TO/run.html, the page of a run with @HALFWAY_RUN@ in the place of its data, and TO/run_page_text.cpp, which has
# the same without that mark:
#
#   cmake -DTO=... -P embed.cmake
#
# Modules become one script: each loses its import lines and the word export, so that no two of them may give something at
# their top level the same name, nor import it by another. A block of strict code refuses a name that is there twice.
cmake_minimum_required(VERSION 3.20)
set(page "${CMAKE_CURRENT_LIST_DIR}/..")
include("${CMAKE_CURRENT_LIST_DIR}/parts.cmake")
set(html "")
set(pieces "")

# add(<variable>): its text is the next piece of the page. A literal of C++ ends at )halfway", which no text has.
macro(add variable)
  string(APPEND html "${${variable}}")
  string(APPEND pieces "R\"halfway(${${variable}})halfway\",\n")
endmacro()

# take(<mark>): adds the template up to a mark and drops both.
function(take mark)
  string(FIND "${rest}" "@${mark}@" at)
  if(at LESS 0)
    message(FATAL_ERROR "template.html: no @${mark}@, or not in this order")
  endif()
  string(SUBSTRING "${rest}" 0 ${at} before)
  string(LENGTH "@${mark}@" length)
  math(EXPR at "${at} + ${length}")
  string(SUBSTRING "${rest}" ${at} -1 rest)
  add(before)
  set(html "${html}" PARENT_SCOPE)
  set(pieces "${pieces}" PARENT_SCOPE)
  set(rest "${rest}" PARENT_SCOPE)
endfunction()

file(READ "${page}/template.html" rest)
take(DESCRIPTION)
set(text "One scene, solved with each formulation.")
add(text)
take(TITLE)
set(text "Halfway: a scene")
add(text)
take(STYLE)
foreach(style IN LISTS run_page_styles)
  file(READ "${page}/${style}" text)
  add(text)
endforeach()
take(SUBTITLE)
set(text "one scene, solved with each formulation")
add(text)
take(NOSCRIPT)
set(text "This page draws its charts with JavaScript; the same results are in curve.csv and curve.json.")
add(text)
take(DATA)
set(text "<script type=\"application/json\" id=\"run\">")
add(text)
set(before_data "${pieces}")
set(pieces "")
string(APPEND html "@HALFWAY_RUN@")
set(text "</script>")
add(text)
take(SCRIPT)
set(text "'use strict';\n{\n")
add(text)
foreach(module IN LISTS run_page_modules)
  file(READ "${page}/${module}" text)
  string(REGEX REPLACE "(^|\n)import [^;]*;" "\\1" text "${text}")
  string(REGEX REPLACE "(^|\n)export " "\\1" text "${text}")
  if(text MATCHES "<(/script|!--)|@HALFWAY_RUN@|\\)halfway\"|(^|\n)(import|export)[ {]")
    message(FATAL_ERROR "${module}: cannot stand in the page's script: ${CMAKE_MATCH_0}")
  endif()
  add(text)
endforeach()
set(text "}\n")
add(text)
add(rest)

set(source "// Made by reports/page/run/embed.cmake.
#include \"reports/cli/run/run_page.hpp\"

namespace halfway::reports {
namespace {

constexpr std::string_view kBefore[] = {
${before_data}};
constexpr std::string_view kAfter[] = {
${pieces}};

}  // namespace

std::span<const std::string_view> page_before_data() { return kBefore; }
std::span<const std::string_view> page_after_data() { return kAfter; }

}  // namespace halfway::reports
")
file(WRITE "${TO}/run.html" "${html}")
file(WRITE "${TO}/run_page_text.cpp" "${source}")
