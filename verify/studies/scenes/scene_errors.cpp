// Broken scene files: each must be refused, and the message must name file, line and key. One good
// text is broken in one place at a time; "#!" marks the line that the message must name.
#include "verify/oracle/broken_scene.hpp"
#include "verify/oracle/temporary_scene.hpp"

#include <fmt/format.h>

namespace halfway::verify {
namespace {

constexpr const char* kGood = R"(title = "good"
outputs = ["theta_x"]
formulations = ["invariant", "intrinsic"]
xis = [0.5]

[joint]
kind = "angular"
offset_a = [0, 0, 0]
frame_b = [1, 0, 0, 0]
[joint.law]
type = "linear"
stiffness = [1, 2, 3]

[[load]]
type = "fixed_moment"
value = [0, 0, 1]

[path]
factor_end = 10
points = 20

[[reference]]
source = "s"
oracle = "printed"
factor = 1
tolerance = 1e-6
reason = "r"
[reference.values]
invariant = { theta_x = "0.1" }
)";

constexpr Broken kBroken[] = {
    {"unknown_key_top", "colour = ", "xis = [0.5]\n", "xis = [0.5]\ncolour = 1 #!\n"},
    {"unknown_key_joint", "joint.knd = ", "kind = \"angular\"", "kind = \"angular\"\nknd = 1 #!"},
    {"unknown_key_law", "joint.law.k1 = ", "stiffness = [1, 2, 3]",
     "stiffness = [1, 2, 3]\nk1 = [1, 2, 3] #!"},
    {"unknown_key_load", "load[1].factor = ", "value = [0, 0, 1]", "value = [0, 0, 1]\nfactor = 2 #!"},
    {"unknown_key_path", "path.stops = ", "points = 20", "stops = 20 #!"},
    {"unknown_key_reference", "reference[1].tol = ", "tolerance = 1e-6", "tol = 1e-6 #!"},
    {"missing_title", "title = nothing", "title = \"good\"", "#!"},
    {"missing_kind", "joint.kind = nothing", "[joint]\nkind = \"angular\"", "[joint] #!"},
    {"missing_stiffness", "joint.law.stiffness = nothing",
     "[joint.law]\ntype = \"linear\"\nstiffness = [1, 2, 3]", "[joint.law] #!\ntype = \"linear\""},
    {"missing_factor_end", "path.factor_end = nothing", "[path]\nfactor_end = 10", "[path] #!"},
    {"missing_value", "load[1].value = nothing", "[[load]]\ntype = \"fixed_moment\"\nvalue = [0, 0, 1]",
     "[[load]] #!\ntype = \"fixed_moment\""},
    {"missing_reason", "reference[1].reason = nothing",
     "[[reference]]\nsource = \"s\"\noracle = \"printed\"\nfactor = 1\ntolerance = 1e-6\nreason = \"r\"",
     "[[reference]] #!\nsource = \"s\"\noracle = \"printed\"\nfactor = 1\ntolerance = 1e-6"},
    {"title_is_number", "title = ", "title = \"good\"", "title = 3 #!"},
    {"joint_is_number", "joint = ",
     "[joint]\nkind = \"angular\"\noffset_a = [0, 0, 0]\nframe_b = [1, 0, 0, 0]\n"
     "[joint.law]\ntype = \"linear\"\nstiffness = [1, 2, 3]",
     "joint = 3 #!"},
    {"load_is_one_table", "load = ", "[[load]]", "[load] #!"},
    {"offset_is_text", "joint.offset_a[2] = ", "offset_a = [0, 0, 0]", "offset_a = [0, \"1\", 0] #!"},
    {"points_is_float", "path.points = ", "points = 20", "points = 20.5 #!"},
    {"load_too_short", "load[1].value = ", "value = [0, 0, 1]", "value = [0, 1] #!"},
    {"stiffness_too_long", "joint.law.stiffness = ", "stiffness = [1, 2, 3]",
     "stiffness = [1, 2, 3, 4, 5, 6] #!"},
    {"stiffness_ragged", "joint.law.stiffness[2] = ", "stiffness = [1, 2, 3]",
     "stiffness = [[1, 0, 0],\n[0, 1], #!\n[0, 0, 1]]"},
    {"stiffness_empty", "joint.law.stiffness = ", "stiffness = [1, 2, 3]", "stiffness = [] #!"},
    {"stiffness_nan", "joint.law.stiffness[2] = nan", "stiffness = [1, 2, 3]", "stiffness = [1, nan, 3] #!"},
    {"load_inf", "load[1].value[3] = -inf", "value = [0, 0, 1]", "value = [0, 0, -inf] #!"},
    {"stiffness_negative", "joint.law.stiffness = ", "stiffness = [1, 2, 3]", "stiffness = [1, -2, 3] #!"},
    {"compliance_zero", "joint.law.compliance = ", "stiffness = [1, 2, 3]", "compliance = [1, 0, 3] #!"},
    {"stiffness_and_compliance", "joint.law.compliance = ", "stiffness = [1, 2, 3]",
     "stiffness = [1, 2, 3]\ncompliance = [1, 1, 1] #!"},
    {"stiffness_not_symmetric", "joint.law.stiffness = ", "stiffness = [1, 2, 3]",
     "stiffness = [[2, 0.5, 0], [0.4, 2, 0], [0, 0, 2]] #!"},
    {"stiffness_indefinite", "joint.law.stiffness = ", "stiffness = [1, 2, 3]",
     "stiffness = [[1, 2, 0], [2, 1, 0], [0, 0, 1]] #!"},
    {"compliance_singular", "joint.law.compliance = ", "stiffness = [1, 2, 3]",
     "compliance = [[1, 1, 0], [1, 1, 0], [0, 0, 1]] #!"},
    {"polynomial_soft", "joint.law.k1 = ", "type = \"linear\"\nstiffness = [1, 2, 3]",
     "type = \"polynomial\"\nk1 = [1, -1, 1] #!"},
    {"law_unknown", "joint.law.type = ", "type = \"linear\"", "type = \"liner\" #!"},
    {"kind_unknown", "joint.kind = ", "kind = \"angular\"", "kind = \"angle\" #!"},
    {"quaternion_not_unit", "joint.frame_b = ", "frame_b = [1, 0, 0, 0]", "frame_b = [1, 0.1, 0, 0] #!"},
    {"quaternion_zero", "joint.frame_b = ", "frame_b = [1, 0, 0, 0]", "frame_b = [0, 0, 0, 0] #!"},
    {"frame_not_orthogonal", "joint.frame_b = ", "frame_b = [1, 0, 0, 0]",
     "frame_b = [[1, 0, 0], [0, 1, 0.1], [0, 0, 1]] #!"},
    {"frame_reflection", "joint.frame_b = ", "frame_b = [1, 0, 0, 0]",
     "frame_b = [[1, 0, 0], [0, 1, 0], [0, 0, -1]] #!"},
    {"load_unknown", "load[1].type = ", "type = \"fixed_moment\"", "type = \"moment\" #!"},
    {"load_held_number", "load[1].held = ", "value = [0, 0, 1]", "value = [0, 0, 1]\nheld = 1 #!"},
    {"load_arm", "load[1].arm = ", "value = [0, 0, 1]", "value = [0, 0, 1]\narm = [1, 0, 0] #!"},
    {"load_without_arm", "load[1].arm = nothing", "[[load]]\ntype = \"fixed_moment\"",
     "[[load]] #!\ntype = \"quasi_tangential_moment\""},
    {"load_arm_along", "load[1].arm = ", "\"fixed_moment\"\nvalue = [0, 0, 1]",
     "\"quasi_tangential_moment\"\nvalue = [0, 0, 1]\narm = [0.1, 0, 1] #!"},
    {"load_arm_zero", "load[1].arm = ", "\"fixed_moment\"\nvalue = [0, 0, 1]",
     "\"quasi_tangential_moment\"\nvalue = [0, 0, 1]\narm = [0, 0, 0] #!"},
    {"point_of_moment", "load[1].point = ", "value = [0, 0, 1]", "value = [0, 0, 1]\npoint = [1, 0, 0] #!"},
    {"output_unknown", "outputs[1] = ", "outputs = [\"theta_x\"]", "outputs = [\"theta_1\"] #!"},
    {"output_of_other_kind", "outputs[1] = ", "outputs = [\"theta_x\"]", "outputs = [\"u_x\"] #!"},
    {"output_twice", "outputs[2] = ", "outputs = [\"theta_x\"]", "outputs = [\"theta_x\", \"theta_x\"] #!"},
    {"formulation_unknown", "formulations[1] = ", "[\"invariant\", \"intrinsic\"]", "[\"invariante\"] #!"},
    {"formulation_without_xi", "formulations = ", "[\"invariant\", \"intrinsic\"]\nxis = [0.5]",
     "[\"invariant\", \"intrinsic\"] #!"},
    {"formulation_without_length", "formulations = ", "[\"invariant\", \"intrinsic\"]",
     "[\"invariant\", \"intrinsic\", \"rod34\"] #!"},
    {"axis_without_length", "joint.axis = ", "kind = \"angular\"", "kind = \"angular\"\naxis = 1 #!"},
    {"axis_zero", "joint.axis = ", "kind = \"angular\"", "kind = \"angular\"\nlength = 1\naxis = 0 #!"},
    {"length_negative", "joint.length = ", "kind = \"angular\"", "kind = \"angular\"\nlength = -1 #!"},
    {"points_zero", "path.points = ", "points = 20", "points = 0 #!"},
    {"points_too_many", "path.points = ", "points = 20", "points = 100001 #!"},
    {"factor_end_zero", "path.factor_end = ", "factor_end = 10", "factor_end = 0.0 #!"},
    {"tolerance_zero", "reference[1].tolerance = ", "tolerance = 1e-6", "tolerance = 0 #!"},
    {"tolerance_negative", "reference[1].tolerance = ", "tolerance = 1e-6", "tolerance = -1e-6 #!"},
    {"factor_beyond_path", "reference[1].factor = ", "factor = 1\n", "factor = 11 #!\n"},
    {"oracle_unknown", "reference[1].oracle = ", "oracle = \"printed\"", "oracle = \"print\" #!"},
    {"reference_formulation_unknown", "reference[1].values.inviriant = ", "invariant = { theta_x = \"0.1\" }",
     "inviriant = { theta_x = \"0.1\" } #!"},
    {"reference_formulation_not_solved", "reference[1].values.attached_a = ",
     "invariant = { theta_x = \"0.1\" }", "attached_a = { theta_x = \"0.1\" } #!"},
    {"reference_output_unknown", "reference[1].values.invariant.theta_y = ", "{ theta_x = \"0.1\" }",
     "{ theta_y = \"0.1\" } #!"},
    {"reference_critical_not_asked", "reference[1].values.invariant.critical_moment = ",
     "{ theta_x = \"0.1\" }", "{ critical_moment = \"0.1\" } #!"},
    {"reference_is_number", "reference[1].values.invariant.theta_x = ", "\"0.1\" }", "0.1 } #!"},
    {"reference_not_decimal", "reference[1].values.invariant.theta_x = ", "\"0.1\" }", "\"0.1x\" } #!"},
    {"reference_xi_missing", "reference[1].xi = nothing",
     "[[reference]]\nsource = \"s\"\noracle = \"printed\"\nfactor = 1\ntolerance = 1e-6\nreason = \"r\"\n"
     "[reference.values]\ninvariant",
     "[[reference]] #!\nsource = \"s\"\noracle = \"printed\"\nfactor = 1\ntolerance = 1e-6\nreason = \"r\"\n"
     "[reference.values]\nintrinsic"},
    {"reference_xi_not_solved", "reference[1].xi = ", "reason = \"r\"", "reason = \"r\"\nxi = 0.7 #!"},
    {"critical_axis_not_principal", "path.critical_axis = ",
     "stiffness = [1, 2, 3]\n\n[[load]]\ntype = \"fixed_moment\"\nvalue = [0, 0, 1]\n\n[path]\n",
     "stiffness = [[1, 0, 0], [0, 2, 1], [0, 1, 3]]\n\n[[load]]\ntype = \"fixed_moment\"\nvalue = [0, 0, "
     "1]\n\n"
     "[path]\ncritical_axis = 2 #!\n"},
    {"syntax", "", "factor_end = 10", "factor_end = = 10 #!"},
    {"key_twice", "", "points = 20", "points = 20\npoints = 30 #!"},
};

/// A file that breaks off in the middle of a value: refused at its last line.
std::vector<Finding> check_truncated() {
  const std::string good = kGood, text = good.substr(0, good.find("[0, 0, 1]") + 4);
  const TemporaryScene scene("truncated", text);
  return {refused("truncated", scene.path(), fmt::format("{}: ", line_at(text, text.size())))};
}

std::vector<Finding> check_binary() {
  const TemporaryScene scene("binary", std::string("title = \"\xff\xfe\"\n", 13));
  return {refused("binary", scene.path(), "1: ")};
}

std::vector<Finding> check_unreadable() {
  const auto missing = std::filesystem::temp_directory_path() / "halfway_no_such_folder" / "scene.toml";
  const auto folder = std::filesystem::temp_directory_path() / ".";
  return {refused("unreadable", missing, " cannot be read"), refused("folder", folder, " is a folder")};
}

}  // namespace

void scene_errors(Checks& checks) {
  checks.push_back({"scenes/accepts/good", "cases", [] { return std::vector{accepted("good", kGood)}; }});
  for (const Broken& broken : kBroken) {
    checks.push_back({fmt::format("scenes/refuses/{}", broken.what), "cases",
                      [&broken] { return std::vector{broken_refused(kGood, broken)}; }});
  }
  checks.push_back({"scenes/refuses/truncated", "cases", check_truncated});
  checks.push_back({"scenes/refuses/binary", "cases", check_binary});
  checks.push_back({"scenes/refuses/unreadable", "cases", check_unreadable});
}

}  // namespace halfway::verify
