// Scenes and advice of tests: costs are counted, so that they are the same on every machine.
#pragma once

#include "reports/advise/core/advice.hpp"

#include <string>

namespace halfway::advise {

reference::Scene canonical(const std::string& name);

/// A rod of that angular stiffness under a moment that turns it by about |moment / K|, N m.
reference::Scene rod_scene(const Vec3<double>& stiffness, const Vec3<double>& moment);

/// The advice with its margins.
Advice advised(const Question& question);

/// A truth that one law is: its own path.
Truth own_truth(const reference::Scene& scene, const std::string& formulation);

/// The judgement of a formulation in double by its kernel with every digit and end.
const Judged& judged(const std::vector<Judged>& all, const std::string& formulation);

}  // namespace halfway::advise
