// MBDyn: deformable joints, hinges and displacement joints, attached to node 1 (our node a) or invariant.
#include "reports/import/readers/mbdyn_words.hpp"
#include "reports/import/readers/readers.hpp"
#include "reports/import/record/units.hpp"

#include <fmt/format.h>

namespace halfway::imports {
namespace {

/// What MBDyn calls it, and what it computes (reference/data/mbdyn).
struct JointType {
  std::string_view words;
  Kind kind;
  const char* formulation;
};
constexpr JointType kTypes[] = {
    {"deformable joint", Kind::linear_angular, "attached_a"},
    {"invariant deformable joint", Kind::linear_angular, "mbdyn_joint_inv"},
    {"deformable hinge", Kind::angular, "attached_a"},
    {"invariant deformable hinge", Kind::angular, "invariant"},
    {"deformable displacement joint", Kind::linear, "attached_a"},
    {"invariant deformable displacement joint", Kind::linear, "invariant"},
};

const JointType* type_of(std::string_view words) {
  for (const JointType& type : kTypes) {
    if (type.words == words) return &type;
  }
  return nullptr;
}

/// "set: const real K = 1e3": kept where it is a number; else names are missing where they are used.
void keep_variable(const Statement& statement, Variables& variables) {
  if (statement.front().key != "set" || statement.size() != 1) return;
  const std::string& text = statement.front().text;
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) return;
  std::string_view name = trimmed(std::string_view(text).substr(0, equals));
  name = name.substr(name.find_last_of(" :") + 1);
  const Source value{statement.front().line, std::string(name),
                     std::string(trimmed(std::string_view(text).substr(equals + 1)))};
  try {
    variables.insert_or_assign(std::string(name), value_of(value, variables));
  } catch (const std::runtime_error&) {
    variables.erase(std::string(name));
  }
}

/// Node, and where the joint is on it. A displacement joint's point may stand without a word.
Frame read_node(Words& words, Kind kind, std::vector<Source>& from) {
  from.push_back(words.take("a node's label"));
  Frame out;
  const bool has_word = words.takes("position");
  if (has_word || kind == Kind::linear) out.o = words.vector();
  if (words.takes("orientation") || words.takes("hinge")) out.H = words.orientation();
  return out;
}

void read_stiffness(Words& words, ImportedJoint& joint) {
  const int n = strains_of(joint.kind);
  const Source law = words.take("a constitutive law");
  joint.law_from.push_back(law);
  const bool is_viscous = law.text.starts_with("linear viscoelastic");
  if (law.text == "linear elastic" || law.text == "linear elastic isotropic" ||
      law.text == "linear viscoelastic" || law.text == "linear viscoelastic isotropic") {
    joint.K = words.number() * Eigen::MatrixXd::Identity(n, n);
  } else if (law.text == "linear elastic generic" || law.text == "linear viscoelastic generic") {
    joint.K = words.matrix(n);
  } else {
    refuse({law.line, "constitutive law", law.text}, "is not read",
           "linear elastic, linear elastic generic, linear viscoelastic, linear viscoelastic generic, "
           "written in the joint");
  }
  if (!is_viscous) return;
  const Source damping = words.look("a damping");
  if (words.takes("proportional"))
    lose(joint, {damping.line, "proportional", fmt::format("{}", words.number())}, {1}, kNoDamping);
  else if (law.text.ends_with("generic"))
    lose(
        joint,
        {damping.line, "damping", fmt::format("a matrix, largest {}", words.matrix(n).cwiseAbs().maxCoeff())},
        {1}, kNoDamping);
  else
    lose(joint, {damping.line, "damping", fmt::format("{}", words.number())}, {1}, kNoDamping);
}

void read_rest(Words& words, ImportedJoint& joint) {
  if (words.takes("prestress")) {
    joint.preload_from.push_back(words.look("stresses"));
    joint.preload = words.takes("null") ? Eigen::VectorXd::Zero(strains_of(joint.kind))
                                        : words.numbers(strains_of(joint.kind));
    if (joint.preload.isZero(0)) joint.preload.resize(0);
  }
  if (words.takes("prestrain") && !words.takes("null"))
    refuse({words.look("a drive").line, "prestrain", words.look("a drive").text},
           "is a strain that may change in time, which a scene cannot say", "prestress");
  if (!words.at_end() && words.look("").text != "output" && words.look("").text != "orientation description")
    refuse({words.look("").line, "joint", words.look("").text}, "was not expected after the law",
           "prestress, output, or ;");
}

/// Units are the user's.
void to_si(ImportedJoint& joint, const ImportOptions& options) {
  std::string note;
  const Units units = units_said(options, note);
  joint.notes.push_back(note);
  joint.a.o *= units.length, joint.b.o *= units.length;
  const int n = strains_of(joint.kind), first = joint.kind == Kind::angular ? 3 : 0;
  for (int i = 0; i < n; ++i) {
    if (joint.preload.size() > 0) joint.preload[i] *= units.stress(first + i);
    for (int j = 0; j < n; ++j) joint.K(i, j) *= units.stress(first + i) / units.strain(first + j);
  }
}

ImportedJoint joint_of(const Statement& statement, const JointType& type, const Variables& variables,
                       const ImportOptions& options) {
  ImportedJoint joint;
  joint.program = "MBDyn";
  const std::string& head = statement.front().text;
  joint.name = std::string(trimmed(std::string_view(head).substr(head.find(':') + 1)));
  joint.line = statement.front().line;
  joint.kind = type.kind;
  joint.formulation = type.formulation;
  Words words(statement, variables);
  words.take(""), words.take("");
  joint.a = read_node(words, type.kind, joint.a_from);
  joint.b = read_node(words, type.kind, joint.b_from);
  read_stiffness(words, joint);
  read_rest(words, joint);
  if (type.kind == Kind::angular) joint.a.o.setZero(), joint.b.o.setZero();  // of no effect
  to_si(joint, options);
  return joint;
}

}  // namespace

std::vector<ImportedJoint> read_mbdyn(std::string_view text, const ImportOptions& options) {
  std::vector<ImportedJoint> out;
  Variables variables;
  int joints = 0;
  for (const Statement& statement : statements_of(text)) {
    keep_variable(statement, variables);
    if (statement.front().key != "joint" || statement.size() < 2) continue;
    ++joints;
    if (const JointType* type = type_of(statement[1].text))
      out.push_back(joint_of(statement, *type, variables, options));
  }
  if (out.empty()) {
    refuse({1, "the file", fmt::format("{} joints", joints)}, "has no deformable joint",
           "joint: ..., [invariant] deformable joint, hinge or displacement joint");
  }
  return out;
}

}  // namespace halfway::imports
