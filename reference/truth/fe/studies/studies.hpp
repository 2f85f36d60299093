// THE list of 3D analyses whose results are kept as data: what each follows from, and how it is made again.
#pragma once

#include "reference/truth/fe/studies/characterisation.hpp"
#include "reference/truth/fe/studies/curves.hpp"

#include <optional>

namespace halfway::reference::fe {

/// Told after each part: parts done, parts in all, what was done.
using Report = std::function<void(int, int, const std::string&)>;

struct Study {
  std::string name;       ///< its file is data/fe/<name>.json
  std::string what;       ///< for people
  nlohmann::json inputs;  ///< geometry, material, meshes, loads, version of the generator
  std::function<nlohmann::json(const Report&)> compute;
};

const std::vector<Study>& studies();
/// Throws std::invalid_argument naming the value and what is allowed.
const Study& study_named(const std::string& name);

/// Content address: a UUID of the inputs' text. Other inputs, other key.
std::string key_of(const Study& study);

/// Where the result is kept, relative to the data folder.
std::string file_of(const Study& study);

/// The kept result; none when there is no file or when its key is not that of today's inputs.
std::optional<nlohmann::json> kept(const Study& study);
/// The same by name.
std::optional<nlohmann::json> kept(const std::string& name);

/// Runs the study and gives its file's content: what, key, inputs, result.
nlohmann::json regenerate(const Study& study, const Report& report);

/// The kept results in their types, in the order of studies(); what is missing or stale is left out.
std::vector<Characterisation> kept_characterisations();
std::vector<SolidCurve> kept_curves();
/// Of the bearing's fitted families.
std::vector<Characterisation> kept_bearings();

}  // namespace halfway::reference::fe
