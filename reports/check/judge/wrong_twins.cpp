#include "reports/check/judge/wrong_twins.hpp"

#include "reference/programs/joints.hpp"
#include "verify/oracle/mutants/forms.hpp"

namespace halfway::check {
namespace {

namespace wrong = verify::wrong;
using reference::Ask;
using reference::TwelveLoads;

/// A wrong half-way joint of the rotation vector.
template <class Parts>
reference::Candidate twin(const char* name) {
  return {name, [](const Ask& ask) -> TwelveLoads {
            const auto s = reference::situation<double>(ask);
            return wrong::Projected<Parts>::template loads<double>(reference::joint_spec(s), s.a, s.b);
          }};
}

}  // namespace

std::vector<reference::Candidate> wrong_twins() {
  return {twin<wrong::HalfRate>(
              "invariant, but half rate: its frame turns at half the sum of the spins, so the force acts "
              "in the middle"),
          twin<wrong::ProjectedWithNodeA>(
              "invariant, but projected with node a (MBDyn's invariant deformable joint)"),
          twin<wrong::TransposedFrame>("invariant, but with its half-way frame transposed"),
          twin<wrong::SpinNotTransposed>("invariant, but with the spin of its frame not transposed"),
          twin<wrong::OffsetWithoutArm>("invariant, but without the arm of b's force"),
          twin<wrong::OffsetCarriedByNodeA>("invariant, but with b's offset carried by node a"),
          twin<wrong::NoArmMoment>("invariant, but with equal and opposite moments at both joint points")};
}

}  // namespace halfway::check
