#include "verify/oracle/fe_access.hpp"
#include "verify/oracle/saboteurs/tap.hpp"

#include <map>
#include <stdexcept>
#include <utility>

namespace halfway::verify {
namespace fe = reference::fe;

Draft solid_finding(const std::string& name) { return finding("fe/" + name).about("fe"); }

static std::vector<fe::Characterisation> kept_and_tapped() {
  auto list = fe::kept_characterisations();
  for (auto& bearing : fe::kept_bearings()) list.push_back(std::move(bearing));
  for (auto& body : list) {
    for (auto& run : body.runs) run.result = tapped(run.result);
  }
  return list;
}

const fe::Characterisation& characterisation(const std::string& body) {
  static std::map<Tap, std::vector<fe::Characterisation>> known;
  auto& all = known[passing()];
  if (all.empty()) all = kept_and_tapped();
  for (const auto& c : all) {
    if (c.body == body) return c;
  }
  throw std::runtime_error("the 3D data of body \"" + body +
                           "\" is missing or not of today's inputs; run ./halfway reference");
}

fe::SecondOrder tapped(fe::SecondOrder s) {
  s.compliance = tapped(s.compliance);
  for (auto& of_law : s.couplings) {
    for (auto& Q : of_law) Q = tapped(Q);
  }
  return s;
}

fe::Mat6 without_rounding(fe::Mat6 C) {
  const fe::Vec6 size = C.diagonal().cwiseSqrt();
  const fe::Mat6 relative = C.cwiseQuotient(size * size.transpose());
  if (relative.topRightCorner<3, 3>().cwiseAbs().maxCoeff() > 1e-9) return C;
  C.topRightCorner<3, 3>().setZero();
  C.bottomLeftCorner<3, 3>().setZero();
  return C;
}

std::vector<fe::SolidCurve> solid_curves(const std::string& scene) {
  static const std::vector<fe::SolidCurve> all = fe::kept_curves();
  std::vector<fe::SolidCurve> out;
  for (const auto& curve : all) {
    if (curve.scene == scene) out.push_back(curve);
  }
  if (out.empty())
    throw std::runtime_error("the 3D curves of scene \"" + scene +
                             "\" are missing or not of today's inputs; run ./halfway reference");
  return out;
}

}  // namespace halfway::verify
