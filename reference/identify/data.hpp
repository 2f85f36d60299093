// Measured curves of a joint: loads on node b and its motion, node a clamped at the identity.
#pragma once

#include "halfway/joint/pose.hpp"

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

namespace halfway::reference::identify {

/// Components along global axes. Of motion: displacement of node b from rest (m), rotation vector log(R_b)
/// (rad). Of loads: force on node b (N), moment about node b (N m), as they act in that state.
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;
inline constexpr std::array<const char*, 6> kMotionNames = {"u_x",     "u_y",     "u_z",
                                                            "theta_x", "theta_y", "theta_z"};
inline constexpr std::array<const char*, 6> kLoadNames = {"f_x", "f_y", "f_z", "m_x", "m_y", "m_z"};

/// What is measured with one and the same noise: displacements, rotations, forces, moments.
inline constexpr int kChannels = 4;
inline constexpr std::array<const char*, kChannels> kChannelNames = {"displacements", "rotations", "forces",
                                                                     "moments"};
inline constexpr std::array<const char*, kChannels> kChannelUnits = {"m", "rad", "N", "N m"};

/// One curve. A component is either loaded (its load is what was applied, zero without a column, its motion
/// what was measured) or held (its motion is what was prescribed, zero without a column, its load what was
/// measured).
struct LoadCase {
  std::string name{};
  int line = 1;  ///< of the file, where it begins
  std::array<bool, 6> held{};
  std::array<bool, 6> has_load{}, has_motion{};
  std::vector<Vec6> loads{}, motions{};  ///< a row each; zero where there is no column

  /// Is component i a measured number, which the fit has to meet?
  bool is_measured(int i) const {
    return held[std::size_t(i)] ? has_load[std::size_t(i)] : has_motion[std::size_t(i)];
  }
  double measured(std::size_t row, int i) const {
    return held[std::size_t(i)] ? loads[row][i] : motions[row][i];
  }
  int channel(int i) const { return (held[std::size_t(i)] ? 2 : 0) + (i < 3 ? 0 : 1); }
};

struct Data {
  Kind kind = Kind::linear_angular;
  std::vector<LoadCase> cases{};
  std::array<double, kChannels> sigma{};  ///< standard deviation of the noise where the file says it, else 0
};

/// The components that a joint of that kind has: [first, end).
constexpr int first_component(Kind kind) { return kind == Kind::angular ? 3 : 0; }
constexpr int end_component(Kind kind) { return kind == Kind::linear ? 3 : 6; }

/// How many numbers were measured.
int measured_count(const Data& data);

/// Root mean square of all numbers of a sort, loads and motions that are given: 0 displacements ... 3
/// moments.
std::array<double, kChannels> sizes(const Data& data);

}  // namespace halfway::reference::identify
