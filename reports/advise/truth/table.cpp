// A truth of the user's own: a file of comma-separated values, as `run` writes its curves.
#include "reports/advise/truth/read_table.hpp"
#include "reports/advise/truth/truth.hpp"
#include "reports/cli/errors.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace halfway::advise {

Truth table_truth(const reference::Scene& scene, const std::string& file) {
  if (!std::filesystem::is_regular_file(file))
    throw reports::BadInput(fmt::format("--truth {}: no such file; needed: columns factor, {}", file,
                                        fmt::join(scene.outputs, ", ")));
  const Answers rows = read_table(reports::read_file(file), scene.outputs, file);
  Truth out;
  out.kind = TruthKind::table;
  out.measure = Measure::each;
  out.described =
      fmt::format("{}, {} rows up to load factor {:g}", file, rows.factor.size(), rows.factor.back());
  out.scene = scene;
  out.scene.outputs = rows.outputs;
  out.rows = rows.factor;
  out.is_smooth = false;
  out.at = [rows](const std::vector<double>& factors) {
    Answers some = rows;
    some.factor.resize(std::min(factors.size(), rows.factor.size()));
    some.value.resize(some.factor.size());
    return some;
  };
  return out;
}

}  // namespace halfway::advise
