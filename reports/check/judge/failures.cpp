// A failure as a file that somebody else can act on.
#include "reports/check/judge/causes.hpp"
#include "reports/check/judge/verdict.hpp"
#include "reports/cli/streams.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace halfway::check {
namespace {

/// How many of its numbers a person would have to type: those that are no 0, 1 or tenth.
int numbers_in(const Ask& ask) {
  int count = 0;
  const auto add = [&](const auto& values) {
    for (const double x : values.reshaped())
      count += std::abs(10 * x - std::round(10 * x)) > 1e-12 ? 3 : x != 0 && x != 1;
  };
  for (const reference::AskedBody* body : {&ask.a, &ask.b})
    add(body->x), add(body->q), add(body->o), add(body->h);
  add(ask.K_f), add(ask.K_m);
  return count;
}

/// Questions that are simpler than this one by one thing.
std::vector<Ask> simpler(const Ask& ask) {
  std::vector<Ask> out;
  const auto with = [&](const auto& change) {
    Ask other = ask;
    change(other);
    if (numbers_in(other) < numbers_in(ask)) out.push_back(other);
  };
  with([](Ask& a) { a.b.x -= a.a.x, a.a = {}; });
  with([](Ask& a) { a.a.o.setZero(), a.b.o.setZero(); });
  with([](Ask& a) { a.a.h = a.b.h = Eigen::Vector4d(1, 0, 0, 0); });
  with([](Ask& a) { a.a.x.setZero(); });
  with([](Ask& a) { a.a.q = Eigen::Vector4d(1, 0, 0, 0); });
  with([](Ask& a) { a.K_m.setZero(); });
  with([](Ask& a) { a.K_f.setZero(); });
  for (int i = 0; i < 3; ++i) {
    with([i](Ask& a) { a.b.x[i] = 0; });
    with([i](Ask& a) { a.b.q[i + 1] = 0, a.b.q.normalize(); });
    with([i](Ask& a) { a.K_f(i, i) = 1; });
    with([i](Ask& a) { a.K_m(i, i) = 1; });
    with([i](Ask& a) { a.b.x[i] = std::round(a.b.x[i] * 10) / 10; });
  }
  return out;
}

/// The simplest question found that still fails by at least a tenth as much.
Ask smallest(Ask ask, const Single& property, const Answerer& joint, double limit) {
  const double least = std::max(limit, 0.1 * property.defect(joint, {ask}).worst.value());
  for (bool found = true; found;) {
    found = false;
    for (const Ask& other : simpler(ask)) {
      if (!(property.defect(joint, {other}).worst.value() > least)) continue;
      ask = other;
      found = true;
      break;
    }
  }
  return ask;
}

nlohmann::json list(const TwelveLoads& q) { return std::vector<double>(q.data(), q.data() + 12); }

/// As the program was asked, in its own words, and what it said.
struct Exchange {
  Ask asked;
  std::optional<TwelveLoads> said;
};

std::string file_name(const std::string& folder, std::string id, const char* ending) {
  std::ranges::replace(id, '/', '.');
  return folder + "/" + id + ending;
}

/// What a maintainer is sent: the case, what was expected and found, the cause and the formula of the mend.
std::string page(const Verdict& v, const Result& r, const nlohmann::ordered_json& facts) {
  std::string out = fmt::format(
      "# {}: {}\n\nIt does not hold: relative defect {:.2g}, where {:.2g} is left by rounding.\n\n",
      reports::printable(v.hello.name), r.title, r.value, r.limit);
  out += fmt::format("Expected: `{}`\n\n", r.law);
  if (facts.contains("asked")) {
    out += "Smallest case found, asked in turn:\n\n```json\n";
    for (const auto& one : facts["asked"]) out += one.dump() + "\n";
    out +=
        "```\n\nUnits m, N, N m, N/m, N m/rad; q, h are quaternions (w, x, y, z), body axes to global and "
        "joint axes to body; "
        "loads are force and moment on a, then on b, about the bodies' origins, global axes.\n\n";
  } else {
    out += fmt::format("Worst: {}\n\n", r.where);
  }
  for (const std::string& words : v.identity.convention.words())
    out += fmt::format("Convention: {}.\n", words);
  const Cause* cause = v.is_known ? find_cause(v.identity.name, r.id) : nullptr;
  if (cause) out += fmt::format("\nCause: {}\n\nMend: {}\n", cause->why, cause->fix);
  if (facts.contains("repeat"))
    out += fmt::format("\nTo repeat:\n\n```sh\n{}\n```\n", facts["repeat"].get<std::string>());
  return out;
}

}  // namespace

std::vector<std::string> write_failures(const Verdict& v, const std::string& folder, Program& program) {
  std::vector<Exchange> exchanges;
  const Answerer heard = [&](const Ask& ask) -> TwelveLoads {
    const auto said = program.is_live() ? program.ask({"again"}, {ask})[0].loads : std::nullopt;
    exchanges.push_back({ask, said});
    return said.value_or(TwelveLoads::Constant(std::numeric_limits<double>::quiet_NaN()));
  };
  const Answerer joint = along_road(v.hello, reference::translated(heard, v.identity.convention));
  const auto line = [&](const Ask& ask) { return request_line("again", ask, !v.hello.linear_angular, ""); };
  std::vector<std::string> files;
  const auto write = [&](const Result& r, const char* ending, const std::string& text) {
    files.push_back(file_name(folder, r.id, ending));
    reports::write_file(files.back(), text);
  };
  for (const Result& r : v.results) {
    if (r.status != Status::fail && r.status != Status::expected_fail) continue;
    nlohmann::ordered_json out{
        {"id", r.id}, {"held", r.title}, {"equation", r.law}, {"defect", r.value}, {"limit", r.limit}};
    const auto property = std::ranges::find(singles(), r.id, &Single::id);
    if (r.at && property != singles().end()) {
      const Ask ask = program.is_live() ? smallest(*r.at, *property, joint, r.limit) : *r.at;
      exchanges.clear();
      const double again = property->defect(joint, {ask}).worst.value();
      if (program.is_live()) out["defect"] = again;
      out["digits_lost"] = std::log10(out["defect"].get<double>() / r.limit);
      out["convention"] = v.identity.convention.words();
      for (const Exchange& e : exchanges) {
        nlohmann::ordered_json one{{"request", nlohmann::ordered_json::parse(line(e.asked))}};
        if (e.said) one["loads"] = list(*e.said);
        out["asked"].push_back(one);
      }
      out["repeat"] = program.repeat(line(exchanges.front().asked));
      write(r, ".json", out.dump(1) + "\n");
    }
    write(r, ".md", page(v, r, out));
  }
  return files;
}

}  // namespace halfway::check
