#include "reference/truth/fe/studies/studies.hpp"

#include "reference/truth/data.hpp"
#include "reference/truth/fe/studies/study_makers.hpp"

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>

#include <stdexcept>

namespace halfway::reference::fe {
namespace {

std::vector<Study> make_studies() {
  const std::vector<MeshPlan> meshes = {{ElementKind::hex20, {4, 6, 9, 12, 15}},
                                        {ElementKind::hex27, {4, 6, 9}},
                                        {ElementKind::hex20_full, {4, 6, 9}}};
  std::vector<Study> list;
  for (const Body& body : bodies()) list.push_back(characterisation_study(body, meshes));
  const CurvePlan curves[] = {
      {"fig_3", "Fig. 3: parallelepiped under a skewed moment", "c2_parallelepiped_small", "block", 9},
      {"fig_6", "Fig. 6: frustum, top clamped", "c4_frustum", "frustum_top", 6},
      {"fig_6_base", "Fig. 6 with the base clamped", "c4_frustum", "frustum_base", 6},
      {"fig_7", "Fig. 7: parallelepiped, compression and shear", "c6_compression_shear", "block", 9},
      {"range_block_moment", "Parallelepiped up to 300 N m", "c2_parallelepiped_small", "block", 4, 300},
      {"range_frustum_moment", "Frustum, top clamped, up to 10 N m", "c4_frustum", "frustum_top", 4, 10},
      {"range_block_force", "Parallelepiped, compression and shear up to 6 N", "c6_compression_shear",
       "block", 4, 6}};
  for (const CurvePlan& plan : curves) list.push_back(curve_study(plan));
  list.push_back(bearing_study());
  list.push_back(c3_block_study());
  list.push_back(newton_cost_study());
  list.push_back(calculix_study());
  list.push_back(shapes_study());
  return list;
}

}  // namespace

const std::vector<Study>& studies() {
  static const std::vector<Study> list = make_studies();
  return list;
}

const Study& study_named(const std::string& name) {
  std::string allowed;
  for (const Study& study : studies()) {
    if (study.name == name) return study;
    allowed += (allowed.empty() ? "" : ", ") + study.name;
  }
  throw std::invalid_argument("study is \"" + name + "\"; allowed: " + allowed);
}

std::string key_of(const Study& study) {
  const boost::uuids::name_generator_sha1 generator(boost::uuids::ns::oid());
  return boost::uuids::to_string(generator(study.name + study.inputs.dump()));
}

std::string file_of(const Study& study) { return "fe/" + study.name + ".json"; }

std::optional<nlohmann::json> kept(const Study& study) {
  if (!std::filesystem::exists(data_folder() / file_of(study))) return std::nullopt;
  nlohmann::json json = read_data(file_of(study));
  if (json.value("key", "") != key_of(study)) return std::nullopt;
  return json.at("result");
}

std::optional<nlohmann::json> kept(const std::string& name) { return kept(study_named(name)); }

nlohmann::json regenerate(const Study& study, const Report& report) {
  return {{"what", study.what},
          {"key", key_of(study)},
          {"inputs", study.inputs},
          {"result", study.compute(report)}};
}

std::vector<Characterisation> kept_characterisations() {
  std::vector<Characterisation> out;
  for (const Study& study : studies()) {
    if (!study.inputs.contains("meshes")) continue;
    if (const auto result = kept(study)) out.push_back(result->get<Characterisation>());
  }
  return out;
}

std::vector<SolidCurve> kept_curves() {
  std::vector<SolidCurve> out;
  for (const Study& study : studies()) {
    const auto result = kept(study);
    if (!result || !result->is_object() || !result->contains("curves")) continue;
    for (const auto& curve : result->at("curves")) out.push_back(curve.get<SolidCurve>());
  }
  return out;
}

}  // namespace halfway::reference::fe
