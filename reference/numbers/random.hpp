// The same random numbers on every compiler and standard library: fixed seed, no
// std::uniform_real_distribution, and no two draws in one unsequenced expression.
#pragma once

#include "halfway/rotations/so3.hpp"

#include <cstdint>
#include <random>

namespace halfway::reference {

class Generator {
 public:
  explicit Generator(std::uint64_t seed) : engine_(seed) {}

  double uniform(double low, double high) { return low + (high - low) * double(engine_() >> 11) * 0x1p-53; }
  /// Uniform in the cube of half edge `size`; braces draw x, y, z in this order.
  Vec3<double> vector(double size) {
    return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
  }
  /// Unit length; denser toward the corners of the cube, which is as generic as uniform.
  Vec3<double> direction() {
    Vec3<double> v = vector(1);
    while (v.norm() < 0.2) v = vector(1);
    return v.normalized();
  }
  /// By an angle uniform in [low, high] rad about a random axis, drawn in the order axis, angle.
  Mat3<double> rotation(double low, double high) {
    const Vec3<double> axis = direction();
    const double phi = uniform(low, high);
    return so3::exp<double>(phi * axis);
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace halfway::reference
