#include "reports/identify/read_other.hpp"

#include "reference/scene/text/document.hpp"
#include "reports/identify/columns.hpp"
#include "reports/import/readers/readers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace halfway::reports {
namespace {

namespace id = reference::identify;
using Json = nlohmann::json;

id::Vec6 six(const Json& json, const char* head, const char* tail) {
  id::Vec6 out;
  for (int i = 0; i < 6; ++i) out[i] = json.at(i < 3 ? head : tail).at(std::size_t(i % 3)).get<double>();
  return out;
}

id::Mat6 matrix(const Json& rows) {
  id::Mat6 out;
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) out(i, j) = rows.at(std::size_t(i)).at(std::size_t(j)).get<double>();
  }
  return out;
}

id::LoadCase full_case(std::string name) {
  id::LoadCase one;
  one.name = std::move(name);
  one.has_load.fill(true), one.has_motion.fill(true);
  return one;
}

/// Of those that the file has the one that is asked for.
std::string law_of(const std::string& asked, const std::vector<std::string>& laws) {
  if (asked.empty() && laws.size() == 1) return laws.front();
  if (std::find(laws.begin(), laws.end(), asked) != laws.end()) return asked;
  refuse_at(1, asked.empty() ? "the file" : "--law " + asked,
            asked.empty() ? "has results of several material laws" : "is none of the file's",
            fmt::format("--law with one of {}", fmt::join(laws, ", ")));
}

/// Curves of one load each: {"curves": [{"law", "points": [{"factor", "d", "theta"}]}]}.
id::Data curves_of(const Json& file, const std::string& asked) {
  const Json& curves = file.at("result").at("curves");
  std::vector<std::string> laws;
  for (const Json& curve : curves) laws.push_back(curve.at("law").get<std::string>());
  const std::string law = law_of(asked, laws);
  const id::Vec6 load = six(file.at("inputs"), "force", "moment");
  id::Data out;
  for (const Json& curve : curves) {
    if (curve.at("law") != law) continue;
    id::LoadCase one = full_case(curve.at("body").get<std::string>() + ", " + law);
    for (const Json& point : curve.at("points")) {
      one.loads.push_back(point.at("factor").get<double>() * load);
      one.motions.push_back(six(point, "d", "theta"));
    }
    if (!one.loads.empty()) out.cases.push_back(std::move(one));
  }
  return out;
}

/// Compliance and couplings, q = C l + (l^T Q_k l): of the finest mesh of the element that has most of them.
id::Data couplings_of(const Json& file, const std::string& asked, std::vector<std::string>& notes) {
  constexpr double kTurn = 1e-3;  // of each moment alone, rad
  const Json& runs = file.at("result").at("runs");
  const Json* finest = nullptr;
  for (const Json& run : runs) {
    if (!finest || run.at("level").get<int>() > finest->at("level").get<int>()) finest = &run;
  }
  if (!finest) refuse_at(1, "result.runs", "is empty", "runs of a mesh");
  std::vector<std::string> laws;
  for (const auto& [name, unused] : finest->at("couplings").items()) laws.push_back(name);
  const std::string law = law_of(asked, laws);
  const id::Mat6 C = matrix(finest->at("compliance"));
  std::array<id::Mat6, 6> Q;
  for (std::size_t k = 0; k < 6; ++k) Q[k] = matrix(finest->at("couplings").at(law).at(k));
  id::Data out;
  for (int i = 3; i < 6; ++i) {
    const int j = 3 + (i - 2) % 3;
    id::LoadCase one =
        full_case(fmt::format("{} and {}", id::kLoadNames[std::size_t(i)], id::kLoadNames[std::size_t(j)]));
    for (const double factor : {-1., -0.5, 0.5, 1.}) {
      id::Vec6 load = id::Vec6::Zero(), motion;
      for (const int c : {i, j}) load[c] = factor * kTurn / C(c, c);
      motion = C * load;
      for (int k = 0; k < 6; ++k) motion[k] += load.dot(Q[std::size_t(k)] * load);
      one.loads.push_back(load);
      one.motions.push_back(motion);
    }
    out.cases.push_back(std::move(one));
  }
  notes.push_back(fmt::format(
      "compliance and couplings of {}, {}, {} of level {}, of which moments in pairs are made, both ways",
      file.at("result").at("body").get<std::string>(), law, finest->at("element").get<std::string>(),
      finest->at("level").get<int>()));
  return out;
}

/// What a file of large or zero numbers makes of them.
void check_finite(const id::Data& data) {
  for (const id::LoadCase& one : data.cases) {
    for (std::size_t row = 0; row < one.loads.size(); ++row) {
      if (one.loads[row].allFinite() && one.motions[row].allFinite()) continue;
      refuse_at(one.line, reference::shortened(one.name),
                fmt::format("has loads or motions at point {} that are not finite", row + 1),
                "results whose loads and motions are numbers, and compliances above zero");
    }
  }
}

/// Only rotations under moments: an angular joint, whatever moved besides.
void make_angular(id::Data& data) {
  for (const id::LoadCase& one : data.cases) {
    for (const id::Vec6& load : one.loads) {
      if (!load.head<3>().isZero(0)) return;
    }
  }
  data.kind = Kind::angular;
}

}  // namespace

ReadCurves read_bus(std::string_view text) {
  const auto joint = imports::read_teim_orbit(text, {}).front();
  ReadCurves out;
  for (int i = 0; i < 6; ++i) {
    id::LoadCase one;
    one.name = std::string(id::kMotionNames[std::size_t(i)]) + " alone";
    one.line = joint.law_from[std::size_t(i)].line;
    one.held.fill(true);
    one.has_load[std::size_t(i)] = one.has_motion[std::size_t(i)] = true;
    std::vector<double> x, y;
    if (!joint.axes.empty()) x = joint.axes[std::size_t(i)].x, y = joint.axes[std::size_t(i)].y;
    if (x.empty()) {
      const double k = joint.axes.empty() ? joint.K(i, i) : joint.axes[std::size_t(i)].stiffness;
      for (const double factor : {-1., -0.5, 0.5, 1.})
        x.push_back(factor * (i < 3 ? 1e-3 : 1e-2)), y.push_back(k * x.back());
    }
    for (std::size_t row = 0; row < x.size(); ++row) {
      one.loads.push_back(id::Vec6::Unit(i) * y[row]);
      one.motions.push_back(id::Vec6::Unit(i) * x[row]);
    }
    out.data.cases.push_back(std::move(one));
  }
  check_finite(out.data);
  out.notes = joint.notes;
  for (const std::string& what : joint.lost) out.notes.push_back("lost: " + what);
  out.notes.emplace_back(
      "a curve for each axis, the others held: nothing tells how they go together; ./halfway import keeps "
      "the curves point by point");
  return out;
}

ReadCurves read_fe(std::string_view text, const std::string& law) {
  ReadCurves out;
  try {
    const Json file = Json::parse(text);
    out.data =
        file.at("result").contains("curves") ? curves_of(file, law) : couplings_of(file, law, out.notes);
  } catch (const Json::exception& error) {
    refuse_at(1, "the file", fmt::format("is JSON, but no result of reference/data/fe ({})", error.what()),
              "a text of columns, or a file such as reference/data/fe/fig_7.json");
  }
  check_finite(out.data);
  make_angular(out.data);
  if (out.data.cases.empty()) refuse_at(1, "the file", "has no point", "curves of one point or more");
  return out;
}

ReadCurves read_data_file(std::string_view text, const std::string& law) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && text[first] == '{') return read_fe(text, law);
  if (!law.empty())
    refuse_at(1, "--law " + law, "the file has no material laws", "it with results of finite elements");
  if (text.find("[FX_CURVE]") != std::string_view::npos ||
      text.find("[MDI_HEADER]") != std::string_view::npos)
    return read_bus(text);
  return read_csv(text);
}

}  // namespace halfway::reports
