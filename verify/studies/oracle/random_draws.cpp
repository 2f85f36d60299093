// What is drawn must not depend on the compiler: two draws in one unsequenced expression would.
#include "reference/face/kernel_entry.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/studies/limits/random_scene.hpp"
#include "verify/studies/limits/random_scene_text.hpp"

#include <cmath>

namespace halfway::verify {
namespace {

constexpr int kDraws = 50;

double of_pairs() {
  reference::Generator g(1);
  double sum = 0;
  for (int i = 0; i < kDraws; ++i) {
    const auto pair = reference::turned_pair(g, 0.5, i % 2 == 0);
    const Eigen::Vector4d weights(1, 2, 3, 4);
    sum += weights.dot(pair.a) - 2 * weights.dot(pair.b);
  }
  return sum;
}

double of_scenes() {
  reference::Generator g(1);
  double sum = 0;
  for (int i = 0; i < kDraws; ++i) {
    const reference::RandomScene drawn = random_scene(g, reference::formulations().front());
    const auto add = [&](const Vec3<double>& v) { sum += v.dot(Vec3<double>(1, 2, 3)) / (1 + v.norm()); };
    add(drawn.setting.frame_turn), add(drawn.setting.frame_shift);
    add(drawn.scene.joint.a.o), add(drawn.scene.joint.b.o);
    for (const auto& load : drawn.scene.loads) add(load.value), add(load.point);
    if (const auto* law = std::get_if<reference::PolynomialSpec>(&drawn.scene.joint.law))
      sum += law->k3.sum() / (1 + law->k1.sum()) + law->k5.sum() / (1 + law->k1.sum());
  }
  return sum;
}

double of_texts() {
  reference::Generator g(1);
  double sum = 0;
  for (int i = 0; i < kDraws; ++i) {
    double place = 0;
    for (const char c : reference::random_scene_text(g)) sum += ++place * (unsigned char)c;
  }
  return sum;
}

Finding drawn(const char* what, double value, double expected) {
  return finding(std::string("random_draws/") + what)
      .about("random_draws")
      .measured(tapped(value))
      .in("weighted sum")
      .equal(expected, 1e-10 * std::abs(expected),
             "as g++ 12 draws them; fused arithmetic moves the last bits, another order of draws all of them")
      .by(Oracle::kept);
}

std::vector<Finding> draws() {
  return {drawn("turned_pair", of_pairs(), 58.881884956315),
          drawn("random_scene", of_scenes(), 57.1340038143499),
          drawn("random_scene_text", of_texts(), 1067601291)};
}

}  // namespace

void random_draws(Checks& checks) { checks.push_back({"random_draws/any_compiler", "identities", draws}); }

}  // namespace halfway::verify
