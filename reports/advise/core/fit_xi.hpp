// Which xi?
#pragma once

#include "reports/advise/core/question.hpp"
#include "reports/advise/model/candidate.hpp"

namespace halfway::advise {

/// The xi of `intrinsic` whose worst error within the envelope is least, of truths that have no mirror
/// symmetry by themselves (a body, a table); nothing where there is none between -1/2 and 3/2.
std::optional<double> fitted_xi(const Truth& truth, const Envelope& envelope, const Answers& answers,
                                Measure measure);

}  // namespace halfway::advise
