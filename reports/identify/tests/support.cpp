#include "reports/identify/tests/support.hpp"

#include "reference/scene/text/document.hpp"
#include "reference/truth/data.hpp"
#include "reports/identify/read_other.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>

namespace halfway::reports::tests {

std::string sample(const std::string& name) {
  return read_file(std::string(HALFWAY_IDENTIFY_SAMPLES) + "/" + name);
}

std::string fe_result(const std::string& name) { return read_file(reference::data_folder() / "fe" / name); }

std::string bushing(const std::string& name) {
  return read_file(std::string(HALFWAY_IMPORT_SAMPLES) + "/" + name);
}

Identified identified(const std::string& text, const std::string& law) {
  ReadCurves curves = read_data_file(text, law);
  Identified out{"sample.csv", std::move(curves.data), std::move(curves.notes), {}};
  out.found = reference::identify::identify(out.data);
  return out;
}

std::string refusal_of(const std::string& text) {
  try {
    identified(text);
    return "";
  } catch (const reference::Refusal& refusal) {
    return fmt::format("{}: {}", refusal.line, refusal.what());
  } catch (const reference::identify::NotIdentifiable& refusal) {
    return refusal.what();
  }
}

}  // namespace halfway::reports::tests
