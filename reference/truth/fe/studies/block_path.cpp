#include "reference/truth/fe/studies/block_path.hpp"

#include "reference/truth/fe/studies/vectors.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <ctime>

namespace halfway::reference::fe {
namespace {

constexpr TaperedBlock kBlock = {5, {30, 5}, {30, 5}};
constexpr double kFirstMoment = 2.5, kMomentStep = 25, kLastMoment = 1800;  ///< N m
constexpr double kShortestStep = 3;     ///< N m: of a moment that is not reached at once
constexpr double kTurn = 0.05;          ///< rad
constexpr double kShortestTurn = 0.01;  ///< rad
constexpr double kLastTurn = 3;         ///< rad, short of pi, where the logarithm folds
constexpr double kFallen = 0.99;        ///< of the largest moment: the limit is passed

/// What the face's rotation feels where no force holds the face.
Mat3<double> rotational(const Mat6& K) {
  return K.bottomRightCorner<3, 3>() -
         K.bottomLeftCorner<3, 3>() * K.topLeftCorner<3, 3>().partialPivLu().solve(K.topRightCorner<3, 3>());
}

class Follower {
 public:
  Follower(const BlockMesh& mesh, const Vec3<double>& direction)
      : law_(mesh.law),
        solid_(block_mesh(mesh), body_named("block").material, body_named("block").face),
        statics_(solid_) {
    load_.m = direction;
    at_.state = solid_.unloaded();
    at_.factor = 0;
  }

  int unknowns() const { return solid_.unknowns(); }
  Vec3<double> compliance() { return statics_.linear().compliance.diagonal().tail<3>(); }

  std::string rise(std::vector<BlockPoint>& points) {
    for (const double moment : block_moments()) {
      const bool reached = reach(moment, kShortestStep, at_.factor, &Follower::to_moment);
      if (!reached && (points.empty() || points.back().moment == at_.factor)) return why_;
      if (!record(points) || !reached) return why_;
    }
    return "reached";
  }

  std::string turn(std::vector<BlockPoint>& points) {
    double largest = at_.factor;
    while (at_.theta()[0] + kTurn < kLastTurn) {
      const double theta_1 = at_.theta()[0];
      if (!reach(theta_1 + kTurn, kShortestTurn, theta_1, &Follower::to_turn) || !record(points)) return why_;
      largest = std::max(largest, at_.factor);
      if (at_.factor < kFallen * largest) return "past the limit";
    }
    return "theta_1 is nearly pi";
  }

 private:
  using To = Equilibrium (Follower::*)(double);

  Equilibrium to_moment(double moment) {
    Load load = load_;
    load.m *= moment;
    Equilibrium e = statics_.solve(law_, load, at_.state);
    e.factor = moment;
    return e;
  }
  Equilibrium to_turn(double theta_1) { return statics_.turn(law_, load_, theta_1, at_); }

  /// At once, or by halves of the way from `from`.
  bool reach(double aim, double shortest, double from, To to) {
    Equilibrium e = (this->*to)(aim);
    if (e.converged) {
      at_ = std::move(e);
      return true;
    }
    why_ = e.reason;
    const double middle = from + (aim - from) / 2;
    if (aim - middle < shortest) return false;
    return reach(middle, shortest, from, to) && reach(aim, shortest, middle, to);
  }

  bool record(std::vector<BlockPoint>& points) {
    Load load = load_;
    load.m *= at_.factor;
    const auto tangent = statics_.condensed(law_, load, at_.state);
    if (!tangent) {
      why_ = "the interior is unstable at the equilibrium found";
      return false;
    }
    const Mat3<double> K = rotational(*tangent);
    Vec3<double> stiffness = K.eigenvalues().real();
    std::sort(stiffness.begin(), stiffness.end());
    points.push_back({at_.factor, at_.theta(), at_.state.d, K.determinant(), stiffness});
    return true;
  }

  SolidLaw law_;
  Solid solid_;
  Statics statics_;
  Load load_;
  Equilibrium at_;  ///< factor: the moment, N m
  std::string why_;
};

nlohmann::json list_of(const std::vector<BlockPoint>& points) {
  nlohmann::json out = nlohmann::json::array();
  for (const BlockPoint& p : points) {
    out.push_back({{"moment", p.moment},
                   {"theta", triple(p.theta)},
                   {"d", triple(p.d)},
                   {"determinant", p.determinant},
                   {"stiffness", triple(p.stiffness)}});
  }
  return out;
}

std::vector<BlockPoint> points_of(const nlohmann::json& json) {
  std::vector<BlockPoint> out;
  for (const auto& p : json)
    out.push_back({p.at("moment"), vector(p.at("theta")), vector(p.at("d")), p.at("determinant"),
                   vector(p.at("stiffness"))});
  return out;
}

}  // namespace

std::vector<double> block_moments() {
  std::vector<double> out = {kFirstMoment};
  for (int i = 1; i * kMomentStep <= kLastMoment; ++i) out.push_back(i * kMomentStep);
  return out;
}

Mesh block_mesh(const BlockMesh& mesh) {
  return tapered_block(mesh.element, kBlock, {mesh.level, 3 * mesh.level, mesh.level}, mesh.grading);
}

BlockPath follow_block(const BlockMesh& mesh, const Vec3<double>& direction) {
  const std::clock_t begin = std::clock();
  Follower follower(mesh, direction);
  BlockPath path;
  path.mesh = mesh;
  path.unknowns = follower.unknowns();
  path.compliance = follower.compliance();
  path.rising_end = follower.rise(path.rising);
  path.turned_end = follower.turn(path.turned);
  path.seconds = double(std::clock() - begin) / CLOCKS_PER_SEC;
  return path;
}

std::optional<BlockLimit> limit_of(const BlockPath& path) {
  std::vector<BlockPoint> all = path.rising;
  all.insert(all.end(), path.turned.begin(), path.turned.end());
  for (const BlockPoint& p : all) {
    if (std::isnan(p.moment)) return BlockLimit{p.moment, p.moment};
  }
  const auto top = std::ranges::max_element(all, {}, &BlockPoint::moment);
  if (all.size() < 3 || top == all.begin() || top + 1 == all.end()) return {};
  // Newton's divided differences through the neighbours.
  const BlockPoint &a = top[-1], &b = top[0], &c = top[1];
  const double x = a.theta[0], y = b.theta[0], z = c.theta[0];
  const double slope = (b.moment - a.moment) / (y - x);
  const double bend = ((c.moment - b.moment) / (z - y) - slope) / (z - x);
  const double at = (x + y) / 2 - slope / (2 * bend);
  return BlockLimit{a.moment + (at - x) * (slope + bend * (at - y)), at};
}

void to_json(nlohmann::json& json, const BlockPath& path) {
  json = {{"law", to_string(path.mesh.law)},
          {"element", to_string(path.mesh.element)},
          {"level", path.mesh.level},
          {"grading", path.mesh.grading},
          {"unknowns", path.unknowns},
          {"seconds", path.seconds},
          {"compliance", triple(path.compliance)},
          {"rising", list_of(path.rising)},
          {"rising_end", path.rising_end},
          {"turned", list_of(path.turned)},
          {"turned_end", path.turned_end}};
}

void from_json(const nlohmann::json& json, BlockPath& path) {
  path.mesh = {law_named(json.at("law")), element_kind(json.at("element")), json.at("level"),
               json.at("grading")};
  path.unknowns = json.at("unknowns");
  path.seconds = json.at("seconds");
  path.compliance = vector(json.at("compliance"));
  path.rising = points_of(json.at("rising"));
  path.rising_end = json.at("rising_end");
  path.turned = points_of(json.at("turned"));
  path.turned_end = json.at("turned_end");
}

}  // namespace halfway::reference::fe
