# The page of `halfway run` as C++: made of plain files by CMake alone, for the program that writes it is built
# without node. Sets run_page_text, a source.
set(run_page_text "${PROJECT_BINARY_DIR}/generated/run_page_text.cpp")
set(run_page_folder "${CMAKE_CURRENT_LIST_DIR}")
include("${run_page_folder}/parts.cmake")
list(TRANSFORM run_page_styles PREPEND "${run_page_folder}/../" OUTPUT_VARIABLE run_page_files)
foreach(module IN LISTS run_page_modules)
  list(APPEND run_page_files "${run_page_folder}/../${module}")
endforeach()
add_custom_command(OUTPUT "${run_page_text}"
  COMMAND ${CMAKE_COMMAND} "-DTO=${PROJECT_BINARY_DIR}/generated" -P "${run_page_folder}/embed.cmake"
  DEPENDS ${run_page_files} "${run_page_folder}/../template.html" "${run_page_folder}/embed.cmake" "${run_page_folder}/parts.cmake"
  COMMENT "The page of a run" VERBATIM)
