// Scene files of mechanisms, broken in one place at a time: each is refused by file, line and key.
#include "verify/oracle/broken_scene.hpp"

#include <fmt/format.h>

namespace halfway::verify {
namespace {

constexpr const char* kGoodMechanism = R"(title = "good"
outputs = ["crank.theta_z", "pin1.a.f_x", "frequency_1"]
formulations = ["invariant"]

[[body]]
name = "crank"
mass = 1
center = [0, 0.5, 0]
inertia = [1, 1, 2]

[[body]]
name = "rocker"
x = [3, 0, 0]
h = [1, 0, 0, 0]
mass = 2
inertia = [[1, 0, 0], [0, 1, 0], [0, 0, 2]]

[[joint]]
name = "pin1"
between = ["ground", "crank"]
kind = "linear_angular"
[joint.law]
type = "linear"
stiffness = [1, 2, 3, 4, 5, 6]

[[joint]]
name = "pin2"
between = ["crank", "rocker"]
kind = "linear_angular"
[joint.law]
type = "linear"
stiffness = [1, 2, 3, 4, 5, 6]

[[load]]
body = "rocker"
type = "follower_force"
value = [0, 0, 1]
factors = [1, 0]

[[motion]]
name = "drive"
body = "crank"
type = "rotation"
axis = "z"
value = 0.5

[path]
steps = 2
points = 4
critical = true

[[reference]]
source = "s"
oracle = "printed"
tolerance = 1e-6
reason = "r"
[reference.values]
invariant = { critical_factor = "none" }
)";

constexpr const char* kThree =
    "name = \"pin2\"\nbetween = [\"crank\", \"rocker\"]\nkind = \"linear_angular\"";

constexpr Broken kBrokenMechanisms[] = {
    {"body_key", "body[1].masses = ", "mass = 1\n", "masses = 1 #!\n"},
    {"body_name_missing", "body[1].name = nothing", "[[body]]\nname = \"crank\"", "[[body]] #!"},
    {"body_name_twice", "body[2].name = ", "name = \"rocker\"", "name = \"crank\" #!"},
    {"body_name_ground", "body[1].name = ", "name = \"crank\"", "name = \"ground\" #!"},
    {"body_name_dot", "body[1].name = ", "name = \"crank\"", "name = \"crank.1\" #!"},
    {"body_mass_zero", "body[1].mass = ", "mass = 1\n", "mass = 0 #!\n"},
    {"body_inertia_indefinite", "body[1].inertia = ", "inertia = [1, 1, 2]", "inertia = [1, 1, -2] #!"},
    {"body_inertia_asymmetric", "body[2].inertia = ", "[[1, 0, 0], [0, 1, 0], [0, 0, 2]]",
     "[[1, 0.5, 0], [0, 1, 0], [0, 0, 2]] #!"},
    {"body_orientation", "body[2].h = ", "h = [1, 0, 0, 0]", "h = [1, 1, 0, 0] #!"},
    {"body_free_unknown", "body[1].free = ", "mass = 1\n", "mass = 1\nfree = \"turns\" #!\n"},
    {"body_free_and_clamped", "body[1].free = ", "mass = 1\n",
     "mass = 1\nclamped = true\nfree = \"all\" #!\n"},
    {"body_clamped_text", "body[1].clamped = ", "mass = 1\n", "mass = 1\nclamped = \"yes\" #!\n"},
    {"body_held_by_nothing", "body[3] = ", "[[joint]]\nname = \"pin1\"",
     "[[body]] #!\nname = \"lost\"\n\n[[joint]]\nname = \"pin1\""},
    {"body_without_mass", "outputs = ",
     "\"frequency_1\"]\nformulations = [\"invariant\"]\n\n[[body]]\nname = \"crank\"\nmass = 1\n",
     "\"frequency_1\"] #!\nformulations = [\"invariant\"]\n\n[[body]]\nname = \"crank\"\n"},
    {"joint_name_twice", "joint[2].name = ", "name = \"pin2\"", "name = \"pin1\" #!"},
    {"joint_named_as_body", "joint[2].name = ", "name = \"pin2\"", "name = \"crank\" #!"},
    {"joint_between_unknown", "joint[2].between[2] = ", "between = [\"crank\", \"rocker\"]",
     "between = [\"crank\", \"rokcer\"] #!"},
    {"joint_between_one", "joint[2].between = ", "between = [\"crank\", \"rocker\"]",
     "between = [\"crank\"] #!"},
    {"joint_between_itself", "joint[2].between = ", "between = [\"crank\", \"rocker\"]",
     "between = [\"crank\", \"crank\"] #!"},
    {"joint_between_text", "joint[2].between = ", "between = [\"crank\", \"rocker\"]",
     "between = \"crank\" #!"},
    {"joint_key", "joint[2].betwen = ", "between = [\"crank\", \"rocker\"]",
     "betwen = [\"crank\", \"rocker\"] #!"},
    {"joint_kind_unknown", "joint[2].kind = ", kThree,
     "name = \"pin2\"\nbetween = [\"crank\", \"rocker\"]\nkind = \"linear-angular\" #!"},
    {"load_body_unknown", "load[1].body = ", "body = \"rocker\"", "body = \"rock\" #!"},
    {"load_body_missing", "load[1].body = nothing", "[[load]]\nbody = \"rocker\"", "[[load]] #!"},
    {"load_on_ground", "load[1].body = ", "body = \"rocker\"", "body = \"ground\" #!"},
    {"load_factors_short", "load[1].factors = ", "factors = [1, 0]", "factors = [1] #!"},
    {"load_factors_and_held", "load[1].factors = ", "factors = [1, 0]", "held = true\nfactors = [1, 0] #!"},
    {"load_factors_without_steps", "load[1].factors = ",
     "factors = [1, 0]\n\n[[motion]]\nname = \"drive\"\nbody = \"crank\"\ntype = \"rotation\"\naxis = "
     "\"z\"\nvalue = "
     "0.5\n\n[path]\nsteps = 2",
     "factors = [1, 0] #!\n\n[[motion]]\nname = \"drive\"\nbody = \"crank\"\ntype = \"rotation\"\naxis = "
     "\"z\"\nvalue = 0.5\n\n[path]\nfactor_end = 2"},
    {"load_type_unknown", "load[1].type = ", "type = \"follower_force\"", "type = \"jet\" #!"},
    {"motion_body_unknown", "motion[1].body = ", "name = \"drive\"\nbody = \"crank\"",
     "name = \"drive\"\nbody = \"crnk\" #!"},
    {"motion_of_ground", "motion[1].body = ", "name = \"drive\"\nbody = \"crank\"",
     "name = \"drive\"\nbody = \"ground\" #!"},
    {"motion_type_unknown", "motion[1].type = ", "type = \"rotation\"", "type = \"turn\" #!"},
    {"motion_axis_unknown", "motion[1].axis = ", "axis = \"z\"", "axis = 3 #!"},
    {"motion_value_vector", "motion[1].value = ", "axis = \"z\"\nvalue = 0.5",
     "axis = \"z\"\nvalue = [0, 0, 0.5] #!"},
    {"motion_value_number", "motion[1].value = ", "axis = \"z\"\nvalue = 0.5", "value = 0.5 #!"},
    {"motion_point_of_rotation", "motion[1].point = ", "axis = \"z\"\n",
     "axis = \"z\"\npoint = [0, 0, 0] #!\n"},
    {"motion_twice", "motion[2].type = ", "[path]",
     "[[motion]]\nbody = \"crank\"\ntype = \"rotation\" #!\nvalue = [0, 0, 1]\n\n[path]"},
    {"motion_kind",
     "motion[1].type = ", "[[motion]]\nname = \"drive\"\nbody = \"crank\"\ntype = \"rotation\"",
     "[[body]]\nname = \"flat\"\nfree = \"displacement\"\n[[motion]]\nname = \"drive\"\nbody = \"flat\"\n"
     "type = \"rotation\" #!"},
    {"path_steps_and_end", "path.factor_end = ", "points = 4", "points = 4\nfactor_end = 2 #!"},
    {"path_steps_zero", "path.steps = ", "steps = 2", "steps = 0 #!"},
    {"path_critical_text", "path.critical = ", "critical = true", "critical = \"yes\" #!"},
    {"path_critical_axis", "path.critical_axis = ", "critical = true", "critical_axis = 1 #!"},
    {"output_of_no_joint", "outputs[2] = ", "\"pin1.a.f_x\", \"frequency_1\"]", "\"pin3.a.f_x\"] #!"},
    {"output_of_no_mode", "outputs[3] = ", "\"frequency_1\"]", "\"frequency_12\"] #!"},
    {"mechanism_without_length", "formulations = ", "formulations = [\"invariant\"]",
     "formulations = [\"invariant\", \"rod34\"] #!"},
    {"linearized", "formulations[2] = ", "formulations = [\"invariant\"]",
     "formulations = [\"invariant\", \"linearized\"] #!"},
};

}  // namespace

void mechanism_refusals(Checks& checks) {
  checks.push_back({"mechanisms/accepts/good", "mechanisms",
                    [] { return std::vector{accepted("mechanism_good", kGoodMechanism)}; }});
  for (const Broken& broken : kBrokenMechanisms) {
    checks.push_back({fmt::format("mechanisms/refuses/{}", broken.what), "mechanisms",
                      [&broken] { return std::vector{broken_refused(kGoodMechanism, broken)}; }});
  }
}

}  // namespace halfway::verify
