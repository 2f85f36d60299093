#include "reports/cli/streams.hpp"
#include "reports/identify/page_text.hpp"
#include "reports/identify/residuals.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

namespace halfway::reports {
namespace {

namespace id = reference::identify;

std::string section(const char* title, const std::string& content) {
  return content.empty() ? "" : fmt::format("<section><h2>{}</h2>\n{}</section>\n", title, content);
}

std::string cells(const char* tag, const std::vector<std::string>& texts) {
  std::string out = "<tr>";
  for (const std::string& text : texts) out += fmt::format("<{0}>{1}</{0}>", tag, escaped(text));
  return out + "</tr>\n";
}

std::string table(const std::vector<std::string>& heads, const std::string& rows) {
  return fmt::format("<div class=\"scroll\"><table><thead>{}</thead><tbody>\n{}</tbody></table></div>\n",
                     cells("th", heads), rows);
}

std::string found_section(const Identified& what) {
  std::string rows;
  for (const auto& [name, text] : summary_lines(what))
    rows += fmt::format("<tr><th>{}</th><td>{}</td></tr>\n", escaped(name), escaped(text));
  return section("What was found",
                 fmt::format("<p>{}</p>\n<div class=\"scroll\"><table><tbody>\n{}</tbody></table></div>\n",
                             escaped(summary_head(what)), rows));
}

std::string stages_section(const Identified& what) {
  if (what.data.kind == Kind::linear) return "";
  const double closest = what.found.stages[what.found.closest].fit.variance;
  std::string rows;
  for (const id::StageFit& one : what.found.stages)
    rows += cells("td", {id::to_string(one.stage), fmt::format("{}", one.fit.freedom.active.size()),
                         fmt::format("{:.4g}", std::sqrt(one.fit.variance / closest)),
                         fmt::format("{:.2g}", one.probability),
                         &one == &what.found.chosen_stage() ? "shown above"
                         : one.probability < id::kRejected  ? "rejected"
                                                            : ""});
  return section("Second order", table({"what is fitted", "unknowns", "scatter over that of the closest",
                                        "probability that noise does it", ""},
                                       rows));
}

std::string catalog_section(const Identified& what) {
  std::string rows;
  for (const id::CatalogFit& one : what.found.catalog) {
    if (one.left_out.empty())
      rows += cells("td", {one.name, one.is_conservative ? "yes" : "no", fmt::format("{:.4g}", one.error),
                           fmt::format("{:.2g}", one.probability)});
    else
      rows += cells("td", {one.name, one.is_conservative ? "yes" : "no", "left out: " + one.left_out, ""});
  }
  return rows.empty() ? ""
                      : section("Formulations", table({"formulation", "conservative", "times the scatter",
                                                       "probability that noise does it"},
                                                      rows));
}

std::string notes_section(const Identified& what) {
  std::string out;
  for (const std::string& note : what.notes) out += fmt::format("<li>{}</li>\n", escaped(note));
  return out.empty() ? "" : section("What was assumed", "<ul>\n" + out + "</ul>\n");
}

void fill(std::string& page, const std::string& mark, const std::string& text) {
  const std::size_t at = page.find(mark);
  if (at != std::string::npos) page.replace(at, mark.size(), text);
}

}  // namespace

std::string identify_page(const Identified& what) {
  std::string out = identify_template();
  fill(out, "data-state=\"loading\"", "data-state=\"ready\"");
  fill(out, "@DESCRIPTION@", "A joint identified from measured curves.");
  fill(out, "@TITLE@", "Halfway: " + escaped(what.source));
  fill(out, "@STYLE@", identify_style());
  fill(out, "@SUBTITLE@", "a joint from measured curves");
  // Nothing on it is drawn by a script.
  fill(out, "<noscript><p>@NOSCRIPT@</p></noscript>",
       fmt::format("<h1>{}</h1>\n", escaped(std::filesystem::path(what.source).filename().string())) +
           found_section(what) +
           section("What is left", "<figure class=\"chart\">" + residuals_svg(what) + "</figure>\n") +
           stages_section(what) + catalog_section(what) + notes_section(what));
  fill(out, "@DATA@\n<script>\n@SCRIPT@\n</script>\n", "");
  return out;
}

}  // namespace halfway::reports
