// Makes a JointUnderTest of a form written as a template over the scalar (reference/truth/closed_forms.hpp,
// mutants/).
#pragma once

#include "reference/truth/closed_forms.hpp"
#include "verify/oracle/measures.hpp"

namespace halfway::verify {

/// Form offers loads<T>(spec, a, b); optionally tangent<T>(spec, a, b), 12x12, and energy<T>(spec, a, b).
template <class Form>
JointUnderTest twin() {
  const auto evaluate = []<class T>(const JointSpec& spec, const Pose<T>& a, const Pose<T>& b,
                                    bool with_tangent) {
    NodeLoads<T> out;
    out.q = Form::template loads<T>(spec, a, b);
    if constexpr (requires { Form::template tangent<T>(spec, a, b); }) {
      if (with_tangent) out.tangent = Form::template tangent<T>(spec, a, b);
    }
    return out;
  };
  JointUnderTest joint;
  joint.loads = [=](const JointSpec& s, const Pose<Real50>& a, const Pose<Real50>& b, bool with_tangent) {
    return evaluate(s, a, b, with_tangent);
  };
  joint.dual_loads = [=](const JointSpec& s, const Pose<Dual50>& a, const Pose<Dual50>& b,
                         bool with_tangent) { return evaluate(s, a, b, with_tangent); };
  joint.dual_energy = [](const JointSpec& s, const Pose<Dual50>& a,
                         const Pose<Dual50>& b) -> std::optional<Dual50> {
    if constexpr (requires { Form::template energy<Dual50>(s, a, b); })
      return Form::template energy<Dual50>(s, a, b);
    else
      return std::nullopt;
  };
  return joint;
}

}  // namespace halfway::verify
