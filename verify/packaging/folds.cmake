# Fails where an error could be folded by something that forgets a NaN: std::max, maxCoeff and their like, in the rooms
# where errors are measured. Errors fold by include(), keep_largest(), larger() and largest_entry() of
# reference/record/worst.hpp. What is no error (a count, an angle, a stiffness) is named below, by file and text.
#   cmake -DROOT=... -P folds.cmake
cmake_minimum_required(VERSION 3.25)
set(forgetful "std::f?max[ ({<,;]|max_element|maxCoeff|lpNorm<Eigen::Infinity>|minmax")
set(named
    "verify/studies/newton/newton_order.cpp|std::max<std::size_t>(2, steps / 3)"
    "verify/studies/limits/large_rotation.cpp|stiffness().maxCoeff()"
    "verify/studies/limits/random_scene.cpp|largest = k.maxCoeff()"
    "verify/studies/kernels/batch_tables.cpp|std::max(1, batch::tangent_rows"
    "verify/studies/kernels/batch_tables.cpp|std::numbers::pi - std::max("
    "verify/studies/kernels/batches.cpp|std::max(1, batch::tangent_rows"
    "verify/studies/kernels/kernel_polynomials.cpp|share = std::max(1e-6,"
    "verify/studies/oracle/counting.cpp|using std::atan2, std::fma, std::max"
    "verify/oracle/fe_access.cpp|relative.topRightCorner<3, 3>().cwiseAbs().maxCoeff()"
    "reference/solve/dynamics/scenarios.cpp|squares.maxCoeff()"
    "reference/solve/dynamics/drift.cpp|inertia.maxCoeff()"
    "reference/solve/dynamics/drift.cpp|std::max(1, int(std::ceil("
    "reference/solve/dynamics/drift.cpp|std::max(1, per_period"
    "reference/solve/free_directions.cpp|K.diagonal().segment<3>(i).maxCoeff()"
    "reference/solve/free_directions.cpp|free.col(i).cwiseAbs().maxCoeff()"
    "bench/questions/batch/problem.cpp|tangent_(std::max(1, batch::tangent_rows"
    "reports/views/speed_targets.cpp|std::max(t.threads, 1)"
    "reports/views/cheapest.cpp|max_element(all, {}, rank)")

set(violations "")
set(count 0)
foreach(room IN ITEMS verify reference/solve bench/harness bench/questions reports/views reports/tests)
  file(GLOB_RECURSE sources RELATIVE "${ROOT}" "${ROOT}/${room}/*.cpp" "${ROOT}/${room}/*.hpp" "${ROOT}/${room}/*.in")
  foreach(source IN LISTS sources)
    math(EXPR count "${count} + 1")
    file(STRINGS "${ROOT}/${source}" lines REGEX "${forgetful}")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "//.*" "" code "${line}")
      if(NOT code MATCHES "${forgetful}")
        continue()
      endif()
      set(is_named FALSE)
      foreach(name IN LISTS named)
        string(REPLACE "|" ";" name "${name}")
        list(GET name 0 file)
        list(GET name 1 text)
        string(FIND "${code}" "${text}" at)
        if(source STREQUAL file AND NOT at EQUAL -1)
          set(is_named TRUE)
        endif()
      endforeach()
      if(NOT is_named)
        string(STRIP "${code}" code)
        list(APPEND violations "${source}: ${code}")
      endif()
    endforeach()
  endforeach()
endforeach()

if(count EQUAL 0)
  message(FATAL_ERROR "no source was read below ${ROOT}")
endif()
if(violations)
  list(JOIN violations "\n  " text)
  message(FATAL_ERROR "these may forget a NaN (see reference/record/worst.hpp):\n  ${text}")
endif()
message(STATUS "${count} sources fold their errors by what keeps a NaN")
