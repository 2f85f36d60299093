// What `halfway identify` found, in the forms that it is told in.
#pragma once

#include "reference/identify/identification.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace halfway::reports {

struct Identified {
  std::string source{};  ///< the file, as the caller named it
  reference::identify::Data data{};
  std::vector<std::string> notes{};
  reference::identify::Identification found{};
};

/// The joint that the data follow: of the catalog's formulations that noise can explain the best that is
/// conservative and knows no order of the bodies; else the best.
struct BestJoint {
  std::string formulation;
  reference::identify::JointValues values;
  reference::identify::Fit fit;
  double xi;
};
BestJoint best_joint(const Identified& what);

/// Root mean square of the residual in each channel, SI; NaN of a channel without numbers.
std::array<double, reference::identify::kChannels> channel_errors(const reference::identify::Data& data,
                                                                  const reference::identify::Fit& fit);

/// What was found, a line each: "stiffness about axes", its values with their intervals.
struct SummaryLine {
  std::string name, text;
};
std::vector<SummaryLine> summary_lines(const Identified& what);

/// File, kind, rows, scatter.
std::string summary_head(const Identified& what);

/// Both for the terminal.
std::string identify_summary(const Identified& what);

/// For programs: {"schema": "halfway-identify-1", ...}; reports/identify/README.md has its keys.
nlohmann::ordered_json identify_json(const Identified& what);

/// One page that opens offline: what was found, residuals, second order, formulations, what was assumed.
std::string identify_page(const Identified& what);

/// A scene of the best joint, under the largest load of the data. Our own reader takes it.
std::string identify_scene(const Identified& what);

}  // namespace halfway::reports
