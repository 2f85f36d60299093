// The textbook transcription of the paper against which a fast joint is measured.
#include "bench/questions/methods/textbook.hpp"

#include "bench/harness/check.hpp"
#include "bench/questions/methods/problem.hpp"

#include <memory>

namespace halfway::bench {

Cases textbook_cases();

namespace {

using textbook::Frame;
using textbook::Properties;

Properties properties(const reference::JointSpec& spec) {
  return {std::get<reference::LinearSpec>(spec.law).matrix, spec.a, spec.b};
}

/// What is checked and what is timed, compiled once.
template <Kind kind, Frame frame, bool with_tangent>
[[gnu::noinline]] auto textbook_loads(const Properties& joint, const Pose<double>& a, const Pose<double>& b) {
  if constexpr (kind == Kind::angular)
    return textbook::angular<frame, with_tangent>(joint, a, b);
  else
    return textbook::linear<frame, with_tangent>(joint, a, b);
}

/// Loads and tangent against 50 digits to the limit of every case, at the timed poses; then by range of phi,
/// where (1 - cos phi)/phi^2 and (phi - sin phi)/phi^3 cancel.
template <Kind kind, Frame frame, bool with_tangent>
Checked check_textbook(const std::string& formulation, const Inputs& in) {
  const auto values = [](const Inputs& poses) {
    const Properties joint = properties(poses.spec);
    std::vector<Evaluated> out;
    for (std::size_t i = 0; i < poses.a.size(); ++i) {
      out.push_back(
          evaluated<with_tangent>(textbook_loads<kind, frame, with_tangent>(joint, poses.a[i], poses.b[i])));
    }
    return out;
  };
  Checked checked = compare(formulation, in, values(in));
  for (ErrorAt range : phi_ranges()) {
    const Inputs there = moved_into(in, range);
    range.error = compare(formulation, there, values(there)).error;
    checked.errors.push_back(range);
  }
  return checked;
}

template <Kind kind, Frame frame, bool with_tangent>
Case textbook_case(const std::shared_ptr<const Inputs>& in) {
  Case c;
  c.formulation = frame == Frame::attached ? "attached_a" : "invariant";
  c.kind = to_string(kind);
  c.what = with_tangent ? "residual_tangent" : "residual";
  c.implementation = "textbook";
  c.name = c.formulation + '/' + c.kind + '/' + c.what + "/textbook";
  c.evaluations = kPoses;
  c.check = [in, name = c.formulation] { return check_textbook<kind, frame, with_tangent>(name, *in); };
  c.timed = [in](benchmark::State& state) {
    const Properties joint = properties(in->spec);
    for (auto _ : state) {
      for (int i = 0; i < kPoses; ++i) {
        auto result = textbook_loads<kind, frame, with_tangent>(joint, in->a[i], in->b[i]);
        benchmark::DoNotOptimize(result);
      }
    }
  };
  return c;
}

template <Kind kind>
void add_cases(Cases& cases) {
  const auto in = std::make_shared<const Inputs>(inputs(kind, {}, false));
  cases.push_back(textbook_case<kind, Frame::attached, false>(in));
  cases.push_back(textbook_case<kind, Frame::attached, true>(in));
  cases.push_back(textbook_case<kind, Frame::halfway, false>(in));
  cases.push_back(textbook_case<kind, Frame::halfway, true>(in));
}

}  // namespace

Cases textbook_cases() {
  Cases cases;
  add_cases<Kind::angular>(cases);
  add_cases<Kind::linear>(cases);
  return cases;
}

}  // namespace halfway::bench
