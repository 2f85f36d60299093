// How a batch runs must not change what it returns: any number of joints, threads, stores past the
// caches, shared laws, mixtures.
#include "halfway/batch/plan.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/studies/kernels/batch.hpp"

#include <fmt/format.h>

#include <cstring>
#include <utility>

namespace halfway::verify {
namespace {

using batch::Batch, batch::Isa, batch::LawForm, batch::Options, batch::Output, batch::Streaming;
using Tables = BatchTables<double>;

/// A number no kernel makes: what it lies on was not written.
constexpr double kCanary = -7.25e77;

void fill(batch::Table<double>& t) {
  const auto c = t.columns();
  std::fill_n(c.first, c.size, kCanary);
}

/// Bits that differ in the first `count` joints, and canaries lost beyond.
int differences(batch::Table<double>& value, batch::Table<double>& expected, long count) {
  int out = 0;
  for (int row = 0; row < value.rows(); ++row) {
    for (long i = 0; i < value.columns().stride; ++i) {
      const double wanted = i < count ? expected(row, i) : kCanary;
      const double got = tapped(value(row, i));
      out += std::memcmp(&got, &wanted, sizeof wanted) != 0;
    }
  }
  return out;
}

/// The same call with other options, into fresh tables; `count` of the joints.
int changed_by(const std::vector<BatchJoint>& joints, Isa isa, Output output, long count,
               const Options& options) {
  Tables expected = tables_of(joints, output), value = tables_of(joints, output);
  const Batch batch(expected.model, isa);
  if (!batch.has<double>(output)) return 0;
  batch.evaluate(expected.joints(), expected.results(), output);
  fill(value.loads), fill(value.tangent);
  auto in = value.joints();
  in.count = count;
  batch.evaluate(in, value.results(), output, options);
  int out = differences(value.loads, expected.loads, count);
  if (output != Output::residual) out += differences(value.tangent, expected.tangent, count);
  return out;
}

template <class Measure>
Finding over_isas(const std::string& name, const std::string& reason, const Measure& measure) {
  int wrong = 0;
  for (const Isa isa : kIsas) {
    if (!batch::available(isa)) continue;
    for (const Kind kind : kKinds) {
      for (const Output output : {Output::residual, Output::tangent, Output::product}) {
        wrong += measure(isa, kind, output);
      }
    }
  }
  return counted(name, wrong, reason);
}

Finding remainders() {
  return over_isas("remainders", "N = 0 to 40: bit for bit as in one batch of 40, nothing written beyond",
                   [](Isa isa, Kind kind, Output output) {
                     const auto joints = repeated(kind, 40);
                     int wrong = 0;
                     for (int n = 0; n <= 40; ++n) wrong += changed_by(joints, isa, output, n, {});
                     return wrong;
                   });
}

Finding threads() {
  return over_isas("threads", "1, 2, 3 and 7 threads: bit for bit", [](Isa isa, Kind kind, Output output) {
    const auto joints = repeated(kind, 1001);
    int wrong = 0;
    for (const int n : {2, 3, 7}) wrong += changed_by(joints, isa, output, 1001, {.threads = n});
    return wrong;
  });
}

Finding streaming() {
  return over_isas("streaming", "stores past the caches: bit for bit", [](Isa isa, Kind kind, Output output) {
    return changed_by(repeated(kind, 301), isa, output, 301, {.streaming = Streaming::always});
  });
}

/// Numbers of compressed tangents that differ from those of 40 joints in one call, or lie beyond the blocks.
int compressed_differences(Isa isa, Kind kind, bool ends, long count, const Options& options) {
  Tables tables = tables_of(repeated(kind, 40), Output::tangent);
  const Batch batch(tables.model, isa);
  const int rows = Batch::compressed_rows(tables.model);
  const auto evaluated = [&](long n, const Options& with) {
    batch::Table<double> blocks(rows, 48);  // as one array
    fill(blocks);
    auto in = tables.joints();
    in.count = n;
    if (!ends) in.a = in.b = nullptr;
    batch.evaluate(in, {tables.loads.columns(), blocks.columns()}, Output::compressed, with);
    const auto c = blocks.columns();
    return std::vector<double>(c.first, c.first + c.size);
  };
  const std::vector<double> all = evaluated(40, {}), some = evaluated(count, options);
  int wrong = 0;
  for (long k = 0; k < long(some.size()); ++k) {
    const long joint = k / (8 * rows) * 8 + k % 8;
    wrong += tapped(some[k]) != (joint < count ? all[k] : kCanary);
  }
  return wrong;
}

Finding compressed() {
  int wrong = 0;
  for (const Isa isa : kIsas) {
    if (!batch::available(isa)) continue;
    for (const Kind kind : kKinds) {
      for (const bool ends : {false, true}) {
        for (const long n : {0, 1, 7, 8, 9, 15, 37, 40})
          wrong += compressed_differences(isa, kind, ends, n, {}) +
                   compressed_differences(isa, kind, ends, n, {.streaming = Streaming::always});
        wrong += compressed_differences(isa, kind, ends, 37, {.threads = 3});
      }
    }
  }
  return counted("compressed", wrong,
                 "some joints, in threads, past the caches: bit for bit as in one batch, and no more");
}

/// One law for all, against that law per joint.
Finding shared_law() {
  return over_isas("shared_law", "the same numbers per joint: bit for bit",
                   [](Isa isa, Kind kind, Output output) {
                     auto joints = repeated(kind, 37);
                     for (BatchJoint& j : joints) j.spec.law = joints[0].spec.law;
                     Tables each = tables_of(joints, output), one = tables_of(joints, output);
                     const Batch batch(each.model, isa);
                     if (!batch.has<double>(output)) return 0;
                     batch.evaluate(each.joints(), each.results(), output);
                     fill(one.loads), fill(one.tangent);
                     auto in = one.joints();
                     in.law_per_joint = false;
                     batch.evaluate(in, one.results(), output);
                     return differences(one.loads, each.loads, 37) +
                            (output == Output::residual ? 0 : differences(one.tangent, each.tangent, 37));
                   });
}

/// Every formulation and kind in one plan, shuffled, against a batch of one joint each.
Finding mixed() {
  std::vector<batch::Member> members;
  std::vector<BatchJoint> joints;
  for (const Entry& entry : reference::formulations()) {
    if (!Batch::knows(entry.name)) continue;
    for (const Kind kind : kKinds) {
      members.push_back({{std::string(entry.name), kind, LawForm::linear, entry.probe.xi, entry.probe.length,
                          entry.probe.axis},
                         0});
      joints.push_back(repeated(kind, 4)[3]);
    }
  }
  const int kinds = int(members.size()), count = 7 * kinds;
  std::vector<int> of_joint(count);
  for (int i = 0; i < count; ++i) of_joint[i] = (i * 5) % kinds;
  const batch::Plan plan(members, of_joint);
  batch::Table<double> q_a(4, count), q_b(4, count), x_a(3, count), x_b(3, count), law(21, count),
      loads(9, count), tangent(81, count), back(9, count), tangent_back(81, count);
  const batch::EndPair<double> ends{{{0.3, -0.2, 0.1}, {0.5, 0.5, 0.5, 0.5}}, {{0, 0.1, 0.2}, {1, 0, 0, 0}}};
  for (int k = 0; k < count; ++k) {
    const BatchJoint& j = joints[of_joint[plan.order()[k]]];
    const Tables one(invariant(), {j}, LawForm::linear, true, 1);
    for (int c = 0; c < 4; ++c) q_a(c, k) = one.q_a(c, 0), q_b(c, k) = one.q_b(c, 0);
    for (int c = 0; c < 3; ++c) x_a(c, k) = one.x_a(c, 0), x_b(c, k) = one.x_b(c, 0);
    for (int c = 0; c < one.law.rows(); ++c) law(c, k) = one.law(c, 0);
  }
  batch::Joints<double> in;
  in.count = count, in.law_per_joint = true;
  in.q_a = std::as_const(q_a).columns(), in.q_b = std::as_const(q_b).columns();
  in.x_a = std::as_const(x_a).columns(), in.x_b = std::as_const(x_b).columns(),
  in.law = std::as_const(law).columns();
  plan.evaluate(in, {loads.columns(), tangent.columns()}, Output::tangent, std::span(&ends, 1));
  plan.restore<double>(9, std::as_const(loads).columns(), back.columns());
  plan.restore<double>(81, std::as_const(tangent).columns(), tangent_back.columns());

  int wrong = plan.count() != count;
  for (int i = 0; i < count; ++i) {
    const batch::Model& model = members[of_joint[i]].model;
    Tables one(invariant(), {joints[of_joint[i]]}, LawForm::linear, true, 81);
    auto single = one.joints();
    single.a = &ends.a, single.b = &ends.b;
    Batch(model).evaluate(single, one.results(), Output::tangent);
    for (int r = 0; r < batch::load_rows(model.kind); ++r) wrong += tapped(back(r, i)) != one.loads(r, 0);
    for (int r = 0; r < batch::tangent_rows(model.kind, Output::tangent); ++r)
      wrong += tangent_back(r, i) != one.tangent(r, 0);
  }
  return counted("mixed", wrong, "all formulations and kinds in one plan: each joint bit for bit as alone");
}

}  // namespace

void batch_running(Checks& checks) {
  const auto add = [&](const char* name, Finding (*measure)()) {
    checks.push_back({std::string("batch/") + name, "batch", [measure] { return std::vector{measure()}; }});
  };
  add("remainders", remainders);
  add("threads", threads);
  add("streaming", streaming);
  add("shared_law", shared_law);
  add("compressed", compressed);
  add("mixed", mixed);
}

}  // namespace halfway::verify
