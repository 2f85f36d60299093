// What the checks of the 3D truth share: their findings, and the kept data by name.
#pragma once

#include "reference/truth/fe/studies/studies.hpp"
#include "verify/check.hpp"

namespace halfway::verify {

/// The material law that the paper's own program documents: that of the truth which formulations are held to.
inline constexpr reference::fe::SolidLaw kPaperLaw = reference::fe::SolidLaw::cauchy_log;

/// A finding on a solid: name "fe/...", subject "fe".
Draft solid_finding(const std::string& name);

/// The kept characterisation of a body. Throws std::runtime_error saying how to make it.
const reference::fe::Characterisation& characterisation(const std::string& body);

/// What the analysis of a solid gave, on its way into a check.
reference::fe::SecondOrder tapped(reference::fe::SecondOrder s);

/// A compliance whose coupling of translation and rotation is rounding (1e-9) becomes exactly block diagonal:
/// some formulations refuse a coupled law.
reference::fe::Mat6 without_rounding(reference::fe::Mat6 C);

/// The kept curves that are the truth of a scene. Throws std::runtime_error saying how to make them.
std::vector<reference::fe::SolidCurve> solid_curves(const std::string& scene);

}  // namespace halfway::verify
