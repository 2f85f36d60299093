// OpenSim: <BushingForce>, in documents before and since version 30505. Frame 1 is our node a, frame 2 node
// b.
#include "reports/import/readers/xml.hpp"
#include "reports/import/record/frames.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <set>

namespace halfway::imports {
namespace {

constexpr int kMostFrames = 32;  // of offset frames

/// Three numbers, zeros where the element is missing, which is OpenSim's default.
Vec3<double> three_of(const Tag& tag, const char* word, std::vector<Source>& from) {
  const auto found = tag.child(word);
  if (!found) return Vec3<double>::Zero();
  from.push_back(found->text());
  const auto v = numbers_of(from.back(), 3);
  return {v[0], v[1], v[2]};
}

/// Point, m, and body-fixed x-y-z angles, rad.
Frame offset_of(const Tag& tag, const char* location, const char* orientation, std::vector<Source>& from) {
  const Vec3<double> o = three_of(tag, location, from);
  return {o, turns({0, 1, 2}, three_of(tag, orientation, from))};
}

/// The last part of a path such as ../bodyset/pelvis.
std::string last_part(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

/// What sockets may lead to, looked for once.
class Frames {
 public:
  explicit Frames(const Tag& root) {
    for (const Tag& frame : root.all("PhysicalOffsetFrame"))
      offsets_.emplace(frame.attribute_or("name", ""), frame);
    for (const Tag& body : root.all("Body")) bodies_.insert(body.attribute_or("name", ""));
  }

  /// Where the frame that a socket of the bushing names is on its body.
  Frame on_body(const Tag& bushing, const Source& socket, std::vector<Source>& from) const {
    Frame out;
    std::string name = last_part(socket.text);
    for (int i = 0; i < kMostFrames; ++i) {
      const auto frame = offset_frame(bushing, name);
      if (!frame && (name == "ground" || bodies_.contains(name))) return out;
      if (!frame)
        refuse(socket, fmt::format("leads to '{}', which is no offset frame or body of the document", name),
               "the path of a PhysicalOffsetFrame, of a Body, or ground");
      out = in_frame(offset_of(*frame, "translation", "orientation", from), out);
      name = last_part(frame->need("socket_parent").text().text);
    }
    refuse(socket, "leads round in a circle, or through too many frames",
           "a chain of offset frames that ends at a body");
  }

 private:
  /// The bushing's own before others of the document.
  std::optional<Tag> offset_frame(const Tag& bushing, const std::string& name) const {
    for (const Tag& frame : bushing.all("PhysicalOffsetFrame")) {
      if (frame.attribute_or("name", "") == name) return frame;
    }
    const auto found = offsets_.find(name);
    return found == offsets_.end() ? std::nullopt : std::optional(found->second);
  }

  std::map<std::string, Tag> offsets_{};
  std::set<std::string> bodies_{};
};

void read_places(ImportedJoint& joint, const Frames& frames, const Tag& tag) {
  const bool is_old = tag.child("body_1") || tag.child("body_2");
  if (is_old) {
    tag.need("body_1"), tag.need("body_2");
    joint.a = offset_of(tag, "location_body_1", "orientation_body_1", joint.a_from);
    joint.b = offset_of(tag, "location_body_2", "orientation_body_2", joint.b_from);
    return;
  }
  joint.a = frames.on_body(tag, tag.need("socket_frame1").text(), joint.a_from);
  joint.b = frames.on_body(tag, tag.need("socket_frame2").text(), joint.b_from);
}

ImportedJoint bushing_of(const Frames& frames, const Tag& tag) {
  ImportedJoint joint;
  joint.program = "OpenSim";
  joint.name = tag.attribute("name").text;
  joint.line = tag.line();
  joint.formulation = "simbody_xyz";
  read_places(joint, frames, tag);
  joint.K = Eigen::MatrixXd::Zero(6, 6);
  int row = 0;
  for (const char* word : {"translational_stiffness", "rotational_stiffness"}) {
    const Vec3<double> k = three_of(tag, word, joint.law_from);
    if (k.minCoeff() < 0) check_stiffness(joint.law_from.back(), {k[0], k[1], k[2]});
    for (int i = 0; i < 3; ++i, ++row) joint.K(row, row) = k[i];
  }
  for (const char* word : {"translational_damping", "rotational_damping"}) {
    if (const auto found = tag.child(word))
      lose(joint, found->text(), numbers_of(found->text(), 3), kNoDamping);
  }
  for (const char* word : {"appliesForce", "isDisabled"}) {
    const auto found = tag.child(word);
    if (found && (found->text().text == "false") == (std::string_view(word) == "appliesForce"))
      joint.lost.push_back(fmt::format("{}: the file switches this bushing off", named(found->text())));
  }
  return joint;
}

}  // namespace

std::vector<ImportedJoint> read_opensim(const XmlFile& file) {
  const Tag root = file.root();
  const Frames frames(root);
  std::vector<ImportedJoint> out;
  for (const Tag& tag : root.all("BushingForce")) out.push_back(bushing_of(frames, tag));
  for (const char* other : {"ExpressionBasedBushingForce", "FunctionBasedBushingForce"}) {
    for (const Tag& tag : root.all(other)) {
      const Source at{tag.line(), other, tag.attribute_or("name", "")};
      if (out.empty())
        refuse(at, "is a law of functions, with moments about axes of body 2",
               "BushingForce; others by hand as k1, k3, k5 or tables (reference/scenes/README.md)");
      out.front().notes.push_back(
          fmt::format("{} is left out: a law of functions, with moments about axes of body 2", named(at)));
    }
  }
  if (out.empty())
    refuse({root.line(), root.name(), "a document"}, "has no bushing", "an element <BushingForce>");
  return out;
}

}  // namespace halfway::imports
