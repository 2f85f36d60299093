// XML through pugixml, with line numbers and refusals.
#pragma once

#include "reports/import/record/text.hpp"

#include <pugixml.hpp>

#include <optional>

namespace halfway::imports {

class XmlFile;

/// One element, and where it stands.
class Tag {
 public:
  Tag(const XmlFile& file, pugi::xml_node node) : file_(&file), node_(node) {}

  std::string name() const { return node_.name(); }
  int line() const;
  /// NAME = its text.
  Source text() const;
  /// NAME@ATTRIBUTE = its value; refused where it is missing.
  Source attribute(const char* name) const;
  std::string attribute_or(const char* name, const char* otherwise) const {
    return node_.attribute(name).as_string(otherwise);
  }
  /// Refused where it stands twice.
  std::optional<Tag> child(const char* name) const;
  Tag need(const char* name) const;
  std::vector<Tag> children() const;
  Tag parent() const { return {*file_, node_.parent()}; }
  /// Itself or what it holds, at any depth, in the order of the file.
  std::vector<Tag> all(std::string_view name) const;

 private:
  const XmlFile* file_;
  pugi::xml_node node_;
};

class XmlFile {
 public:
  explicit XmlFile(std::string_view text);
  XmlFile(const XmlFile&) = delete;
  Tag root() const { return {*this, document_.document_element()}; }
  int line_at(std::ptrdiff_t offset) const;

 private:
  std::vector<std::ptrdiff_t> ends_;  ///< of lines
  pugi::xml_document document_;
};

std::vector<ImportedJoint> read_drake_sdf(const XmlFile& file);
std::vector<ImportedJoint> read_drake_urdf(const XmlFile& file);
std::vector<ImportedJoint> read_opensim(const XmlFile& file);

}  // namespace halfway::imports
