#include "reports/cli/toml_text.hpp"
#include "reports/identify/results.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace halfway::reports {
namespace {

namespace id = reference::identify;
using namespace toml;

/// The row of the largest load, over the sizes of forces and moments, and its loads; what was not measured is
/// what the joint answers.
id::Vec6 largest_load(const Identified& what, const id::Fit& fit, const id::MakeModel& make) {
  const auto size = id::sizes(what.data);
  const auto motions = id::respond(what.data, make, id::tied(fit.p, fit.freedom), {}, false, {}).motions;
  const id::Model model = make(id::tied(fit.p, fit.freedom));
  id::Vec6 out = id::Vec6::Zero();
  double most = -1;
  std::size_t at = 0;
  for (const id::LoadCase& one : what.data.cases) {
    for (std::size_t row = 0; row < one.loads.size(); ++row, ++at) {
      id::Vec6 load = one.loads[row];
      const id::Vec6 answer = motions[at].allFinite() ? id::loads_at(model, motions[at], false).q : load;
      for (int i = 0; i < 6; ++i) {
        const bool is_of_kind =
            i >= id::first_component(what.data.kind) && i < id::end_component(what.data.kind);
        if (!is_of_kind)
          load[i] = 0;
        else if (one.held[std::size_t(i)] && !one.has_load[std::size_t(i)])
          load[i] = answer[i];
      }
      const double amount = (size[2] > 0 ? load.head<3>().norm() / size[2] : 0) +
                            (size[3] > 0 ? load.tail<3>().norm() / size[3] : 0);
      if (amount >= (1 - 1e-9) * most) most = amount, out = load;  // of two as large the later
    }
  }
  return out;
}

std::string law_text(const reference::JointSpec& spec) {
  std::string out = "[joint.law]\n";
  if (const auto* linear = std::get_if<reference::LinearSpec>(&spec.law))
    return out + fmt::format("type = \"linear\"\nstiffness = {}\n", linear->matrix.isDiagonal(0)
                                                                        ? list_of(linear->matrix.diagonal())
                                                                        : rows(linear->matrix));
  const auto& polynomial = std::get<reference::PolynomialSpec>(spec.law);
  return out + fmt::format("type = \"polynomial\"\nk1 = {}\nk3 = {}\n", list_of(polynomial.k1),
                           list_of(polynomial.k3));
}

std::string load_text(const char* type, const Vec3<double>& value) {
  return value.isZero(0) ? "" : fmt::format("[[load]]\ntype = \"{}\"\nvalue = {}\n\n", type, list_of(value));
}

/// The summary as comments: what a person has to know of the numbers below.
std::string comments(const Identified& what) {
  std::string out;
  const std::string summary = identify_summary(what);
  for (std::size_t from = 0; from < summary.size();) {
    const std::size_t to = summary.find('\n', from);
    out += "# " + readable(summary.substr(from, to - from)) + "\n";
    from = to + 1;
  }
  for (const id::LeftOpen& one : what.found.left_open) {
    if (one.place < id::kXiAngular) out += "# NOT IDENTIFIED, assumed below: " + one.what + "\n";
  }
  return out;
}

}  // namespace

std::string identify_scene(const Identified& what) {
  const BestJoint best = best_joint(what);
  const id::Frame frame = what.found.frame;
  const auto* entry = reference::find_formulation(best.formulation);
  const id::MakeModel make = [&](const id::Unknowns& p) {
    return id::catalog_model(*entry, frame, id::values_of(frame, p));
  };
  const reference::JointSpec spec = id::joint_spec(frame, best.values);
  const id::Vec6 load = largest_load(what, best.fit, make);
  std::string out = comments(what);
  const std::string file = std::filesystem::path(what.source).filename().string();
  out += fmt::format("title = {}\n", quoted("Identified from " + file));
  out += fmt::format("source = {}\n", quoted("./halfway identify " + what.source));
  out += fmt::format("formulations = [\"{}\"]\n", best.formulation);
  if (entry->needs_xi) out += fmt::format("xis = [{}]\n", digits(best.xi));
  out += fmt::format("\n[joint]\nkind = \"{}\"\n", to_string(what.data.kind));
  if (!spec.b.o.isZero(0)) out += fmt::format("offset_a = {0}\noffset_b = {0}\n", list_of(spec.b.o));
  if (!spec.a.H.isIdentity(0)) out += fmt::format("frame_a = {0}\nframe_b = {0}\n", rows(spec.a.H));
  out += law_text(spec);
  out += "\n# The largest load of the data; of one that was held, what holds it there.\n";
  out += load_text("fixed_force", load.head<3>()) + load_text("fixed_moment", load.tail<3>());
  return out + "[path]\nfactor_end = 1\npoints = 10\n";
}

}  // namespace halfway::reports
