#include "reports/import/scene/scene_text.hpp"

#include "reference/scene/text/document.hpp"
#include "reports/cli/toml_text.hpp"
#include "reports/import/record/text.hpp"

#include <fmt/format.h>

namespace halfway::imports {
namespace {

using namespace reports::toml;

/// "line 3: key = text; line 5: ...", cut: where numbers come from.
std::string origin(const std::vector<Source>& from) {
  constexpr std::size_t kMost = 6;
  std::string out;
  for (std::size_t i = 0; i < from.size() && i < kMost; ++i) {
    out += fmt::format("{}line {}: {}", i ? "; " : "", from[i].line, reference::shortened(from[i].key));
    if (!from[i].text.empty()) out += " = " + reference::shortened(from[i].text);
  }
  if (from.size() > kMost) out += "; ...";
  return readable(out);
}

std::string with_origin(const std::string& text, const std::vector<Source>& from) {
  return from.empty() ? text : fmt::format("# {}\n{}", origin(from), text);
}

std::string end_text(const char* node, const JointEnd<double>& end, const std::vector<Source>& from) {
  std::string out;
  if (!end.o.isZero(0)) out += fmt::format("offset_{} = {}\n", node, list_of(end.o));
  if (end.H != Mat3<double>::Identity()) out += fmt::format("frame_{} = {}\n", node, rows(end.H));
  return out.empty() ? out : with_origin(out, from);
}

std::string stiffness_text(const Eigen::MatrixXd& K) {
  return K.isDiagonal(0) ? list_of(K.diagonal()) : rows(K);
}

std::string axis_text(const AxisLaw& axis) {
  if (axis.x.empty()) return fmt::format("stiffness = {}\n", digits(axis.stiffness));
  return fmt::format("x = {}\ny = {}\ninterpolation = \"{}\"\n", list(axis.x), list(axis.y),
                     axis.x.size() < kFewestAkima ? "linear" : "akima");
}

std::string law_text(const ImportedJoint& joint) {
  const std::string preload =
      joint.preload.size() == 0
          ? ""
          : with_origin(fmt::format("preload = {}\n", list_of(joint.preload)), joint.preload_from);
  if (joint.axes.empty())
    return "[joint.law]\ntype = \"linear\"\n" +
           with_origin(fmt::format("stiffness = {}\n", stiffness_text(joint.K)), joint.law_from) + preload;
  std::string out = "[joint.law]\ntype = \"per_axis\"\n" + preload;
  for (std::size_t i = 0; i < joint.axes.size(); ++i)
    out += "[[joint.law.axis]]\n" + with_origin(axis_text(joint.axes[i]), {joint.law_from[i]});
  return out;
}

std::string load_text(const ExampleLoad& load) {
  std::string out = fmt::format(
      "# EXAMPLE LOAD: the file holds none. Put your own in its place. This is {}.\n[[load]]\n", load.said);
  out += fmt::format("type = \"{}\"\nvalue = {}\n", load.is_moment ? "fixed_moment" : "fixed_force",
                     list_of(load.value));
  if (!load.is_moment && !load.point.isZero(0)) out += fmt::format("point = {}\n", list_of(load.point));
  return out;
}

const char* kind_name(Kind kind) {
  return kind == Kind::angular ? "angular" : kind == Kind::linear ? "linear" : "linear_angular";
}

}  // namespace

std::string scene_text(const ImportedJoint& joint, const std::string& file, const std::string& formulation,
                       const ExampleLoad& load) {
  std::string out = fmt::format("# From {} ({}), {} in line {}.\n", readable(file), joint.program,
                                readable(reference::shortened(joint.name)), joint.line);
  for (const std::string& what : joint.lost) out += "# Lost: " + readable(what) + "\n";
  for (const std::string& what : joint.notes) out += "# Note: " + readable(what) + "\n";
  out += fmt::format("title = {}\n", quoted(reference::shortened(joint.name) + " of " + file));
  out +=
      fmt::format("source = {}\n", quoted(fmt::format("{}, line {} ({})", file, joint.line, joint.program)));
  out += fmt::format("formulations = [\"{}\"]{}\n\n", formulation,
                     joint.formulation.empty() ? "  # --as: the file holds no law of rotation" : "");
  out += fmt::format("[joint]\nkind = \"{}\"\n", kind_name(joint.kind));
  out += end_text("a", joint.a, joint.a_from) + end_text("b", joint.b, joint.b_from);
  return out + "\n" + law_text(joint) + "\n" + load_text(load) + "\n[path]\nfactor_end = 1\npoints = 10\n";
}

std::string file_name_of(const std::string& name) {
  std::string out;
  for (const char c : name.substr(0, 80)) {
    const bool is_kept =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    out += is_kept ? c : '_';
  }
  return out.empty() ? "bushing" : out;
}

}  // namespace halfway::imports
