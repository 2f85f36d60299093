#include "reports/import/readers/xml.hpp"

#include "reference/scene/text/document.hpp"
#include "reports/import/readers/readers.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace halfway::imports {
namespace {

constexpr int kDeepestElement = 64;  // elements inside each other: models have a dozen

/// Elements of a name, and how deep they are: without recursion, whatever the file.
struct Gatherer : pugi::xml_tree_walker {
  std::string_view name{};
  std::vector<pugi::xml_node> found{};
  int deepest = 0;
  pugi::xml_node deepest_node{};

  bool for_each(pugi::xml_node& node) override {
    if (depth() > deepest) deepest = depth(), deepest_node = node;
    if (node.name() == name) found.push_back(node);
    return deepest <= kDeepestElement;
  }
};

}  // namespace

XmlFile::XmlFile(std::string_view text) {
  for (std::size_t i = text.find('\n'); i != std::string_view::npos; i = text.find('\n', i + 1))
    ends_.push_back(std::ptrdiff_t(i));
  const auto result =
      document_.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!result) {
    refuse({line_at(result.offset), "the file", std::string(trimmed(text.substr(0, 40)))},
           fmt::format("is not XML ({})", result.description()), "a whole XML document");
  }
  Gatherer gatherer;
  document_.traverse(gatherer);
  if (gatherer.deepest > kDeepestElement)
    refuse({line_at(gatherer.deepest_node.offset_debug()), gatherer.deepest_node.name(), "an element"},
           fmt::format("is nested deeper than {} levels", kDeepestElement),
           fmt::format("up to {}", kDeepestElement));
}

int XmlFile::line_at(std::ptrdiff_t offset) const {
  return 1 + int(std::ranges::lower_bound(ends_, offset) - ends_.begin());
}

int Tag::line() const { return file_->line_at(node_.offset_debug()); }

Source Tag::text() const {
  std::string out;
  for (const pugi::xml_node part : node_.children()) {
    if (part.type() == pugi::node_pcdata || part.type() == pugi::node_cdata) out += part.value();
  }
  return {line(), name(), std::string(trimmed(out))};
}

Source Tag::attribute(const char* name) const {
  const pugi::xml_attribute found = node_.attribute(name);
  const Source out{line(), fmt::format("{}@{}", node_.name(), name), found.value()};
  if (!found) refuse(out, "is missing", "the attribute");
  return out;
}

std::optional<Tag> Tag::child(const char* name) const {
  const pugi::xml_node found = node_.child(name);
  if (!found) return std::nullopt;
  const Tag out(*file_, found);
  if (const pugi::xml_node twin = found.next_sibling(name))
    refuse(Tag(*file_, twin).text(), fmt::format("stands twice, also in line {}", out.line()), "one of them");
  return out;
}

Tag Tag::need(const char* name) const {
  if (const auto found = child(name)) return *found;
  refuse({line(), fmt::format("{}/{}", node_.name(), name), ""}, "is missing",
         fmt::format("an element <{}>", name));
}

std::vector<Tag> Tag::children() const {
  std::vector<Tag> out;
  for (const pugi::xml_node node : node_.children()) {
    if (node.type() == pugi::node_element) out.emplace_back(*file_, node);
  }
  return out;
}

std::vector<Tag> Tag::all(std::string_view name) const {
  Gatherer gatherer;
  gatherer.name = name;
  pugi::xml_node node = node_;
  node.traverse(gatherer);
  std::vector<Tag> out;
  for (const pugi::xml_node found : gatherer.found) out.emplace_back(*file_, found);
  return out;
}

std::vector<ImportedJoint> read_xml(std::string_view text) {
  const XmlFile file(text);
  const Tag root = file.root();
  const std::string name = root.name();
  if (name == "sdf") return read_drake_sdf(file);
  if (name == "robot") return read_drake_urdf(file);
  if (name == "OpenSimDocument") return read_opensim(file);
  const Source at{root.line(), "the root element", name};
  if (name == "mujoco")
    refuse(at,
           "is MJCF: equality/weld is a soft constraint, whose stiffness depends on masses, not a bushing",
           "a scene written by hand (reference/scenes/README.md)");
  refuse(at, "is no format known here", "sdf, robot (URDF), OpenSimDocument");
}

}  // namespace halfway::imports
