// What a scene's answers are held against: the best truth at hand.
#pragma once

#include "reference/scene/scene.hpp"
#include "reports/advise/model/answers.hpp"

#include <functional>
#include <limits>
#include <string>

namespace halfway::advise {

enum class TruthKind {
  none,   ///< nothing: laws are compared with each other, and how far they are apart is no error
  rod,    ///< the geometrically exact rod that the joint stands for
  chain,  ///< as many joints one after the other as are named
  body,   ///< the kept 3D analysis of the scene's body
  form,  ///< the paper's form of the scene at 50 digits: how exact is the arithmetic, and which laws are that
  table  ///< the user's own: load factors and outputs of a file
};
const char* to_string(TruthKind kind);

struct Truth {
  TruthKind kind = TruthKind::none;
  std::string described;   ///< in one line, with what it does not know
  reference::Scene scene;  ///< what laws are solved with: of a 3D body the compliance of its very mesh
  /// At load factors, ascending, up to the last row of data.
  std::function<Answers(const std::vector<double>&)> at;
  std::vector<double> rows{};       ///< the load factors of data; empty: any can be asked for
  bool is_smooth = true;            ///< data between whose rows can be read; else `at` has those rows alone
  Measure measure = Measure::norm;  ///< what its users look at

  double last() const { return rows.empty() ? std::numeric_limits<double>::infinity() : rows.back(); }
};

/// "auto": the kept 3D body that the scene is of, or the rod that it says the length of, else none. "rod",
/// "chain:N", "body", "form", "none", or a file NAME.csv. Throws BadInput, naming what the scene is not.
Truth truth_of(const reference::Scene& scene, const std::string& name);

/// Each of them; all but none_truth throw BadInput where the scene is not of that sort.
Truth none_truth(const reference::Scene& scene);
Truth rod_truth(const reference::Scene& scene);
Truth chain_truth(const reference::Scene& scene, int joints);
Truth body_truth(const reference::Scene& scene);
Truth form_truth(const reference::Scene& scene);
Truth table_truth(const reference::Scene& scene, const std::string& file);

/// Is it the scene of a body whose 3D analysis is kept?
bool has_body(const reference::Scene& scene);
/// Does it say the length of the rod that it stands for, and is it loaded as one can be solved?
bool has_rod(const reference::Scene& scene);

}  // namespace halfway::advise
