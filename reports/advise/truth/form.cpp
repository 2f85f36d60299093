// The paper's form of a scene at 50 digits: which laws are that one, and what their arithmetic leaves.
#include "reference/solve/path.hpp"
#include "reference/solve/solve.hpp"
#include "reports/advise/truth/truth.hpp"
#include "reports/cli/errors.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace halfway::advise {
namespace {

constexpr double kMirrorSymmetric = 0.5;  ///< no other xi is possible to second order, for any elastic law

Answers exactly(const reference::Scene& scene, const reference::Choice& choice,
                const std::vector<double>& factors) {
  Answers out{scene.outputs, factors, {}};
  reference::Path<reference::Real50> path(scene, *choice.entry, choice.xi);
  for (const double factor : factors) {
    if (path.advance(factor).status != Status::converged) {
      out.ended = "the form's own path ends";
      break;
    }
    std::vector<double> row;
    for (const std::string& output : scene.outputs) row.push_back(double(path.output(output)));
    out.value.push_back(std::move(row));
  }
  return out;
}

}  // namespace

Truth form_truth(const reference::Scene& scene) {
  // A body without mirror symmetry has a xi other than 1/2: the last such one of the scene.
  const auto skewed =
      std::find_if(scene.xis.rbegin(), scene.xis.rend(), [](double xi) { return xi != kMirrorSymmetric; });
  const bool symmetric = skewed == scene.xis.rend();
  const reference::Choice choice{reference::find_formulation(symmetric ? "invariant" : "intrinsic"),
                                 symmetric ? kMirrorSymmetric : *skewed};
  Truth out;
  out.kind = TruthKind::form;
  out.scene = scene;
  out.described = symmetric ? "invariant at 50 digits, since the scene has no xi other than 1/2"
                            : fmt::format("intrinsic with the scene's xi = {} at 50 digits", choice.xi);
  out.at = [scene, choice](const std::vector<double>& factors) { return exactly(scene, choice, factors); };
  return out;
}

}  // namespace halfway::advise
