// eval: many poses in one request are answered as if they were asked one by one.
#include "reports/eval/input_lines.hpp"
#include "reports/eval/numbers.hpp"
#include "reports/tests/eval_support.hpp"

#include <boost/test/unit_test.hpp>

#include <bit>
#include <functional>
#include <random>

using namespace halfway;
using namespace halfway::reports::test;
using nlohmann::json;

namespace {

/// Turned by any angle about any axis, and somewhere: no number is exact.
json random_node(std::mt19937_64& engine) {
  std::normal_distribution<double> normal;
  const auto four = [&] {
    return Eigen::Vector4d::NullaryExpr([&](Eigen::Index) { return normal(engine); });
  };
  const Eigen::Vector4d q = Eigen::Vector4d(four()).normalized();
  const Eigen::Vector4d x = four();
  return {{"x", {x[0], x[1], x[2]}}, {"q", {q[0], q[1], q[2], q[3]}}};
}

json random_poses(int count) {
  std::mt19937_64 engine(count);
  json poses = json::array();
  for (int i = 0; i < count; ++i) poses.push_back({{"a", random_node(engine)}, {"b", random_node(engine)}});
  return poses;
}

/// The request for one of the poses alone.
json single(json block, std::size_t pose) {
  const json nodes = block["poses"][pose];
  block.erase("poses");
  for (const char* node : {"a", "b"}) block[node].update(nodes.value(node, json::object()));
  return block;
}

/// A generic joint asked for poses; what they have in common is not said.
json block_of(const char* formulation, Kind kind, const json& poses) {
  json request = generic_request(*reference::find_formulation(formulation), kind);
  for (const char* node : {"a", "b"}) request[node].erase("x"), request[node].erase("q");
  request["poses"] = poses;
  return request;
}

/// Every list has an item for each pose: that of the pose asked alone, digit by digit; null where it has
/// none.
void check_same(const json& block) {
  const json all = answer(block);
  BOOST_REQUIRE_MESSAGE(!all.contains("error"), all.dump().substr(0, 500));
  std::vector<std::size_t> without_result;
  for (std::size_t i = 0; i < block["poses"].size(); ++i) {
    const json one = answer(single(block, i));
    if (one.contains("error")) without_result.push_back(i);
    for (const char* what : {"strain", "loads", "tangent", "energy"}) {
      if (all[what].is_null()) {  // no potential
        BOOST_TEST((one.contains("error") || one[what].is_null()));
        continue;
      }
      BOOST_REQUIRE_EQUAL(all[what].size(), block["poses"].size());
      BOOST_TEST((all[what][i] == (one.contains("error") ? json() : one[what])), what << " at pose " << i);
    }
  }
  const json errors = all.value("errors", json::array());
  BOOST_REQUIRE_EQUAL(errors.size(), without_result.size());
  for (std::size_t k = 0; k < errors.size(); ++k) {
    BOOST_TEST(errors[k].value("pose", -1) == int(without_result[k]));
    const bool is_series = block["formulation"] == "rod4" || block["formulation"] == "rod34";
    BOOST_TEST(errors[k].value("code", "") == (is_series ? "beyond_convexity" : "singular_pose"));
  }
}

struct Mistake {
  std::function<void(json&)> make;
  const char* code;
  const char* field;
};

const Mistake kMistakes[] = {
    {[](json& r) { r["poses"] = 3; }, "wrong_type", "poses"},
    {[](json& r) { r["poses"] = json::object(); }, "wrong_type", "poses"},
    {[](json& r) { r["poses"][1] = 3; }, "wrong_type", "poses[1]"},
    {[](json& r) { r["poses"][1].erase("a"); }, "missing_key", "poses[1].a"},
    {[](json& r) { r["poses"][2]["b"].erase("q"); }, "missing_key", "poses[2].b.q"},
    {[](json& r) { r["poses"][0]["b"].erase("x"); }, "missing_key", "poses[0].b.x"},
    {[](json& r) { r["poses"][0]["c"] = 1; }, "unknown_key", "poses[0].c"},
    {[](json& r) {
       r["poses"][0]["a"]["o"] = {0, 0, 0};
     },
     "unknown_key", "poses[0].a.o"},
    {[](json& r) { r["poses"][2]["b"]["q"][3] = "x"; }, "wrong_type", "poses[2].b.q[3]"},
    {[](json& r) { r["poses"][2]["b"]["x"].push_back(0); }, "wrong_shape", "poses[2].b.x"},
    {[](json& r) { r["poses"][2]["a"]["q"][0] = 2; }, "not_unit_quaternion", "poses[2].a.q"},
    {[](json& r) { r["a"]["z"] = 1; }, "unknown_key", "a.z"},
};

}  // namespace

BOOST_AUTO_TEST_SUITE(poses)

BOOST_AUTO_TEST_CASE(every_formulation_and_kind) {
  for (const auto& entry : reference::formulations()) {
    for (Kind kind : kKinds) {
      BOOST_TEST_CONTEXT(entry.name << '/' << to_string(kind)) {
        check_same(block_of(std::string(entry.name).c_str(), kind, random_poses(3)));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(what_poses_leave_out) {
  json block = block_of("conformal", Kind::linear_angular, random_poses(4));
  const json common = random_poses(1)[0];
  for (const char* node : {"a", "b"}) block[node].update(common[node]);
  block["poses"][0].erase("a");
  block["poses"][1]["a"].erase("x");
  block["poses"][2]["b"].erase("q");
  block["poses"][3] = json::object();
  check_same(block);
  // The ends may stand beside the nodes; then no node is needed.
  json plain = block_of("conformal", Kind::linear_angular, random_poses(2));
  json beside = plain;
  for (const char* node : {"a", "b"}) {
    beside.erase(node);
    beside[std::string("offset_") + node] = plain[node]["o"];
    beside[std::string("frame_") + node] = plain[node]["h"];
  }
  BOOST_TEST(answer(beside) == answer(plain));
}

BOOST_AUTO_TEST_CASE(a_pose_without_result_costs_no_other) {
  json poses = random_poses(3);
  poses[1]["a"] = {{"x", {0, 0, 0}}, {"q", {1, 0, 0, 0}}};
  poses[1]["b"] = {{"x", {0, 0, 0}}, {"q", {0, 0.6, 0, 0.8}}};
  for (const char* name : {"cayley", "simbody_xyz"}) {
    json block = block_of(name, Kind::angular, poses);
    for (const char* node : {"a", "b"}) block[node]["h"] = {1, 0, 0, 0};
    check_same(block);
    const bool is_pole = std::string(name) == "cayley";
    BOOST_TEST(answer(block).contains("errors") == is_pole);
  }
}

BOOST_AUTO_TEST_CASE(no_pose_at_all) {
  const json found = answer(block_of("invariant", Kind::angular, json::array()));
  BOOST_TEST((found["loads"] == json::array() && found["tangent"] == json::array()));
}

BOOST_AUTO_TEST_CASE(wrong_poses) {
  for (const Mistake& mistake : kMistakes) {
    json request = block_of("invariant", Kind::linear_angular, random_poses(3));
    mistake.make(request);
    const json found = answer(request);
    BOOST_TEST_CONTEXT(mistake.field) {
      BOOST_REQUIRE_MESSAGE(found.contains("error"), found.dump().substr(0, 200));
      BOOST_TEST(found["error"].value("code", "") == mistake.code);
      BOOST_TEST(found["error"].value("field", "") == mistake.field);
      BOOST_TEST(found["id"] == "generic");
    }
  }
}

BOOST_AUTO_TEST_CASE(notes_are_few) {
  json poses = random_poses(30);
  for (json& pose : poses) pose["b"]["q"] = {0.9239, 0.3827, 0, 0};
  const json notes = answer(block_of("invariant", Kind::angular, poses))["notes"];
  BOOST_REQUIRE_EQUAL(notes.size(), 21u);
  BOOST_TEST(notes[0].get<std::string>().starts_with("poses[0].b.q has length"));
  BOOST_TEST(notes[20] == "and 10 more of their kind");
}

/// However the bytes come, the lines are the same.
BOOST_AUTO_TEST_CASE(lines_in_pieces) {
  const std::string text = "one\n\ntoo long a line\n12345678\n" + std::string(200000, 'x') + "\r\nlast";
  const std::vector<std::string> expected = {"one", "", "?", "12345678", "?", "last"};
  for (std::size_t piece : {1u, 2u, 7u, 65536u, 1000000u, 3u}) {
    const bool waits = piece == 3;  // for more than a line, before the first is asked for
    std::size_t at = 0;
    reports::InputLines input(8, [&](char* room, std::size_t size) {
      const std::size_t count = text.copy(room, std::min(size, piece), at);
      at += count;
      return count;
    });
    std::vector<std::string> lines;
    do {
      while (waits && input.unread() < 6 && input.read_more()) {
      }
      while (const auto line = input.next())
        lines.push_back(line->is_too_long ? "?" : std::string(line->text));
    } while (input.read_more());
    BOOST_TEST(lines == expected, boost::test_tools::per_element());
  }
}

/// nlohmann, which is no part of the writer, reads back the same double, sign of zero included.
BOOST_AUTO_TEST_CASE(numbers_come_back) {
  std::mt19937_64 engine(5);
  const double edges[] = {0.0, -0.0, 5e-324,  -2.2250738585072014e-308, 1.7976931348623157e308,
                          1e5, 0.1,  -1 / 3.0};
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  for (int round = 0; round < 200; ++round) {
    Eigen::Matrix<double, 12, 12> written = Eigen::Matrix<double, 12, 12>::NullaryExpr([&] {
      const double any = std::bit_cast<double>(engine());
      return std::isfinite(any) && engine() % 4 != 0 ? any : edges[engine() % std::size(edges)];
    });
    // As loads do: the other node's, opposite, and some that are almost.
    written.topRows<3>() = -written.middleRows<3>(6);
    written.leftCols<3>() = -written.middleCols<3>(6);
    written(1, 1) = std::nextafter(written(1, 1), 0);
    std::string text = "[";
    reports::append_rows(text, written);
    reports::append_row(text += ',', written.row(4).transpose());
    reports::append_number(text += ',', written(5, 5));
    const json read = json::parse(text + ']');
    int wrong = bits(read[2].get<double>()) != bits(written(5, 5)) && written(5, 5) != 0;
    for (int i = 0; i < 12; ++i) {
      for (int j = 0; j < 12; ++j) {
        const json& entry = read[0][std::size_t(i)][std::size_t(j)];
        // "-0" is an integer without a sign to nlohmann: as text.
        wrong +=
            written(i, j) == 0 ? entry.get<double>() != 0 : bits(entry.get<double>()) != bits(written(i, j));
      }
      wrong += read[1][std::size_t(i)] != read[0][4][std::size_t(i)];
    }
    BOOST_TEST(wrong == 0, text);
  }
}

BOOST_AUTO_TEST_SUITE_END()
