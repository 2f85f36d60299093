// Chrono: joints with bushing data. Body 1 is our node a, body 2, in whose axes the law is, node b. The
// joint's type says which rotations have the stiffness of its degrees of freedom.
#include "reference/scene/text/fields.hpp"
#include "reports/import/readers/documents.hpp"
#include "reports/import/readers/readers.hpp"
#include "reports/import/record/frames.hpp"
#include "reports/import/record/text.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

namespace halfway::imports {
namespace {

using reference::Document;
using reference::Field;

Vec3<double> three(const Field& field) { return field.vector<3>("3 numbers"); }

/// The words of a bushing: YAML's and JSON's.
struct BushingWords {
  const char* stiffness_linear;
  const char* damping_linear;
  const char* stiffness_rotational;
  const char* damping_rotational;
};
constexpr BushingWords kYaml{"stiffness_linear", "damping_linear", "stiffness_rotational",
                             "damping_rotational"};
constexpr BushingWords kJson{"Stiffness Linear", "Damping Linear", "Stiffness Rotational",
                             "Damping Rotational"};

Source source_of(const Field& field, const char* word) {
  const Field value = field.at(word, "a number");
  return {value.line(), word, fmt::format("{}", value.number())};
}

double stiffness_at(const Field& data, const char* word, ImportedJoint& joint) {
  const Source at = source_of(data, word);
  joint.law_from.push_back(at);
  return stiffness_of(at);
}

/// Rotations (x, y, z) that are degrees of freedom.
std::array<bool, 3> free_rotations(const Source& type) {
  const std::string name = upper(type.text);
  if (name == "LOCK") return {false, false, false};
  if (name == "REVOLUTE") return {false, false, true};
  if (name == "UNIVERSAL") return {true, true, false};
  if (name == "SPHERICAL") return {true, true, true};
  refuse(type, "has no bushing in Chrono", "LOCK, REVOLUTE, UNIVERSAL, SPHERICAL");
}

void read_bushing(const Field& data, const BushingWords& words, const Source& type, ImportedJoint& joint) {
  const auto is_free = free_rotations(type);
  const double linear = stiffness_at(data, words.stiffness_linear, joint);
  const double rotational = stiffness_at(data, words.stiffness_rotational, joint);
  for (const char* word : {words.damping_linear, words.damping_rotational}) {
    const Source at = source_of(data, word);
    lose(joint, at, {number_of(at)}, kNoDamping);
  }
  double of_freedom = 0;
  if (const auto freedom = data.find("DOF")) {
    of_freedom = stiffness_at(*freedom, words.stiffness_rotational, joint);
    for (const char* word : {words.damping_linear, words.damping_rotational}) {
      const Source at = source_of(*freedom, word);
      lose(joint, {at.line, "DOF." + at.key, at.text}, {number_of(at)}, kNoDamping);
    }
  }
  joint.law_from.push_back(type);
  joint.K = Eigen::MatrixXd::Zero(6, 6);
  for (int i = 0; i < 3; ++i) {
    joint.K(i, i) = linear;
    joint.K(3 + i, 3 + i) = is_free[std::size_t(i)] ? of_freedom : rotational;
  }
}

ImportedJoint new_joint(const char* program, const Field& field, std::string name) {
  ImportedJoint joint;
  joint.program = program;
  joint.line = field.line();
  joint.name = std::move(name);
  joint.formulation = "chrono_body";
  return joint;
}

Source text_source(const Field& table, const char* word) {
  const Field field = table.at(word, "a text");
  return {field.line(), word, field.text()};
}

// YAML: bodies and joints of a model, in its axes.

Mat3<double> rotation_of(const Field& field, double unit) {
  std::vector<double> v;
  for (const Field item : field.items("3 angles about z, y, x, or a quaternion w, x, y, z"))
    v.push_back(item.number());
  if (v.size() == 3) return turns({2, 1, 0}, unit * Vec3<double>(v[0], v[1], v[2]));
  if (v.size() != 4) field.refuse("is no rotation", "3 angles about z, y, x, or a quaternion w, x, y, z");
  const Eigen::Vector4d q(v[0], v[1], v[2], v[3]);
  if (!(std::abs(q.norm() - 1) < 1e-3))
    field.refuse("is no unit quaternion", "a quaternion w, x, y, z of length 1");
  const Eigen::Vector4d unit_q = q.normalized();
  return so3::matrix<double>({unit_q[0], unit_q.tail<3>()});
}

Vec3<double> direction(const Field& joint, const char* word) {
  const Field field = joint.at(word, "3 numbers");
  const Vec3<double> v = three(field);
  if (!(v.norm() > 0) || !std::isfinite(v.norm())) field.refuse("is no direction", "3 numbers, not all zero");
  return v.normalized();
}

/// Any axes of which z is this: the law is the same about it.
Mat3<double> axes_about(const Vec3<double>& z) {
  const Vec3<double> x = z.unitOrthogonal();
  Mat3<double> R;
  R << x, z.cross(x), z;
  return R;
}

Frame joint_frame(const Field& joint, const std::string& type) {
  Frame out{three(joint.at("location", "3 numbers, m")), Mat3<double>::Identity()};
  if (type == "REVOLUTE") out.H = axes_about(direction(joint, "axis"));
  if (type == "UNIVERSAL") {
    const Vec3<double> x = direction(joint, "axis1"), second = direction(joint, "axis2");
    const Vec3<double> normal = x.cross(second);
    if (!(normal.norm() > 1e-9)) joint.at("axis2", "").refuse("is parallel to axis1", "another direction");
    const Vec3<double> z = normal.normalized();
    out.H << x, z.cross(x), z;
  }
  return out;
}

Frame body_frame(const Field& model, const Source& name, double unit, std::vector<Source>& from) {
  for (const Field body : model.at("bodies", "an array of bodies").items()) {
    if (body.text_or("name") != name.text) continue;
    const Field location = body.at("location", "3 numbers, m");
    from.push_back({location.line(), "location of " + name.text, ""});
    Frame out{three(location), Mat3<double>::Identity()};
    if (const auto orientation = body.find("orientation")) out.H = rotation_of(*orientation, unit);
    return out;
  }
  refuse(name, "is no body of the file", "the name of one of `bodies`");
}

ImportedJoint yaml_joint(const Field& model, const Field& field, double unit) {
  ImportedJoint joint = new_joint("Chrono YAML", field, field.at("name", "a text").text());
  const Source type = text_source(field, "type");
  read_bushing(field.at("bushing_data", "a table"), kYaml, type, joint);
  const Frame frame = joint_frame(field, upper(type.text));
  const Source at{field.at("location", "").line(), "location of the joint", ""};
  joint.a_from.push_back(at), joint.b_from.push_back(at);
  joint.a = in_frame(inverse(body_frame(model, text_source(field, "body1"), unit, joint.a_from)), frame);
  joint.b = in_frame(inverse(body_frame(model, text_source(field, "body2"), unit, joint.b_from)), frame);
  return joint;
}

// JSON: any object with "Bushing Data"; where it is on its bodies is a matter of the subsystem's template.

Source type_of(const Field& holder, const Field& data, const ImportOptions& options) {
  if (const auto type = holder.find("Type"); type && type->is_text())
    return {type->line(), "Type", type->text()};
  if (!options.joint_type.empty()) return {data.line(), "--joint", options.joint_type};
  data.refuse("stands in an object without a Type, so which rotations are free is not said",
              "--joint lock, revolute, universal or spherical");
}

void find_bushings(const Field& field, const std::string& name, const ImportOptions& options,
                   std::vector<ImportedJoint>& out) {
  if (field.is_array()) {
    for (const Field item : field.items()) find_bushings(item, name, options, out);
  }
  if (!field.is_table()) return;
  const std::string own = field.find("Name") && field.find("Name")->is_text() ? field.text_or("Name") : name;
  for (const Field item : Field::Items(field)) {
    const std::string key(item.key());
    if (!key.ends_with("Bushing Data") || !item.is_table()) {
      find_bushings(item, key, options, out);
      continue;
    }
    ImportedJoint joint = new_joint("Chrono JSON", item, key == "Bushing Data" ? own : own + " " + key);
    read_bushing(item, kJson, type_of(field, item, options), joint);
    for (const char* place : {"Position", "Rotation", "Coordinate System", "Location"}) {
      if (const auto at = field.find(place))
        joint.lost.push_back(fmt::format(
            "{} (line {}): the poses of the bodies are not with it; the joint is put at the nodes", place,
            at->line()));
    }
    out.push_back(joint);
  }
}

}  // namespace

std::vector<ImportedJoint> read_chrono_yaml(std::string_view text) {
  Document document = read_yaml(text);
  const Field file(document);
  const Field model = file.is_table() && file.find("model") ? file.at("model", "a table") : file;
  const auto degrees = model.is_table() ? model.find("angle_degrees") : std::nullopt;
  const double unit = degrees && !degrees->boolean() ? 1 : kDegree;
  std::vector<ImportedJoint> out;
  const Field joints = model.at("joints", "an array of joints");
  for (const Field joint : joints.items()) {
    if (joint.is_table() && joint.find("bushing_data")) out.push_back(yaml_joint(model, joint, unit));
  }
  if (out.empty()) joints.refuse("has no bushing", "a joint with bushing_data");
  return out;
}

std::vector<ImportedJoint> read_chrono_json(std::string_view text, const ImportOptions& options) {
  Document document = read_json(text);
  const Field file(document);
  std::vector<ImportedJoint> out;
  find_bushings(file, "bushing", options, out);
  if (out.empty()) file.refuse("has no bushing", "Chrono JSON: an object with \"Bushing Data\"");
  return out;
}

}  // namespace halfway::imports
