// Drake: <drake:linear_bushing_rpy> in SDF and URDF. Frame A is our node a, frame C node b.
#include "reports/import/readers/xml.hpp"
#include "reports/import/record/frames.hpp"

#include <fmt/format.h>
#include <cmath>

namespace halfway::imports {
namespace {

constexpr const char* kBushing = "drake:linear_bushing_rpy";
constexpr int kLongestChain = 32;  // of frames in frames

Vec3<double> three(const Source& at) {
  const auto v = numbers_of(at, 3);
  return {v[0], v[1], v[2]};
}

/// Roll, pitch, yaw about fixed x, y, z, rad.
Mat3<double> from_rpy(const Vec3<double>& rpy) { return turns({2, 1, 0}, {rpy[2], rpy[1], rpy[0]}); }

Mat3<double> from_xyzw(const Source& at, const std::vector<double>& v) {
  const Eigen::Vector4d q(v[6], v[3], v[4], v[5]);
  if (!(std::abs(q.norm() - 1) < 1e-3)) refuse(at, "is no unit quaternion", "x y z qx qy qz qw of length 1");
  const Eigen::Vector4d unit = q.normalized();
  return so3::matrix<double>({unit[0], unit.tail<3>()});
}

/// <pose> of a link or frame; none is the identity.
Frame pose_of(const Tag& holder, std::vector<Source>& from) {
  const auto pose = holder.child("pose");
  if (!pose || pose->text().text.empty()) return {};
  const Source at = pose->text();
  from.push_back(at);
  const std::string format = pose->attribute_or("rotation_format", "euler_rpy");
  if (format == "quat_xyzw") {
    const auto v = numbers_of(at, 7);
    return {{v[0], v[1], v[2]}, from_xyzw(at, v)};
  }
  if (format != "euler_rpy")
    refuse(pose->attribute("rotation_format"), "is not known", "euler_rpy, quat_xyzw");
  const auto v = numbers_of(at, 6);
  const std::string degrees = pose->attribute_or("degrees", "false");
  const double unit = degrees == "true" || degrees == "1" ? kDegree : 1;
  return {{v[0], v[1], v[2]}, from_rpy(unit * Vec3<double>(v[3], v[4], v[5]))};
}

/// Where a frame of the model is on its link.
class SdfModel {
 public:
  explicit SdfModel(const Tag& model) : model_(model) {}

  Frame on_link(const Source& name, std::vector<Source>& from) const {
    const std::string link = link_of(name);
    return in(name.text, link, name, from, 0);
  }

 private:
  /// The link or frame of that name.
  Tag find(const Source& at, const std::string& name) const {
    for (const Tag& child : model_.children()) {
      const bool has_place = child.name() == "link" || child.name() == "frame";
      if (has_place && child.attribute_or("name", "") == name) return child;
    }
    refuse(at, fmt::format("leads to '{}', which is no link or frame of its model", name),
           "a <link> or <frame> of the model; frames of joints and of nested models are not followed");
  }

  /// Frames are attached to frames, the last one to a link.
  std::string link_of(const Source& name) const {
    std::string at = name.text;
    for (int i = 0; i < kLongestChain; ++i) {
      const Tag found = find(name, at);
      if (found.name() == "link") return at;
      at = found.attribute("attached_to").text;
    }
    refuse(name, "is attached in a circle, or through too many frames",
           "a chain of frames that ends at a link");
  }

  /// What a pose is relative to: its own word, what a frame is attached to, the model.
  static std::string relative_to(const Tag& tag) {
    const auto pose = tag.child("pose");
    const std::string said = pose ? pose->attribute_or("relative_to", "") : "";
    return said.empty() ? tag.attribute_or("attached_to", "__model__") : said;
  }

  /// `name` seen from the link; through the model where their poses meet only there.
  Frame in(const std::string& name, const std::string& link, const Source& at, std::vector<Source>& from,
           int depth) const {
    if (name == link) return {};
    if (depth > kLongestChain)
      refuse(at, "is placed in a circle, or through too many frames", "a chain of frames");
    if (name == "__model__") return inverse(in_model(link, at, from, depth + 1));
    const Tag tag = find(at, name);
    const Frame pose = pose_of(tag, from);
    return in_frame(in(relative_to(tag), link, at, from, depth + 1), pose);
  }

  Frame in_model(const std::string& name, const Source& at, std::vector<Source>& from, int depth) const {
    if (name == "__model__") return {};
    if (depth > kLongestChain)
      refuse(at, "is placed in a circle, or through too many frames", "a chain of frames");
    const Tag tag = find(at, name);
    const Frame pose = pose_of(tag, from);
    return in_frame(in_model(relative_to(tag), at, from, depth + 1), pose);
  }

  Tag model_;
};

/// URDF: <frame> or <drake:frame> with attributes link, xyz, rpy; or a link itself.
Frame urdf_frame(const Tag& robot, const Source& name, std::vector<Source>& from) {
  for (const Tag& child : robot.children()) {
    if (child.attribute_or("name", "") != name.text) continue;
    if (child.name() == "link") return {};
    if (child.name() != "frame" && child.name() != "drake:frame") continue;
    child.attribute("link");
    Frame out;
    if (!child.attribute_or("xyz", "").empty()) {
      from.push_back(child.attribute("xyz"));
      out.o = three(from.back());
    }
    if (!child.attribute_or("rpy", "").empty()) {
      from.push_back(child.attribute("rpy"));
      out.H = from_rpy(three(from.back()));
    }
    return out;
  }
  refuse(name, "is no frame or link of the robot", "the name of a <frame> or <link>");
}

/// The law, by its four words; `text` finds one.
template <class Text>
void read_bushing(ImportedJoint& joint, const Text& text) {
  joint.formulation = "drake_rpy";
  joint.K = Eigen::MatrixXd::Zero(6, 6);
  int row = 0;
  for (const char* word : {"drake:bushing_force_stiffness", "drake:bushing_torque_stiffness"}) {
    const Source at = text(word);
    const auto k = numbers_of(at, 3);
    check_stiffness(at, k);
    for (double value : k) joint.K(row, row) = value, ++row;
    joint.law_from.push_back(at);
  }
  for (const char* word : {"drake:bushing_force_damping", "drake:bushing_torque_damping"}) {
    const Source at = text(word);
    lose(joint, at, numbers_of(at, 3), kNoDamping);
  }
}

template <class Text, class Place>
ImportedJoint drake_joint(const Tag& tag, const char* program, const Text& text, const Place& place) {
  ImportedJoint joint;
  joint.program = program;
  joint.line = tag.line();
  const Source A = text("drake:bushing_frameA"), C = text("drake:bushing_frameC");
  joint.name = A.text + "-" + C.text;
  joint.a = place(A, joint.a_from);
  joint.b = place(C, joint.b_from);
  read_bushing(joint, text);
  return joint;
}

[[noreturn]] void refuse_none(const Tag& root) {
  refuse({root.line(), root.name(), "a model"}, "has no bushing", fmt::format("an element <{}>", kBushing));
}

}  // namespace

std::vector<ImportedJoint> read_drake_sdf(const XmlFile& file) {
  std::vector<ImportedJoint> out;
  for (const Tag& tag : file.root().all(kBushing)) {
    const SdfModel model(tag.parent());
    const auto text = [&](const char* word) { return tag.need(word).text(); };
    out.push_back(drake_joint(tag, "Drake SDF", text,
                              [&](const Source& name, auto& from) { return model.on_link(name, from); }));
  }
  if (out.empty()) refuse_none(file.root());
  return out;
}

std::vector<ImportedJoint> read_drake_urdf(const XmlFile& file) {
  std::vector<ImportedJoint> out;
  for (const Tag& tag : file.root().all(kBushing)) {
    const auto text = [&](const char* word) {
      return tag.need(word).attribute(
          std::string_view(word).find("_frame") == std::string_view::npos ? "value" : "name");
    };
    out.push_back(drake_joint(tag, "Drake URDF", text, [&](const Source& name, auto& from) {
      return urdf_frame(file.root(), name, from);
    }));
  }
  if (out.empty()) refuse_none(file.root());
  return out;
}

}  // namespace halfway::imports
