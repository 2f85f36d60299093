// Batches against the readable transcription at 50 digits: every instruction set of this machine.
#include "verify/oracle/poles.hpp"
#include "verify/studies/kernels/batch.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <vector>

namespace halfway::verify {
namespace {

using batch::Batch, batch::Isa, batch::LawForm, batch::Output;

struct Errors {
  Measurement loads, tangent, product;
};

template <class E, class V>
double miss(const E& exact, const V& value) {
  return double(largest_entry<Real50>((value.template cast<Real50>() - exact).eval()));
}

/// What an error of the tangent is relative to: its largest entry, times what the pose's rounding moves of
/// it where a measure is steep. The tangent holds the rate's own derivative, and of a power of the distance
/// to a pole that grows about twice as fast per rad as the rate. Rotation vectors are never steep: below 0.3.
double tangent_scale(const BatchJoint& j) {
  return double(largest_entry<Real50>(j.exact.tangent)) * larger(1., 2 * j.steepness);
}

std::string at(const BatchJoint& j) { return fmt::format("phi = {:.3g} rad", j.phi); }

/// J v as the batch gives it: of m_b, or of f_b, m_a, m_b.
template <class T>
void include_product(const BatchTables<T>& tables, const BatchJoint& j, long i, Measurement& error) {
  Eigen::Matrix<Real50, 12, 1> v;
  v.setZero();
  const bool angular = j.spec.kind == Kind::angular;
  for (int c = 0; c < tables.direction.rows(); ++c) {
    v[angular ? (c < 3 ? 3 + c : 6 + c) : c] = Real50(double(tables.direction(c, i)));
  }
  const Eigen::Matrix<Real50, 12, 1> exact = j.exact.tangent * v;
  const int rows[] = {angular ? 9 : 6, 3, 9};
  for (int l = 0; l < (angular ? 1 : 3); ++l) {
    for (int c = 0; c < 3; ++c) {
      const double difference = double(Real50(double(tables.tangent(3 * l + c, i))) - exact[rows[l] + c]);
      error.include(std::abs(difference) / tangent_scale(j), at(j));
    }
  }
}

template <class T>
void evaluate(const Entry& entry, const std::vector<BatchJoint>& joints, LawForm law, bool ends, Isa isa,
              Output output, Errors& errors) {
  BatchTables<T> tables(entry, joints, law, ends,
                        std::max(1, batch::tangent_rows(joints[0].spec.kind, output)));
  const Batch batch(tables.model, isa);
  if (!batch.has<T>(output)) return;
  batch::validate(tables.model, tables.joints(), tables.results(), output);
  batch.evaluate(tables.joints(), tables.results(), output);
  for (long i = 0; i < tables.count; ++i) {
    const BatchJoint& j = joints[i];
    if (j.steepness > kSteepest) continue;
    const NodeLoads<T> value = tables.at(i, output);
    errors.loads.include(miss(j.exact.q, value.q) / j.scale, at(j));
    if (output == Output::tangent || output == Output::tangent_144)
      errors.tangent.include(miss(j.exact.tangent, value.tangent) / tangent_scale(j), at(j));
    if (output == Output::product) include_product(tables, j, i, errors.product);
  }
}

/// By way of the compressed tangent: what it is expanded to, and J v made of it.
void evaluate_compressed(const Entry& entry, const std::vector<BatchJoint>& joints, LawForm law, bool ends,
                         Isa isa, Errors& errors) {
  const Kind kind = joints[0].spec.kind;
  BatchTables<double> tables(entry, joints, law, ends, batch::tangent_rows(kind, Output::tangent));
  BatchTables<double> product(entry, joints, law, ends, batch::tangent_rows(kind, Output::product));
  const Batch batch(tables.model, isa);
  if (!batch.has<double>(Output::compressed)) return;
  std::vector<double> blocks(batch::compressed_size(Batch::compressed_rows(tables.model), tables.count), NAN);
  const batch::Results<double> compressed{tables.loads.columns(), {blocks.data(), 0, long(blocks.size())}};
  batch::validate(tables.model, tables.joints(), compressed, Output::compressed);
  batch.evaluate(tables.joints(), compressed, Output::compressed);
  batch.expand(tables.joints(), compressed, tables.tangent.columns(), Output::tangent);
  batch.multiply(tables.joints(), compressed, product.tangent.columns());
  for (long i = 0; i < tables.count; ++i) {
    const BatchJoint& j = joints[i];
    if (j.steepness > kSteepest) continue;
    const NodeLoads<double> value = tables.at(i, Output::tangent);
    errors.loads.include(miss(j.exact.q, value.q) / j.scale, at(j));
    errors.tangent.include(miss(j.exact.tangent, value.tangent) / tangent_scale(j), at(j));
    include_product(product, j, i, errors.product);
  }
}

constexpr double kLimit = 5e-15;
constexpr double kInFloat =
    double(std::numeric_limits<float>::epsilon()) / std::numeric_limits<double>::epsilon();

constexpr const char* kLoadsReason =
    "of |K| |strain|, but 4 eps of |K|, what rounding the poses' products leaves of any strain; a dozen "
    "products in a row, half an eps each in the mean";

constexpr const char* kTangentReason =
    "of the largest entry, times its growth by the pose's rounding where a measure is steep; as the loads";
constexpr const char* kPolynomialReason =
    "as linear laws, times four: the slope of a fifth power has four times its strain's relative error";
constexpr const char* kProductReason =
    "of the tangent's largest entry: three times its own, a sum of up to twelve of them with signs";
constexpr const char* kExpandedReason =
    "as the tangent, times two: entries that are not kept are sums of up to three with signs";
constexpr const char* kFloatReason = "as in double, in eps of float";

constexpr double kPolynomial = 4;
constexpr double kProduct = 3;
constexpr double kExpanded = 2;

using JointSets = std::vector<BatchJoint>;

template <class T>
void all_outputs(const Entry& entry, const JointSets& joints, LawForm law, bool ends, Isa isa,
                 Errors& errors) {
  for (const Output output : {Output::residual, Output::tangent, Output::tangent_144, Output::product}) {
    evaluate<T>(entry, joints, law, ends, isa, output, errors);
  }
}

std::vector<Finding> against_50_digits(const Entry& entry, Kind kind) {
  const JointSets linear = batch_joints(entry, kind, LawForm::linear, true, false);
  const JointSets bare = batch_joints(entry, kind, LawForm::linear, false, false);
  const JointSets block_diagonal = kind == Kind::linear_angular ? uncoupled(entry, bare) : JointSets{};
  const JointSets odd = batch_joints(entry, kind, LawForm::polynomial, true, false);
  const JointSets single = batch_joints(entry, kind, LawForm::linear, true, true);
  std::vector<Finding> out;
  for (const Isa isa : kIsas) {
    if (!batch::available(isa)) continue;
    Errors errors, of_odd, in_float, compressed;
    all_outputs<double>(entry, linear, LawForm::linear, true, isa, errors);
    all_outputs<double>(entry, bare, LawForm::linear, false, isa, errors);
    if (!block_diagonal.empty())
      all_outputs<double>(entry, block_diagonal, LawForm::linear, false, isa, errors);
    all_outputs<double>(entry, odd, LawForm::polynomial, true, isa, of_odd);
    for (const JointSets* some : {&bare, &block_diagonal, &linear})
      if (!some->empty())
        evaluate_compressed(entry, *some, LawForm::linear, some == &linear, isa, compressed);
    all_outputs<float>(entry, single, LawForm::linear, true, isa, in_float);
    const std::string of = std::string("batch_") + batch::to_string(isa);
    const auto hold = [&](const char* what, const Measurement& error, double at_most, const char* reason) {
      out.push_back(property_finding(entry, kind, of + what)
                        .measured(error)
                        .in("relative")
                        .at_most(at_most, reason)
                        .by(Oracle::independent));
    };
    const Batch batch({.formulation = std::string(entry.name),
                       .kind = kind,
                       .xi = entry.probe.xi,
                       .length = entry.probe.length,
                       .axis = entry.probe.axis},
                      isa);
    hold("_loads", errors.loads, kLimit, kLoadsReason);
    hold("_tangent", errors.tangent, kLimit, kTangentReason);
    hold("_polynomial_loads", of_odd.loads, kLimit, kLoadsReason);
    hold("_polynomial_tangent", of_odd.tangent, kPolynomial * kLimit, kPolynomialReason);
    if (batch.has<double>(Output::product))
      hold("_product", errors.product, kProduct * kLimit, kProductReason);
    if (batch.has<double>(Output::compressed)) {
      hold("_compressed_loads", compressed.loads, kLimit, kLoadsReason);
      hold("_compressed_tangent", compressed.tangent, kExpanded * kLimit, kExpandedReason);
      hold("_compressed_product", compressed.product, kProduct * kLimit, kProductReason);
    }
    if (!batch.has<float>(Output::tangent)) continue;
    hold("_float_loads", in_float.loads, kLimit * kInFloat, kFloatReason);
    hold("_float_tangent", in_float.tangent, kLimit * kInFloat, kFloatReason);
  }
  return out;
}

}  // namespace

void batches(Checks& checks) {
  for (const Entry& entry : reference::formulations()) {
    if (!Batch::knows(entry.name)) continue;
    for (const Kind kind : kKinds) {
      checks.push_back({fmt::format("{}/{}/batch", entry.name, to_string(kind)), "batch",
                        [&entry, kind] { return against_50_digits(entry, kind); }});
    }
  }
}

}  // namespace halfway::verify
