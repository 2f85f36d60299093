// What is wrong with a batch or a plan is said by name: joint, field and value.
#include "halfway/batch/plan.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/studies/kernels/batch.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace halfway::verify {
namespace {

using batch::Batch, batch::Isa, batch::LawForm, batch::Output;
using Tables = BatchTables<double>;

/// Spoilt calls of a plan of three joints of two kinds: each is refused by name.
int refused_plans() {
  const std::vector<batch::Member> members = {{{.formulation = "invariant"}},
                                              {{.formulation = "conformal", .kind = Kind::linear}}};
  const std::vector<int> of_joint = {0, 1, 0};
  const batch::Plan plan(members, of_joint);
  batch::Table<double> q(4, 3), x(3, 3), law(6, 3), loads(9, 3), tangent(81, 3);  // zeros
  for (int k = 0; k < 3; ++k) q(0, k) = law(0, k) = law(3, k) = law(5, k) = 1;
  batch::Joints<double> good;
  good.count = 3, good.law_per_joint = true;
  good.q_a = good.q_b = std::as_const(q).columns(), good.x_a = good.x_b = std::as_const(x).columns();
  good.law = std::as_const(law).columns();
  const batch::Results<double> results{loads.columns(), tangent.columns()};
  const auto refused = [&](auto&& spoil, std::initializer_list<const char*> words) {
    batch::Joints<double> in = good;
    batch::Results<double> out = results;
    spoil(in, out);
    return silent([&] { batch::validate(plan, in, out, Output::tangent); }, words);
  };
  using In = batch::Joints<double>;
  using Out = batch::Results<double>;
  int wrong = 1 - refused([](In&, Out&) {}, {});
  wrong +=
      refused([](In&, Out& out) { out.tangent = {}; }, {"joints 0 to 1", "invariant", "tangent is missing"});
  wrong +=
      refused([](In&, Out& out) { out.tangent.size = 80 * out.tangent.stride; }, {"conformal", "tangent"});
  wrong += refused([](In& in, Out&) { in.count = 4; }, {"4", "3"});
  wrong += refused([](In& in, Out&) { in.law_per_joint = false; }, {"law_per_joint"});
  q(0, 2) = 2;
  wrong += refused([](In&, Out&) {}, {"joints 2 to 2", "conformal", "length"});
  q(0, 2) = 1;
  const std::vector<batch::Member> with_ends = {{{.formulation = "invariant"}, 1}};
  const batch::Plan unended(with_ends, std::vector<int>{0, 0, 0});
  wrong += silent([&] { batch::validate(unended, good, results, Output::tangent); }, {"ends 1"});
  return wrong;
}

int refused(const std::function<void(Tables&, batch::Joints<double>&)>& spoil,
            std::initializer_list<const char*> words) {
  Tables t = tables_of(repeated(Kind::linear, 20), Output::tangent);
  batch::Joints<double> in = t.joints();
  spoil(t, in);
  return silent([&] { batch::validate(t.model, in, t.results(), Output::tangent); }, words);
}

Finding refusals() {
  using In = batch::Joints<double>;
  static constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  int wrong = 1 - refused([](Tables&, In&) {}, {});  // nothing wrong: nothing said
  wrong += refused([](Tables& t, In&) { t.q_b(2, 13) *= 1.5; }, {"joint 13", "q_b", "length"});
  wrong += refused([](Tables& t, In&) { t.x_a(1, 5) = kNan; }, {"joint 5", "x_a[1]", "nan"});
  wrong += refused([](Tables& t, In&) { t.law(4, 19) = HUGE_VAL; }, {"joint 19", "law[4]", "inf"});
  wrong += refused([](Tables&, In& in) { in.q_a.size = 11; }, {"q_a", "11"});
  wrong += refused([](Tables&, In& in) { in.x_b.first = nullptr; }, {"x_b", "missing"});
  wrong += refused([](Tables&, In& in) { in.b = nullptr; }, {"one node alone"});
  wrong += refused([](Tables& t, In&) { t.model.xi = kNan; }, {"xi", "nan"});
  Tables t = tables_of(repeated(Kind::linear, 20), Output::compressed);
  const batch::Results<double> one_short{t.loads.columns(), {t.tangent.columns().first, 0, 24 * 21 - 1}};
  wrong += silent([&] { batch::validate(t.model, t.joints(), one_short, Output::compressed); },
                  {"tangent", "503", "504"});
  t.model.formulation = "chrono_body";
  wrong += silent([&] { batch::validate(t.model, t.joints(), t.results(), Output::compressed); },
                  {"chrono_body", "balanced"});
  wrong += silent([] { Batch({.formulation = "invarient"}); }, {"invarient", "invariant"});
  wrong += silent([] { Batch({.formulation = "intrinsic"}); }, {"intrinsic", "xi"});
  wrong += silent([] { Batch({.formulation = "rod34"}); }, {"rod34", "length"});
  wrong += silent([] { Batch({.formulation = "rod34", .length = -1}); }, {"rod34", "length"});
  wrong += silent([] { Batch({.formulation = "rod34", .length = 1, .axis = 4}); }, {"rod34", "axis"});
  wrong += refused_plans();
  for (const Isa isa : kIsas) {
    if (!batch::available(isa)) wrong += silent([&] { batch::choose(isa); }, {batch::to_string(isa), "sse2"});
  }
  const char* const kept = std::getenv("HALFWAY_ISA");
  const std::string before = kept == nullptr ? "" : kept;
  setenv("HALFWAY_ISA", "mmx", 1);
  wrong += silent([] { batch::choose({}); }, {"HALFWAY_ISA", "mmx", "sse2"});
  setenv("HALFWAY_ISA", "sse2", 1);
  wrong += batch::choose({}) != Isa::sse2;
  kept == nullptr ? unsetenv("HALFWAY_ISA") : setenv("HALFWAY_ISA", before.c_str(), 1);
  return counted("refusals", wrong, "each spoilt input is refused, joint, field and value named");
}

}  // namespace

void batch_refusals(Checks& checks) {
  checks.push_back({"batch/refusals", "kernels", [] { return std::vector{refusals()}; }});
}

}  // namespace halfway::verify
