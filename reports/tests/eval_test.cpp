// eval: every formulation and kind answers, and what it answers is what was asked for.
#define BOOST_TEST_MODULE eval
#include "reference/record/worst.hpp"
#include "reports/eval/eval_line.hpp"
#include "reports/tests/eval_support.hpp"

#include <boost/test/unit_test.hpp>

using namespace halfway;
using namespace halfway::reports::test;
using nlohmann::json;
using reference::largest_entry;
using reference::Real50;

namespace {

// The road of the expected values: quaternions to matrices and everything after it in 50 digits.
// What is left is rounding of the double evaluation, with tangents of condition about 1e2.
constexpr double kRounding = 1e-12;

Eigen::Vector4d quaternion(const json& q) { return matrix_of(q); }

template <class T>
Mat3<T> rotation(const json& q) {
  const Eigen::Quaternion<T> e(T(q[0].get<double>()), T(q[1].get<double>()), T(q[2].get<double>()),
                               T(q[3].get<double>()));
  return e.toRotationMatrix() / e.squaredNorm();
}

template <>
Mat3<Real50> rotation<Real50>(const json& json_q) {
  const Eigen::Vector4d d = quaternion(json_q);
  const Real50 w(d[0]), x(d[1]), y(d[2]), z(d[3]);
  const Real50 s = Real50(1) / (w * w + x * x + y * y + z * z), two(2);
  Mat3<Real50> R;  // Rodrigues' parameters, homogeneous
  R << (w * w + x * x - y * y - z * z) * s, two * (x * y - w * z) * s, two * (x * z + w * y) * s,
      two * (x * y + w * z) * s, (w * w - x * x + y * y - z * z) * s, two * (y * z - w * x) * s,
      two * (x * z - w * y) * s, two * (y * z + w * x) * s, (w * w - x * x - y * y + z * z) * s;
  return R;
}

Pose<Real50> pose(const json& node) {
  return {Eigen::Vector3d(matrix_of(node["x"])).cast<Real50>(), rotation<Real50>(node["q"])};
}

reference::JointSpec spec_of(const json& request, Kind kind) {
  reference::JointSpec spec;
  spec.kind = kind;
  spec.xi = request.value("xi", 0.5);
  spec.length = request.value("length", 1.0), spec.axis = request.value("axis", 1);
  const json& law = request["law"];
  if (law["type"] == "linear")
    spec.law = reference::LinearSpec{matrix_of(law["K"]), false};
  else
    spec.law = reference::PolynomialSpec{matrix_of(law["k1"]), matrix_of(law["k3"]), matrix_of(law["k5"])};
  spec.a = {matrix_of(request["a"]["o"]), rotation<double>(request["a"]["h"])};
  spec.b = {matrix_of(request["b"]["o"]), rotation<double>(request["b"]["h"])};
  return spec;
}

template <class M>
void check_close(const char* what, const json& found, const M& expected) {
  const Eigen::MatrixXd value = matrix_of(found);
  const Eigen::MatrixXd truth = expected.template cast<double>();
  BOOST_REQUIRE_EQUAL(value.rows(), truth.rows());
  BOOST_REQUIRE_EQUAL(value.cols(), truth.cols());
  const double error = largest_entry<double>(value - truth) / largest_entry<double>(truth);
  BOOST_TEST(error <= kRounding, what << " off by " << error);
}

void check_answer(const json& request, const reference::Entry& entry, Kind kind) {
  const json found = answer(request);
  BOOST_REQUIRE_MESSAGE(!found.contains("error"), found.dump());
  const auto spec = spec_of(request, kind);
  const auto a = pose(request["a"]), b = pose(request["b"]);
  const auto truth = reference::node_loads<Real50>(entry, spec, a, b, true);
  check_close("strain", found["strain"], entry.in_real50.strain(spec, a, b));
  check_close("loads", found["loads"], truth.q);
  check_close("tangent", found["tangent"], truth.tangent);
  const auto energy = entry.in_real50.energy(spec, a, b);
  BOOST_TEST(found["energy"].is_null() == !energy.has_value());
  if (energy)
    BOOST_TEST(found["energy"].get<double>() == double(*energy), boost::test_tools::tolerance(kRounding));
}

json polynomial(Kind kind) {
  const auto n = std::size_t(strain_count(kind));
  const std::vector<double> all = {3, 2, 5, 1, 4, 6};
  const std::vector<double> k1(all.begin(), all.begin() + std::ptrdiff_t(n));
  return {{"type", "polynomial"},
          {"k1", k1},
          {"k3", std::vector<double>(n, 0.5)},
          {"k5", std::vector<double>(n, 0.25)}};
}

json invariant_request() { return generic_request(*reference::find_formulation("invariant"), Kind::angular); }

}  // namespace

BOOST_AUTO_TEST_SUITE(requests)

BOOST_AUTO_TEST_CASE(every_formulation_and_kind) {
  BOOST_REQUIRE(!reference::formulations().empty());
  for (const auto& entry : reference::formulations()) {
    for (Kind kind : kKinds) {
      BOOST_TEST_CONTEXT(entry.name << '/' << to_string(kind)) {
        json request = generic_request(entry, kind);
        check_answer(request, entry, kind);
        request["law"] = polynomial(kind);
        check_answer(request, entry, kind);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(default_is_strain_and_loads) {
  json request = invariant_request();
  request.erase("want");
  const json found = answer(request);
  BOOST_TEST(found.size() == 3u);
  BOOST_TEST((found.contains("id") && found.contains("strain") && found.contains("loads")));
}

BOOST_AUTO_TEST_CASE(only_what_is_wanted) {
  json request = invariant_request();
  request["want"] = {"energy"};
  BOOST_TEST(answer(request).size() == 2u);
  request["want"] = json::array();
  BOOST_TEST(answer(request).size() == 1u);
}

BOOST_AUTO_TEST_CASE(ids_come_back) {
  json request = invariant_request();
  for (const json& id : {json(7), json("a \"b\" \n \u00e9"), json(nullptr), json(-0.5), json(true),
                         json({1, {{"k", {2, nullptr}}}}), json(18446744073709551615u)}) {
    request["id"] = id;
    BOOST_TEST(answer(request)["id"] == id);
    json bad = request;
    bad["kind"] = "bent";
    BOOST_TEST(answer(bad)["id"] == id);
  }
  request.erase("id");
  BOOST_TEST(answer(request)["id"].is_null());
  // Beyond every integer type: the digits that came, not a rounded number.
  for (const char* id :
       {"123456789012345678901234567890", "-98765432109876543210", "1.50", "[1,{\"b\":2,\"a\":3}]"}) {
    const std::string line = R"({"id":)" + std::string(id) + ',' + request.dump().substr(1);
    BOOST_TEST(reports::eval_line(line).starts_with(R"({"id":)" + std::string(id) + ','), line);
  }
  // Without spaces, but for those inside a text.
  const std::string spaced = R"({"id": [ 1.50 , {"k" : "a \" , [ b\\" } ] ,)" + request.dump().substr(1);
  BOOST_TEST(reports::eval_line(spaced).starts_with(R"({"id":[1.50,{"k":"a \" , [ b\\"}],)"), spaced);
}

BOOST_AUTO_TEST_CASE(no_offset_and_no_frame_by_default) {
  json request = generic_request(*reference::find_formulation("invariant"), Kind::linear);
  for (const char* node : {"a", "b"}) {
    request[node]["o"] = {0, 0, 0};
    request[node]["h"] = {1, 0, 0, 0};
  }
  const json full = answer(request);
  for (const char* node : {"a", "b"}) request[node].erase("o"), request[node].erase("h");
  BOOST_TEST(answer(request) == full);
}

BOOST_AUTO_TEST_CASE(quaternions_are_normalised) {
  json request = invariant_request();
  const Eigen::MatrixXd exact = matrix_of(answer(request)["loads"]);
  for (double scale : {1 + 9e-7, 1 - 9e-7, 1 + 9e-4, 1 - 9e-4}) {
    json scaled = request;
    for (auto& x : scaled["a"]["q"]) x = x.get<double>() * scale;
    const double error = largest_entry<double>(matrix_of(answer(scaled)["loads"]) - exact);
    BOOST_TEST(error <= 1e-14 * largest_entry<double>(exact), "loads moved by " << error);
    BOOST_TEST(answer(scaled).contains("notes") == (std::abs(scale - 1) > 1e-6));
  }
}

BOOST_AUTO_TEST_CASE(semidefinite_stiffness_is_allowed) {
  json request = invariant_request();
  request["law"]["K"] = {{1, 1, 0}, {1, 1, 0}, {0, 0, 0}};
  BOOST_TEST(!answer(request).contains("error"));
  request["law"]["K"] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  BOOST_TEST(matrix_of(answer(request)["loads"]).isZero(0));
}

BOOST_AUTO_TEST_CASE(numbers_have_seventeen_digits) {
  json request = invariant_request();
  request["want"] = {"loads"};
  const auto& entry = *reference::find_formulation("invariant");
  const auto spec = spec_of(request, Kind::angular);
  const Pose<double> a{matrix_of(request["a"]["x"]), so3::matrix<double>({0.5, {0.5, -0.1, 0.7}})};
  const Pose<double> b{matrix_of(request["b"]["x"]), so3::matrix<double>({0.7, {0.5, 0.1, 0.5}})};
  const auto direct = reference::node_loads<double>(entry, spec, a, b, false).q;
  const Eigen::MatrixXd found = matrix_of(answer(request)["loads"]);
  // Both run the same arithmetic on inputs that differ by the rounding of a length of 1; printing with
  // fewer than 16 digits would show.
  BOOST_TEST(largest_entry<double>(found - direct) <= 4e-15 * largest_entry<double>(direct));
}

BOOST_AUTO_TEST_SUITE_END()
