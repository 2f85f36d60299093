#include "reports/advise/views/page.hpp"

#include "reports/advise/views/charts.hpp"
#include "reports/advise/views/words.hpp"
#include "reports/cli/streams.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::advise {
namespace {

std::string paragraph(const std::string& text, const char* kind) {
  return text.empty() ? "" : fmt::format("<p class=\"{}\">{}</p>\n", kind, reports::escaped(text));
}

/// The summary's lines: the advice as the answer, the others below it.
std::string answer_html(const Advice& advice) {
  std::string out, lines = summary_text(advice);
  for (std::size_t begin = 0; begin < lines.size();) {
    const std::size_t end = lines.find('\n', begin);
    const std::string line = lines.substr(begin, end - begin);
    out += paragraph(line.substr(std::min(line.find_first_not_of(' '), line.size())),
                     line.starts_with("Advice") ? "answer" : "note");
    begin = end + 1;
  }
  return out;
}

std::string row_html(const Advice& advice, std::size_t i) {
  const Judged& j = advice.judged[i];
  const char* kind = advice.choice == i ? "chosen" : j.suffices(advice.question.tolerance) ? "" : "unmet";
  return fmt::format(
      "<tr class=\"{}\"><th scope=\"row\"><code>{}</code></th><td class=\"number\">{}</td><td "
      "class=\"number\">{}</td><td "
      "class=\"number\">{}</td><td>{}</td></tr>\n",
      kind, reports::escaped(j.candidate.name(advice.truth.scene.joint.kind)),
      j.cost.ns > 0 ? fmt::format("{:.3g}", j.cost.ns) : "",
      std::isfinite(j.error) ? percent(j.error) : "ends",
      j.reach.rotation > 0 ? fmt::format("{:.3g}", j.reach.rotation / kDegree) : "",
      reports::escaped(remark(advice, i)));
}

std::string table_html(const Advice& advice) {
  std::string out = fmt::format(
      "<section class=\"part\"><h2>Every candidate, by cost</h2>\n<div class=\"scroll\"><table "
      "class=\"compact\"><thead><tr><th "
      "scope=\"col\">candidate</th><th scope=\"col\">ns</th><th scope=\"col\">{}</th><th "
      "scope=\"col\">within it to, deg</th><th "
      "scope=\"col\">what is said of it</th></tr></thead>\n<tbody>\n",
      word_for_error(advice));
  for (std::size_t i = 0; i < advice.judged.size(); ++i) out += row_html(advice, i);
  return out +
         "</tbody></table></div>\n<p class=\"note\">ns: loads and tangent of one joint by its kernel, data "
         "in cache, on this machine; "
         "the kernel was checked against 50 digits before it was timed. linearized: loads alone, its tangent "
         "is one matrix.</p></section>\n";
}

std::string figure(const char* title, const std::string& svg, const std::string& note) {
  if (svg.empty()) return "";
  return fmt::format(
      "<section class=\"part half\"><h2>{}</h2>\n<figure>{}<figcaption>{}</figcaption></figure></section>\n",
      title, svg, note);
}

}  // namespace

std::string advice_page(const Advice& advice, const std::vector<MapColumn>& map, const std::string& command) {
  std::string out =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, "
      "initial-scale=1\">\n<link rel=\"icon\" href=\"data:,\">\n";
  out += fmt::format("<title>Halfway: advice for {}</title>\n<style>\n{}</style>\n</head>\n<body>\n",
                     reports::escaped(advice.question.scene.name), page_style());
  out +=
      "<header class=\"top\"><p class=\"brand\">Halfway <span>which joint does a scene need, and no "
      "more</span></p></header>\n<main id=\"main\">\n";
  out += fmt::format(
      "<section class=\"headline\"><h1>{}</h1>\n{}<p class=\"note\"><code>{}</code></p></section>\n",
      reports::escaped(advice.question.scene.title), answer_html(advice), reports::escaped(command));
  out += "<div class=\"parts\">\n";
  out += figure("What each costs and misses", evidence_svg(advice),
                "Left is faster, down is truer; hollow: out whatever its error. A mark's title says why.");
  out += figure("Where it is enough", map_svg(advice, map),
                "The cheapest law within the tolerance for this load's direction, as the stiffnesses are "
                "drawn together or apart; map.csv has the same.");
  out += table_html(advice);
  return out + fmt::format("</div>\n</main>\n<script>\n{}</script>\n</body>\n</html>\n", page_script());
}

}  // namespace halfway::advise
