#include "reports/identify/tests/support.hpp"

#include "reference/scene/text/document.hpp"
#include "reports/identify/read_csv.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>

namespace halfway::reports::tests {

std::string sample(const std::string& name) {
  return read_file(std::string(HALFWAY_IDENTIFY_SAMPLES) + "/" + name);
}

Identified identified(const std::string& text) {
  ReadCurves curves = read_csv(text);
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
