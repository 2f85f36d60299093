// The advice: which candidate, with its evidence, what it saves and where it changes.
#pragma once

#include "reports/advise/core/disqualify.hpp"
#include "reports/advise/cost/cost.hpp"

namespace halfway::advise {

/// A candidate and all that is known of it.
struct Judged {
  Candidate candidate{};
  Cost cost{};
  std::vector<double>
      errors;        ///< at each row, against the truth; without one the farthest admissible law's distance
  double error = 0;  ///< the worst within the envelope
  Reach reach{};     ///< up to where it is within the tolerance
  Defects defects{};
  std::string disqualified{};  ///< why it is out whatever its error; empty: it is not
  bool by_theory = false;      ///< out by second-order theory alone: not computed

  bool suffices(double tolerance) const { return disqualified.empty() && error <= tolerance; }
};

/// Where another candidate is advised.
struct Change {
  double at = 0;          ///< a load factor, a tolerance, or a stiffness ratio
  double rotation = 0;    ///< of the truth there, rad; of a load factor
  std::string instead{};  ///< by name; empty: none suffices
  bool beyond = false;    ///< not there yet, within what was looked at
};

struct Margin {
  Change less_load, more_load;
  Change tighter, looser;  ///< of the tolerance
  Change less_ratio, more_ratio;
  double ratio = 0;  ///< largest over smallest stiffness of the scene's law; 0: not looked at
};

struct Advice {
  Question question;
  Truth truth;
  Envelope envelope{};
  Answers answers{};             ///< of the truth, or of what leads the envelope, see leading()
  std::vector<Judged> judged{};  ///< ascending cost; without a cost last
  std::optional<std::size_t> choice{};
  std::optional<std::size_t>
      plain{};  ///< the same formulation of the scene's kind in double with every digit
  Margin margin{};

  bool has_truth() const { return truth.kind != TruthKind::none; }
  Measure measure() const { return question.measure.value_or(truth.measure); }
  const Judged* chosen() const { return choice ? &judged[*choice] : nullptr; }
};

/// Costs nearer than this are the same: what is more exact, by this share of the error, is then chosen.
inline constexpr double kSameCost = 1.1, kMoreExact = 0.5;

/// The index of the candidate that is advised at that tolerance when those with these errors were to choose
/// from; nothing where none suffices. Costs ascend.
std::optional<std::size_t> choose(const std::vector<Judged>& judged, double tolerance);

/// Truth and envelope of a question. Throws BadInput where it has no answer.
Advice asked(const Question& question);

/// Judgement and choice of an advice whose truth and envelope are known.
void answer(Advice& advice, const std::map<std::string, Cost>& costs);

/// All but the margins. @param costs  of Candidate::timing(); where it has none a candidate cannot be chosen.
Advice advise(const Question& question, const std::map<std::string, Cost>& costs);

/// Costs of all candidates of a scene, measured now.
std::map<std::string, Cost> costs_of(const reference::Scene& scene);

/// Candidates judged against a truth, in the order of cost.
std::vector<Judged> judge(const Question& question, const Truth& truth, const Answers& answers,
                          const Envelope& envelope, Measure measure,
                          const std::map<std::string, Cost>& costs);

/// Where the advice changes with the load, the tolerance and, of a truth that can be made again, the
/// stiffness ratio.
Margin margin_of(const Advice& advice, const std::map<std::string, Cost>& costs);

}  // namespace halfway::advise
