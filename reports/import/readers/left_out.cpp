// What is said where a library was not there when Halfway was configured.
#include "reports/import/readers/documents.hpp"
#include "reports/import/readers/readers.hpp"
#include "reports/import/record/text.hpp"

namespace halfway::imports {

#ifndef HALFWAY_PUGIXML
std::vector<ImportedJoint> read_xml(std::string_view) {
  refuse({1, "the file", "XML"}, "needs pugixml, which was not there when this was built",
         "files of other kinds; or install libpugixml-dev, and ./halfway import builds again");
}
#endif

#ifndef HALFWAY_YAML_CPP
reference::Document read_yaml(std::string_view) {
  refuse({1, "the file", "YAML"}, "needs yaml-cpp, which was not there when this was built",
         "files of other kinds; or install libyaml-cpp-dev, and ./halfway import builds again");
}
#endif

}  // namespace halfway::imports
