# Misuse of the library gets one sentence that says what is wrong, as the first error of the compiler.
#   cmake -DCXX=... -DINCLUDE=... -DEIGEN=... -DWORK=... -P misuse.cmake
cmake_minimum_required(VERSION 3.25)
file(MAKE_DIRECTORY "${WORK}")
set(wrong "")
# Read once for all programs: they are ten lines each.
set(compiler "${CXX}" -std=c++20 -Wall -Wextra -Werror "-I${INCLUDE}" -isystem "${EIGEN}")
file(WRITE "${WORK}/library.hpp" "#include <halfway/joint.hpp>
#include <halfway/joint/formulation.hpp>
#include <halfway/systems/intrinsic.hpp>
")
execute_process(COMMAND ${compiler} -x c++-header "${WORK}/library.hpp" -o "${WORK}/library.hpp.gch"
                COMMAND_ERROR_IS_FATAL ANY)

# misuse(<name> <sentence> <body of main> [options]): the sentence has to stand in the first error; without a
# sentence the program has to compile without a warning.
function(misuse name sentence body)
  file(WRITE "${WORK}/${name}.cpp" "using namespace halfway;
template <Kind kind, class T, class F, int N>
using With = Joint<kind, T, F, LinearLaw<T, N>>;
int main() {
  const auto law3 = isotropic_law(1.0);
  const auto law6 = orthotropic_law<double, 6>({1, 2, 3, 4, 5, 6});
  const Pose<double> a, b;
  ${body}
  (void)law3, (void)law6, (void)a, (void)b;
}
")
  execute_process(COMMAND ${compiler} ${ARGN} -fsyntax-only -include "${WORK}/library.hpp" "${WORK}/${name}.cpp"
                  RESULT_VARIABLE failed ERROR_VARIABLE said)
  string(REGEX MATCH "error: [^\n]*" first "${said}")
  string(FIND "${first}" "${sentence}" found)
  if((sentence AND found EQUAL -1) OR (NOT sentence AND failed))
    list(APPEND wrong "${name}: expected '${sentence}', the compiler said: ${first}")
    set(wrong "${wrong}" PARENT_SCOPE)
  endif()
endfunction()

misuse(none "" "const With<Kind::linear_angular, double, Invariant, 6> joint{.law = law6};
  (void)loads<true>(joint, a, b);
  check_formulation<Intrinsic>();")
misuse(cpp17 "halfway needs C++20" "" -std=c++17)
misuse(law_size "the law of a joint takes 3 strains" "const With<Kind::linear_angular, double, Invariant, 3> joint{.law = law3};
  (void)joint;")
misuse(short_list "orthotropic_law<T, N> takes N stiffnesses" "const auto law = orthotropic_law<double, 6>({1, 2, 3});
  (void)law;")
misuse(stress_alone "the law of a joint takes 3 strains" "const auto law = [](const Vec3<double>& e) { return e; };
  const Joint<Kind::angular, double, Invariant, decltype(law)> joint{.law = law};
  (void)joint;")
misuse(no_tangent_said "say loads<true>(joint, a, b)" "const With<Kind::angular, double, Invariant, 3> joint{.law = law3};
  loads(joint, a, b);")
misuse(scalars "joint and poses have one scalar" "const With<Kind::angular, float, Invariant, 3> joint{.law = isotropic_law(1.0f)};
  loads<true>(joint, a, b);")
misuse(no_xi "Intrinsic" "const With<Kind::angular, double, Intrinsic, 3> joint{.law = law3};
  (void)joint;")
misuse(wrong_kind "has no member named" "const With<Kind::angular, double, Invariant, 3> joint{.law = law3};
  (void)loads<true>(joint, a, b).q;")
misuse(no_name "has texts `name` and `stands_for`" "struct Mine : Family<FrameHalfway, RotationVectorMeasure, Projected> {};
  check_formulation<Mine>();")

if(wrong)
  list(JOIN wrong "\n  " text)
  message(FATAL_ERROR "misuse that is not explained:\n  ${text}")
endif()
