#include "reports/views/programs.hpp"

#include "reference/programs/joints.hpp"
#include "reference/programs/measured.hpp"
#include "reference/programs/path_joints.hpp"
#include "reports/views/rounded.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace halfway::reports {
namespace {

using nlohmann::json;
using programs::Known;
using programs::ProgramFacts;
using reference::Comparison;
using reference::Finding;
using reference::Verdict;

using Findings = std::vector<Finding>;

const Finding* find(const Findings& findings, const std::string& name) {
  const auto it = std::ranges::find(findings, name, &Finding::name);
  const bool is_there = it != findings.end() && it->verdict != Verdict::left_out && std::isfinite(it->value);
  return is_there ? &*it : nullptr;
}

struct Law {
  std::string name, stands_for, source;
  Known known = Known::measured;
  json facts = json::array(), defects = json::array(), cases = json::array();

  void add_defect(const Finding& finding, std::string words) {
    defects.push_back({{"words", std::move(words)},
                       {"size", rounded(std::abs(finding.value), 4)},
                       {"finding", finding.name}});
  }
};

// ----- what is known of the laws of programs

json words_of(const ProgramFacts& f) {
  json words = json::array();
  const auto add = [&](bool holds, const char* text) {
    if (holds) words.push_back(text);
  };
  add(f.balanced, "moments balance");
  add(f.order_free, "the order of the bodies does not matter");
  add(f.isotropic_conservative && !f.anisotropic_conservative,
      "no work round a loop of turns with one stiffness");
  add(f.anisotropic_conservative, "no work round a loop of turns");
  add(f.tensorial, "tensorial");
  add(f.isotropic_moments, "takes one stiffness for turns");
  add(f.isotropic_forces, "takes one stiffness for moves");
  add(f.is_bond, "a bond, whose points rest apart");
  add(!f.has_forces, "its forces are not known");
  return words;
}

/// A property of programs/PROPERTY/LAW, and its defect in words: there where the finding has a least size.
struct Property {
  const char* finding;
  const char* defect;
};
constexpr Property kProperties[] = {
    {"moment_balance", "moments do not balance"},
    {"path_balance", "moments do not balance"},
    {"objectivity", "a rigid turn of both bodies makes loads"},
    {"masses", "the masses matter, so it is no force law"},
    {"loop_one_stiffness", "works round a loop of turns even with one stiffness"},
    {"loop_three_stiffnesses", "works round a loop of turns with unequal stiffnesses"},
    {"loop_of_a_bond", "works round a loop"},
    {"body_order", "the order of the bodies matters"},
    {"tensoriality", "not tensorial: its measure has axes of its own"},
    {"double_cover", "q and -q are not the same"},
    {"proportionality", "loads are not proportional to the stiffness"},
};

const Finding* named(const Findings& findings, const char* property, const Law& law) {
  return find(findings, fmt::format("programs/{}/{}", property, law.name));
}

bool is_there(const Finding* f) { return f && f->comparison == Comparison::at_least; }

void add_properties(Law& law, const Findings& findings) {
  bool works = false;
  for (const auto& [property, words] : kProperties) {
    const Finding* f = named(findings, property, law);
    if (!is_there(f)) continue;
    const bool is_loop = std::string_view(property).starts_with("loop_");
    if (!(is_loop && works)) law.add_defect(*f, words);  // with unequal stiffnesses, too: said already
    works = works || is_loop;
  }
}

void add_stiffness(Law& law, const Findings& findings) {
  const Finding* f = named(findings, "stiffness", law);
  if (!f || f->expected == 1) return;
  const std::string share = f->expected == 1. / 4   ? "a quarter of the stiffness"
                            : f->expected == 1. / 8 ? "an eighth of the stiffness"
                                                    : "another stiffness than";
  const bool asks = is_there(named(findings, "masses", law));
  law.add_defect(*f, share + " asked for" + (asks ? ", for masses of 1 kg" : ""));
}

/// Where turns alone do no work with one stiffness, turns and moves still may.
void add_moving_loop(Law& law, const Findings& findings) {
  const Finding* f = named(findings, "loop_measured/six", law);
  if (f && f->expected != 0 && !is_there(named(findings, "loop_one_stiffness", law)))
    law.add_defect(*f, "works round a loop of turns and moves even with one stiffness each");
}

void add_free_spin(Law& law, const Findings& findings) {
  constexpr double kBent = 0.1;         // of the bending moment; less is of second order in the bend
  if (law.name == "jolt_6dof") return;  // a motor that is off makes another law of it: jolt_partial
  for (const char* shaft : {"x", "y", "z"}) {
    const Finding* f = find(findings, fmt::format("programs/free_spin/{}/{}", shaft, law.name));
    if (f && f->expected > kBent)
      law.add_defect(*f, fmt::format("bent, a shaft that spins freely about {} gets a wrong moment", shaft));
  }
}

void add_defects(Law& law, const Findings& findings) {
  add_properties(law, findings);
  add_stiffness(law, findings);
  add_moving_loop(law, findings);
  add_free_spin(law, findings);
}

/// What a closed path leaves in a law with a memory.
void add_remainder(Law& law, const Findings& findings) {
  constexpr const char* kAngle = "0.8";
  if (const auto* f = find(findings, fmt::format("programs/cone/{}/{}", kAngle, law.name));
      f && f->expected != 0)
    law.add_defect(*f, fmt::format("a closed cone of {} rad leaves a twist behind (rad)", kAngle));
}

// ----- formulations of the catalog that a program computes

struct Kept {
  const char* property;
  const char* defect;
  const char* words;  ///< where it holds
};
constexpr Kept kKept[] = {
    {"moment_balance", "moments do not balance", "moments balance"},
    {"loop_work", "works round a loop", "no work round a loop"},
    {"node_order", "the order of the bodies matters", "the order of the bodies does not matter"},
};

/// Was the program asked with one stiffness for turns, because it takes no more? Then defects of three are
/// not its own.
bool takes_one_stiffness(const std::string& answers) {
  return std::ranges::all_of(reference::read_measured(answers).poses, [](const auto& pose) {
    const Mat3<double>& K = pose.ask.K_m;
    return K(0, 0) == K(1, 1) && K(1, 1) == K(2, 2);
  });
}

Law of_catalog(const std::string& name, const std::string& answers, const Findings& findings) {
  const auto* entry = reference::find_formulation(name);
  Law law{name, entry ? std::string(entry->stands_for) : "", "a formulation of the catalog"};
  if (takes_one_stiffness(answers)) {
    law.facts.push_back("takes one stiffness for turns");
    return law;
  }
  for (const auto& [property, defect, words] : kKept) {
    const Finding* f = find(findings, fmt::format("{}/linear_angular/{}", name, property));
    if (f && f->verdict == Verdict::known_failure) law.add_defect(*f, defect);
    if (f && f->verdict == Verdict::pass) law.facts.push_back(words);
  }
  return law;
}

// ----- all of them

Law of_path(const reference::PathJoint& joint, const Findings& findings) {
  Law law{std::string(joint.name), std::string(joint.stands_for), joint.facts.source, joint.facts.known,
          words_of(joint.facts)};
  law.facts.push_back("its loads depend on the path");
  add_defects(law, findings);
  add_remainder(law, findings);
  return law;
}

std::vector<Law> laws_of_programs(const Findings& findings) {
  std::vector<Law> out;
  for (const auto& joint : reference::program_joints()) {
    const ProgramFacts& facts = joint.facts;
    Law law{std::string(joint.name), std::string(joint.stands_for), facts.source, facts.known,
            words_of(facts)};
    add_defects(law, findings);
    out.push_back(std::move(law));
  }
  for (const auto& joint : reference::path_joints()) out.push_back(of_path(joint, findings));
  return out;
}

/// Decimal digits, down to a tenth; what is equal has those of a double.
double digits(double difference) {
  constexpr double kDouble = 15.9;
  return difference > 0 ? std::min(kDouble, std::floor(-10 * std::log10(difference)) / 10) : kDouble;
}

/// The kept answers that a finding held a law against, or empty.
std::string answers_of(const std::string& finding) {
  constexpr std::string_view kMeasured = "programs/measured/double/";
  if (finding == "programs/simbody/loads") return "simbody";
  return finding.starts_with(kMeasured) ? finding.substr(kMeasured.size()) : "";
}

json case_of(const std::string& answers, const Finding& f) {
  const auto measured = reference::read_measured(answers);
  return {{"name", answers},           {"program", measured.program}, {"version", measured.version},
          {"how", measured.how},       {"answers", "kept"},           {"poses", measured.poses.size()},
          {"digits", digits(f.value)}, {"good_to", digits(f.high)},   {"finding", f.name}};
}

void add_cases(std::vector<Law>& laws, const Findings& findings) {
  for (const Finding& f : findings) {
    const std::string answers = answers_of(f.name);
    if (answers.empty() || find(findings, f.name) == nullptr) continue;
    auto law = std::ranges::find(laws, f.formulation, &Law::name);
    if (law == laws.end()) law = laws.insert(laws.end(), of_catalog(f.formulation, answers, findings));
    law->cases.push_back(case_of(answers, f));
  }
}

}  // namespace

json programs_record(const Findings& findings) {
  json rows = json::array();
  if (std::ranges::none_of(findings, [](const Finding& f) { return f.name.starts_with("programs/"); }))
    return rows;
  std::vector<Law> laws = laws_of_programs(findings);
  add_cases(laws, findings);
  std::ranges::stable_sort(laws, {}, &Law::known);
  for (const Law& law : laws) {
    rows.push_back({{"name", law.name},
                    {"stands_for", law.stands_for},
                    {"known", programs::to_string(law.known)},
                    {"source", law.source},
                    {"facts", law.facts},
                    {"cases", law.cases},
                    {"defects", law.defects}});
  }
  return rows;
}

}  // namespace halfway::reports
