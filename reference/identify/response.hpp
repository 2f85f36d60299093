// What a model answers to the rows of the data: equilibrium where node b is loaded, loads where it is held.
#pragma once

#include "reference/identify/model.hpp"

#include <functional>
#include <vector>

namespace halfway::reference::identify {

/// A model for a vector of unknowns.
using MakeModel = std::function<Model(const Unknowns&)>;

/// The motion of node b at a row, its loaded components in equilibrium; `found` is false where Newton finds
/// none.
struct Equilibrium {
  Vec6 motion;
  Loads loads;
  bool found;
};
/// Newton from `start` in the loaded components; the held ones are those of the row.
Equilibrium equilibrium(const Model& model, Kind kind, const LoadCase& one, std::size_t row,
                        const Vec6& start);

/// All measured numbers in the order case, row, component.
struct Response {
  Eigen::VectorXd values;      ///< NaN at rows without equilibrium
  Eigen::MatrixXd by_unknown;  ///< a column for each of `active`; empty where not asked
  std::vector<Vec6> motions;   ///< of every row
};

/// @param active  places of the unknowns that derivatives are wanted of
/// @param warm    motions to start from, of an earlier response; may be empty
Response respond(const Data& data, const MakeModel& make, const Unknowns& p, const std::vector<int>& active,
                 bool with_derivative, const std::vector<Vec6>& warm);

/// Measured numbers, and the channel of each, in the same order.
Eigen::VectorXd measured(const Data& data);
std::vector<int> channels(const Data& data);

}  // namespace halfway::reference::identify
