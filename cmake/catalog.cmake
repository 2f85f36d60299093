# Reads formulations/catalog.def: one generated unit per line and question (reference, bench), so a
# new formulation needs no other edit, and changing one rebuilds only its own units.
set(catalog_file "${PROJECT_SOURCE_DIR}/formulations/catalog.def")
set(catalog_extra "" CACHE FILEPATH "Further catalog lines, for trying a formulation out of tree")
set_property(DIRECTORY "${PROJECT_SOURCE_DIR}" APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${catalog_file}" ${catalog_extra})

set(CATALOG_TYPES "")
foreach(file IN ITEMS "${catalog_file}" ${catalog_extra})
  file(STRINGS "${file}" lines REGEX "^HALFWAY_FORMULATION")
  foreach(line IN LISTS lines)
    if(NOT line MATCHES "^HALFWAY_FORMULATION\\(([A-Za-z0-9_]+), ([a-z0-9_/.]+)\\)$")
      message(FATAL_ERROR "${file}: cannot read '${line}'; expected HALFWAY_FORMULATION(Type, path/header.hpp)")
    endif()
    list(APPEND CATALOG_TYPES "${CMAKE_MATCH_1}")
    set(CATALOG_HEADER_${CMAKE_MATCH_1} "${CMAKE_MATCH_2}")
  endforeach()
endforeach()

# catalog_units(<result> <template.in> <prefix>): configures one unit per formulation with @TYPE@, @HEADER@.
function(catalog_units result template prefix)
  set(units "")
  foreach(TYPE IN LISTS CATALOG_TYPES)
    set(HEADER "formulations/${CATALOG_HEADER_${TYPE}}")
    set(unit "${PROJECT_BINARY_DIR}/generated/${prefix}_${TYPE}.cpp")
    configure_file("${template}" "${unit}" @ONLY)
    list(APPEND units "${unit}")
  endforeach()
  set(${result} ${units} PARENT_SCOPE)
endfunction()

# catalog_list(<result> <template.in> <file>): one unit with @DECLARATIONS@ and @ENTRIES@ made of
# "<declaration> <function>_<Type>();" and "<function>_<Type>,".
function(catalog_list result template declaration function file)
  set(DECLARATIONS "")
  set(ENTRIES "")
  foreach(TYPE IN LISTS CATALOG_TYPES)
    string(APPEND DECLARATIONS "${declaration} ${function}_${TYPE}();\n")
    string(APPEND ENTRIES "      ${function}_${TYPE}(),\n")
  endforeach()
  set(unit "${PROJECT_BINARY_DIR}/generated/${file}")
  configure_file("${template}" "${unit}" @ONLY)
  set(${result} "${unit}" PARENT_SCOPE)
endfunction()
