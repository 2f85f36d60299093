# Writes TO/advice_page_text.cpp: the report's styles and the colours of its laws, for the page of an advice.
#
#   cmake -DTO=... -P embed.cmake
cmake_minimum_required(VERSION 3.20)
set(page "${CMAKE_CURRENT_LIST_DIR}/../../page")

# pieces(<variable> <files...>): literals of C++, each ends at )halfway", which no text has. Modules lose import and export.
function(pieces variable)
  set(out "")
  foreach(file IN LISTS ARGN)
    file(READ "${file}" text)
    if(file MATCHES "\\.js$")
      string(REGEX REPLACE "(^|\n)import [^;]*;" "\\1" text "${text}")
      string(REGEX REPLACE "(^|\n)export " "\\1" text "${text}")
    endif()
    if(text MATCHES "<(/script|!--)|\\)halfway\"|(^|\n)(import|export)[ {]")
      message(FATAL_ERROR "${file}: cannot stand in the page: ${CMAKE_MATCH_0}")
    endif()
    string(APPEND out "R\"halfway(${text})halfway\"\n")
  endforeach()
  set(${variable} "${out}" PARENT_SCOPE)
endfunction()

pieces(style "${page}/styles/style.css" "${page}/styles/tables.css" "${CMAKE_CURRENT_LIST_DIR}/advise.css" "${page}/styles/media.css")
pieces(script "${page}/palette.js" "${CMAKE_CURRENT_LIST_DIR}/advise.js")
file(WRITE "${TO}/advice_page_text.cpp" "// Made by reports/advise/page/embed.cmake.
#include \"reports/advise/views/page.hpp\"

namespace halfway::advise {

std::string_view page_style() { return ${style}; }
std::string_view page_script() { return ${script}; }

}  // namespace halfway::advise
")
