// Assembled matrices and residuals against single joints at 50 digits, added up by their nodes: every layout,
// part, instruction set; and what must not change a bit.
#include "halfway/assemble/eigen.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/studies/kernels/net.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace halfway::verify {
namespace {

using assemble::Assembler, assemble::Form, assemble::Layout, assemble::Part, assemble::Pattern;
using batch::Isa;

constexpr Layout kAllLayouts[] = {Layout::blocks, Layout::rows, Layout::columns};
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

/// Every form in which joints of a model can be assembled.
std::vector<Form> forms(const batch::Model& model) {
  std::vector<Form> out;
  const bool upper = batch::Batch(model).has_potential();
  for (const int unknowns : {6, 3}) {
    if (unknowns == 3 && model.kind != Kind::angular) continue;
    for (const Layout layout : kAllLayouts) {
      out.push_back({unknowns, layout, Part::whole});
      if (upper) out.push_back({unknowns, layout, Part::upper});
    }
  }
  return out;
}

std::string form_text(const Form& form) {
  const char* const layouts[] = {"blocks", "rows", "columns"};
  return fmt::format("{} unknowns, {}{}", form.unknowns, layouts[int(form.layout)],
                     form.part == Part::upper ? ", upper" : "");
}

/// Of the symmetric part, what a triangle of blocks holds.
template <class M>
M upper_blocks(const M& m, int n) {
  M out = (m + m.transpose()) / 2;
  for (long row = 0; row < m.rows(); row += n) {
    for (long column = 0; column < row; column += n) out.block(row, column, n, n).setZero();
  }
  return out;
}

struct SumErrors {
  Measurement residual, matrix;
};

void include_sums(const Assembled& value, const Pattern& pattern, const Exact& exact,
                  const std::string& where, SumErrors& errors) {
  const bool upper = pattern.form().part == Part::upper;
  const auto tangent = upper ? upper_blocks(exact.tangent, pattern.form().unknowns) : exact.tangent;
  const Eigen::MatrixXd matrix = tapped(full_matrix(pattern, value.values));
  for (long i = 0; i < exact.loads.size(); ++i) {
    const double residual = tapped(value.residual[i]);
    errors.residual.include(std::abs(double(Real50(residual) - exact.loads[i])) / exact.load_scale, where);
    for (long j = 0; j < exact.loads.size(); ++j) {
      errors.matrix.include(std::abs(double(Real50(matrix(i, j)) - tangent(i, j))) / exact.tangent_scale,
                            where);
    }
  }
}

constexpr double kSumLimit = 5e-15;
constexpr const char* kSumReason =
    "of the largest joint's scale, as single joints of a batch; the errors of up to a dozen in a sum add at "
    "random";

/// What is in memory before: of angular joints in blocks of six the rest of a block is left as it is.
double before(const batch::Model& model, const Form& form) {
  return model.kind == Kind::angular && form.unknowns == 6 ? 0 : kNotANumber;
}

std::vector<Finding> sums_at_50_digits(const Entry& entry, Kind kind) {
  const Net net = solved_net(entry, kind);
  const NetInput in(net);
  std::vector<Finding> out;
  for (const Isa isa : kIsas) {
    if (!batch::available(isa)) continue;
    SumErrors errors;
    for (const Form& form : forms(in.model())) {
      const Pattern pattern(form, net.rows, net.nodes);
      const Assembler assembler(in.model(), pattern, {.isa = isa});
      assemble::validate(assembler, in.input());
      const Exact exact = exact_sums(net, form.unknowns);
      include_sums(assembled(assembler, pattern, in.input(), true, before(in.model(), form)), pattern, exact,
                   form_text(form), errors);
    }
    const auto hold = [&](const char* what, const Measurement& error) {
      out.push_back(property_finding(entry, kind, fmt::format("assembly_{}_{}", batch::to_string(isa), what))
                        .measured(error)
                        .in("relative")
                        .at_most(kSumLimit, kSumReason)
                        .by(Oracle::independent));
    };
    hold("residual", errors.residual), hold("matrix", errors.matrix);
  }
  return out;
}

int different_bits(const std::vector<double>& a, const std::vector<double>& b) {
  int out = a.size() != b.size();
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const double got = tapped(a[i]);
    out += std::memcmp(&got, &b[i], sizeof got) != 0;
  }
  return out;
}
int different_bits(const Assembled& a, const Assembled& b) {
  return different_bits(a.residual, b.residual) + different_bits(a.values, b.values);
}

/// @param differ  (model, pattern, isa, input) -> numbers that differ
template <class Differ>
Finding over_forms(const std::string& name, const std::string& reason, const Differ& differ) {
  int wrong = 0;
  const Entry& fasse = *reference::find_formulation("fasse");
  for (const Kind kind : kKinds) {
    const Net net = random_net(fasse, kind);
    const NetInput in(net);
    for (const Form& form : forms(in.model())) {
      const Pattern pattern(form, net.rows, net.nodes);
      for (const Isa isa : kIsas) {
        if (batch::available(isa)) wrong += differ(in.model(), pattern, isa, in.input());
      }
    }
  }
  return counted("assembly_" + name, wrong, reason);
}

Finding by_threads() {
  return over_forms(
      "threads", "1, 2, 3, 7 and 40 threads: bit for bit",
      [](const batch::Model& model, const Pattern& pattern, Isa isa, const assemble::Input& in) {
        const Assembled one = assembled(Assembler(model, pattern, {.isa = isa}), pattern, in, true, 0);
        int wrong = 0;
        for (const int n : {2, 3, 7, 40}) {
          const Assembler shared(model, pattern, {.threads = n, .isa = isa});
          wrong += different_bits(assembled(shared, pattern, in, true, 0), one);
        }
        return wrong;
      });
}

/// Assigned over NaN as added to zeros; where an entry is not the joints' own, it stays.
Finding assigned() {
  return over_forms(
      "assigned", "over NaN as added to zeros, bit for bit",
      [](const batch::Model& model, const Pattern& pattern, Isa isa, const assemble::Input& in) {
        const Assembler assembler(model, pattern, {.isa = isa});
        return different_bits(assembled(assembler, pattern, in, true, before(model, pattern.form())),
                              assembled(assembler, pattern, in, false, 0));
      });
}

constexpr double kUntouched = -7.25e77;

/// The same joints in the pattern of a matrix that has all blocks: their entries are as in their own, the
/// others keep what they had.
Finding within_larger() {
  return over_forms(
      "within_larger", "their own entries alone, bit for bit",
      [](const batch::Model& model, const Pattern& own, Isa isa, const assemble::Input& in) {
        std::vector<int> start{0}, index;
        const Form& form = own.form();
        const int n = form.layout == Layout::blocks ? form.unknowns : 1;
        const int size = int(own.unknown_count()) / n;
        for (int row = 0; row < size; ++row) {
          for (int column = 0; column < size; ++column) index.push_back(column);
          start.push_back(int(index.size()));
        }
        const Net net = random_net(*reference::find_formulation("fasse"), model.kind);
        const Pattern larger(form, net.rows, net.nodes, start, index);
        const auto mine = assembled(Assembler(model, own, {.isa = isa}), own, in, true, kUntouched);
        const auto all =
            assembled(Assembler(model, larger, {.threads = 2, .isa = isa}), larger, in, true, kUntouched);
        Eigen::MatrixXd expected = full_matrix(own, mine.values);
        const Eigen::MatrixXd touched = full_matrix(own, std::vector<double>(mine.values.size(), 1.));
        expected = (touched.array() == 0).select(kUntouched, expected);
        const Eigen::MatrixXd value = full_matrix(larger, all.values);
        int wrong = different_bits(all.residual, mine.residual);
        for (long i = 0; i < value.size(); ++i) wrong += tapped(value(i)) != expected(i);
        return wrong;
      });
}

/// Two models in one matrix, the first assigned, the second added: against a matrix for each.
Finding two_models() {
  const Net net = random_net(*reference::find_formulation("fasse"), Kind::linear_angular);
  NetInput in(net);
  const long first = 11, rest = long(net.nodes.size()) - first;
  const Pattern pattern({}, net.rows, net.nodes);
  batch::Model other = in.model();
  other.formulation = "invariant";
  const Assembler a(in.model(), pattern, {.count = first}), b(other, pattern, {.first = first});
  assemble::Input second = in.input();
  second.law.first += first, second.law.size -= first;
  std::vector<double> residual(pattern.unknown_count()), values(pattern.value_count());
  a.add(in.input(), residual, values), b.add(second, residual, values);
  const Assembled one = assembled(a, pattern, in.input(), false, 0),
                  two = assembled(b, pattern, second, false, 0);
  int wrong = b.joint_count() != rest;
  for (std::size_t i = 0; i < values.size(); ++i) {
    // Each sum is rounded in its own order: a dozen additions.
    const double sum = one.values[i] + two.values[i];
    const double size = std::abs(one.values[i]) + std::abs(two.values[i]);
    wrong += !(std::abs(tapped(values[i]) - sum) <= 1e-13 * (1 + size));
  }
  for (std::size_t i = 0; i < residual.size(); ++i) {
    wrong += !(std::abs(tapped(residual[i]) - one.residual[i] - two.residual[i]) <=
               1e-12 * (1 + std::abs(one.residual[i])));
  }
  return counted("assembly_two_models", wrong, "the sum of a matrix for each");
}

/// A matrix as one makes it with Eigen: joint after joint, entry after entry, setFromTriplets.
template <int options>
Eigen::SparseMatrix<double, options> by_triplets(const Net& net) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < net.joints.size(); ++i) {
    const int row[] = {net.rows[net.nodes[i].a], net.rows[net.nodes[i].b]};
    for (int r = 0; r < 12; ++r) {
      for (int c = 0; c < 12; ++c) {
        if (row[r / 6] == assemble::kFixed || row[c / 6] == assemble::kFixed) continue;
        entries.emplace_back(6 * row[r / 6] + r % 6, 6 * row[c / 6] + c % 6,
                             double(net.joints[i].exact.tangent(r, c)));
      }
    }
  }
  const long size = 6 * std::ranges::count_if(net.rows, [](int row) { return row != assemble::kFixed; });
  Eigen::SparseMatrix<double, options> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

template <int options>
int different_from_triplets(const Net& net, const NetInput& in) {
  const auto expected = by_triplets<options>(net);
  const Pattern own({6, assemble::layout_of<options>()}, net.rows, net.nodes);
  auto matrix = assemble::matrix_of<options>(own);
  auto given = expected;
  const Pattern within = assemble::pattern_within(given, 6, net.rows, net.nodes);
  std::vector<double> residual(own.unknown_count());
  Assembler(in.model(), own).assign(in.input(), residual, assemble::values_of(matrix));
  Assembler(in.model(), within).assign(in.input(), residual, assemble::values_of(given));
  int wrong = matrix.nonZeros() != expected.nonZeros();
  for (long k = 0; k < expected.nonZeros() && wrong == 0; ++k) {
    wrong += matrix.innerIndexPtr()[k] != expected.innerIndexPtr()[k];
    wrong += tapped(matrix.valuePtr()[k]) != given.valuePtr()[k];
  }
  const double scale = exact_sums(net, 6).tangent_scale;
  return wrong + !((matrix - expected).norm() <= kSumLimit * scale * double(matrix.rows()));
}

Finding eigen() {
  int wrong = 0;
  for (const char* name : {"invariant", "fasse"}) {
    const Net net = solved_net(*reference::find_formulation(name), Kind::linear_angular);
    const NetInput in(net);
    wrong +=
        different_from_triplets<Eigen::ColMajor>(net, in) + different_from_triplets<Eigen::RowMajor>(net, in);
  }
  return counted("assembly_eigen", wrong,
                 "entries as setFromTriplets has them, values as single joints at 50 digits");
}

}  // namespace

void assembly(Checks& checks) {
  for (const char* name : {"invariant", "intrinsic", "jointc", "conformal", "fasse", "mbdyn_joint_inv"}) {
    const Entry& entry = *reference::find_formulation(name);
    for (const Kind kind : kKinds) {
      checks.push_back({fmt::format("{}/{}/assembly", name, to_string(kind)), "batch",
                        [&entry, kind] { return sums_at_50_digits(entry, kind); }});
    }
  }
  const auto add = [&](const char* name, Finding (*measure)()) {
    checks.push_back(
        {std::string("batch/assembly_") + name, "batch", [measure] { return std::vector{measure()}; }});
  };
  add("threads", by_threads);
  add("assigned", assigned);
  add("within_larger", within_larger);
  add("two_models", two_models);
  add("eigen", eigen);
}

}  // namespace halfway::verify
