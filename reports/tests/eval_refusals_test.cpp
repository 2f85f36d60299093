// eval: every kind of bad line is answered by its code and field, and nothing else happens.
#include "reports/eval/eval_line.hpp"
#include "reports/tests/eval_support.hpp"

#include <boost/test/unit_test.hpp>

#include <functional>

using namespace halfway;
using namespace halfway::reports::test;
using nlohmann::json;

namespace {

json base(const char* formulation = "invariant", Kind kind = Kind::linear_angular) {
  return generic_request(*reference::find_formulation(formulation), kind);
}

/// `field` may be empty: then the answer's field is null, the line as a whole.
void check_refused(const std::string& line, const std::string& code, const std::string& field,
                   const json& id) {
  const json found = answer(line);
  BOOST_TEST_CONTEXT(line.substr(0, 400)) {
    BOOST_REQUIRE_MESSAGE(found.contains("error"), "accepted: " << found.dump().substr(0, 200));
    const json& error = found["error"];
    BOOST_TEST(found.size() == 2u);
    BOOST_TEST(error.value("code", "") == code);
    BOOST_TEST(error["field"] == (field.empty() ? json() : json(field)));
    BOOST_TEST(!error.value("message", "").empty());
    BOOST_TEST(found["id"] == id);
  }
}

struct Mistake {
  std::function<void(json&)> make;
  const char* code;
  const char* field;
};

const Mistake kMistakes[] = {
    {[](json& r) { r["formulaton"] = 1; }, "unknown_key", "formulaton"},
    {[](json& r) { r["a"]["quaternion"] = 1; }, "unknown_key", "a.quaternion"},
    {[](json& r) { r["law"]["k"] = 1; }, "unknown_key", "law.k"},
    {[](json& r) { r.erase("formulation"); }, "missing_key", "formulation"},
    {[](json& r) { r.erase("kind"); }, "missing_key", "kind"},
    {[](json& r) { r.erase("law"); }, "missing_key", "law"},
    {[](json& r) { r.erase("a"); }, "missing_key", "a"},
    {[](json& r) { r["b"].erase("q"); }, "missing_key", "b.q"},
    {[](json& r) { r["b"].erase("x"); }, "missing_key", "b.x"},
    {[](json& r) { r["law"].erase("type"); }, "missing_key", "law.type"},
    {[](json& r) { r["law"].erase("K"); }, "missing_key", "law.K"},
    {[](json& r) { r["formulation"] = "invarient"; }, "unknown_formulation", "formulation"},
    {[](json& r) { r["formulation"] = "linearized"; }, "scenes_only", "formulation"},
    {[](json& r) { r["formulation"] = 3; }, "wrong_type", "formulation"},
    {[](json& r) { r["kind"] = "angle"; }, "unknown_kind", "kind"},
    {[](json& r) { r["kind"] = {"angular"}; }, "wrong_type", "kind"},
    {[](json& r) { r["law"] = "linear"; }, "wrong_type", "law"},
    {[](json& r) { r["law"]["type"] = "rubber"; }, "unknown_law", "law.type"},
    {[](json& r) { r["kind"] = "angular"; }, "wrong_shape", "law.K"},
    {[](json& r) { r["law"]["K"][4].erase(0); }, "wrong_shape", "law.K[4]"},
    {[](json& r) { r["law"]["K"] = 5; }, "wrong_type", "law.K"},
    {[](json& r) { r["law"]["K"][1][2] = "x"; }, "wrong_type", "law.K[1][2]"},
    {[](json& r) { r["law"]["K"][1][2] = nullptr; }, "wrong_type", "law.K[1][2]"},
    {[](json& r) { r["law"]["K"][3][4] = 0.5 + 1e-9; }, "not_symmetric", "law.K"},
    {[](json& r) { r["law"]["K"][5][5] = -9; }, "indefinite_stiffness", "law.K"},
    {[](json& r) { r["law"]["K"][0][1] = r["law"]["K"][1][0] = 40; }, "indefinite_stiffness", "law.K"},
    {[](json& r) {
       r["law"]["K"] = {1, 2, 3};
     },
     "wrong_shape", "law.K"},
    {[](json& r) { r["law"]["K"] = {1, 2, 3, 4, 5, -6}; }, "indefinite_stiffness", "law.K"},
    {[](json& r) { r["law"]["stiffness"] = r["law"]["K"]; }, "named_twice", "law.K"},
    {[](json& r) {
       r["law"] = {{"type", "linear"}, {"compliance", {1, 1, 1, 1, 0, 1}}};
     },
     "indefinite_stiffness", "law.compliance"},
    {[](json& r) {
       r["law"]["preload"] = {1, 0, 0};
     },
     "wrong_shape", "law.preload"},
    {[](json& r) { r["law"]["offset"] = {1, 0, 0, "1 mm", 0, 0}; }, "wrong_unit", "law.offset[3]"},
    {[](json& r) { r["law"]["K"][1][1] = "3 kN"; }, "wrong_unit", "law.K[1][1]"},
    {[](json& r) { r["law"]["K"][1][1] = "3 kM/m"; }, "unknown_unit", "law.K[1][1]"},
    {[](json& r) { r["law"]["K"][1][1] = "3"; }, "wrong_unit", "law.K[1][1]"},
    {[](json& r) { r["law"]["tolerance"] = 1; }, "wrong_value", "law.tolerance"},
    {[](json& r) {
       r["law"] = {{"type", "per_axis"}};
     },
     "missing_key", "law.axis"},
    {[](json& r) {
       r["law"] = {{"type", "per_axis"}, {"axis", {{{"k1", 1}}}}};
     },
     "wrong_shape", "law.axis"},
    {[](json& r) {
       r["law"] = {{"type", "per_axis"}, {"axis", {{{"k1", -1}}}}};
     },
     "indefinite_stiffness", "law.axis[0].k1"},
    {[](json& r) {
       r["law"] = {{"type", "per_axis"}, {"axis", {{{"k1", 1}, {"positive", 1}}}}};
     },
     "named_twice", "law.axis[0].positive"},
    {[](json& r) {
       r["law"] = {{"type", "per_axis"}, {"axis", {{{"x", {0, 1, 1}}, {"y", {0, 1, 2}}}}}};
     },
     "wrong_value", "law.axis[0].x"},
    {[](json& r) {
       r["formulation"] = "rod4";
       r["law"] = {{"type", "linear"}, {"K", {1, 2, 3, 4, 5, 6}}, {"preload", {0, 0, 0, 1, 0, 0}}};
     },
     "law_of_one_stiffness_only", "law"},
    {[](json& r) {
       r["a"]["x"] = {{"values", {1, 2, 3}}, {"unit", "rad"}};
     },
     "wrong_unit", "a.x.values[0]"},
    {[](json& r) {
       r["offset_a"] = {0, 0, 1};
     },
     "named_twice", "a.o"},
    {[](json& r) {
       r["a"]["q"] = {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
     },
     "not_a_rotation", "a.q"},
    {[](json& r) {
       r["law"] = {{"type", "polynomial"}, {"k1", {1, 2, 3}}};
     },
     "wrong_shape", "law.k1"},
    {[](json& r) {
       r["law"] = {{"type", "polynomial"}, {"k3", {1, 2, 3}}};
     },
     "missing_key", "law.k1"},
    {[](json& r) {
       r["law"] = {{"type", "polynomial"}, {"k1", {1, 2, 3, 4, 5, -6}}};
     },
     "indefinite_stiffness", "law.k1"},
    {[](json& r) {
       r["law"] = {{"type", "polynomial"}, {"k1", {1, 2, 3, 4, 5, 6}}, {"K", 1}};
     },
     "unknown_key", "law.K"},
    {[](json& r) { r["xi"] = 0.5; }, "xi_not_used", "xi"},
    {[](json& r) { r["formulation"] = "intrinsic"; }, "xi_missing", "xi"},
    {[](json& r) { r["formulation"] = "intrinsic", r["xi"] = "half"; }, "wrong_type", "xi"},
    {[](json& r) { r["length"] = 0.5; }, "length_not_used", "length"},
    {[](json& r) { r["axis"] = 1; }, "length_not_used", "axis"},
    {[](json& r) { r["formulation"] = "rod34"; }, "length_missing", "length"},
    {[](json& r) { r["formulation"] = "rod34", r["length"] = 0; }, "wrong_value", "length"},
    {[](json& r) { r["formulation"] = "rod34", r["length"] = 1, r["axis"] = 0; }, "wrong_value", "axis"},
    {[](json& r) { r["formulation"] = "rod34", r["length"] = 1, r["axis"] = 4; }, "wrong_value", "axis"},
    {[](json& r) { r["formulation"] = "rod34", r["length"] = 1, r["axis"] = 1.5; }, "wrong_value", "axis"},
    {[](json& r) {
       r["formulation"] = "rod4";
       r["law"]["K"] = {1, 2, 3, 4, 0, 6};
     },
     "singular_law", "law"},
    {[](json& r) {
       r["formulation"] = "rod4";
       r["law"]["K"] = {1, 2, 3, 1, 10, 100};
     },
     "beyond_convexity", ""},
    {[](json& r) { r["formulation"] = "drake_rpy"; }, "block_diagonal_law_only", "law.K"},
    {[](json& r) {
       r["a"]["q"] = {1, 0.1, 0, 0};
     },
     "not_unit_quaternion", "a.q"},
    {[](json& r) {
       r["a"]["q"] = {1 + 2e-3, 0, 0, 0};
     },
     "not_unit_quaternion", "a.q"},
    {[](json& r) {
       r["b"]["h"] = {0, 0, 0, 0};
     },
     "not_unit_quaternion", "b.h"},
    {[](json& r) {
       r["b"]["h"] = {1e300, 1e300, 0, 0};
     },
     "not_unit_quaternion", "b.h"},
    {[](json& r) {
       r["a"]["q"] = {1, 0, 0};
     },
     "wrong_shape", "a.q"},
    {[](json& r) {
       r["a"]["x"] = {1, 2, 3, 4};
     },
     "wrong_shape", "a.x"},
    {[](json& r) {
       r["a"]["o"] = {1, 2, true};
     },
     "wrong_type", "a.o[2]"},
    {[](json& r) { r["a"] = json::array(); }, "wrong_type", "a"},
    {[](json& r) { r["want"] = "loads"; }, "wrong_type", "want"},
    {[](json& r) {
       r["want"] = {"strain", "stress"};
     },
     "unknown_want", "want[1]"},
    {[](json& r) {
       r["want"] = {"strain", 1};
     },
     "wrong_type", "want[1]"},
    {[](json& r) {
       r["b"]["x"] = {1e308, 1e308, 1e308};
     },
     "singular_pose", ""},
};

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  BOOST_REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), by);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(refusals)

BOOST_AUTO_TEST_CASE(the_base_is_accepted) { BOOST_TEST(!answer(base()).contains("error")); }

BOOST_AUTO_TEST_CASE(wrong_members) {
  for (const Mistake& mistake : kMistakes) {
    json request = base();
    mistake.make(request);
    check_refused(request.dump(), mistake.code, mistake.field, "generic");
  }
}

BOOST_AUTO_TEST_CASE(lines_that_are_not_requests) {
  for (const char* line : {"", " \t", "\r"}) check_refused(line, "empty_line", "", nullptr);
  for (const char* line : {"[]", "3", "null", "\"text\""}) check_refused(line, "not_an_object", "", nullptr);
  for (const char* line : {"{", "}", "{\"id\":1", "{\"id\":[1", "{} {}", "{'id':1}", "{\"id\":1,}", "[1,2",
                           "{\"xi\":NaN}", "{\"xi\":Infinity}", "{\"xi\":0x10}", "{\"xi\":01}",
                           "{\"formulation\":\"\xff\xfe\"}", "{\"formulation\":\"\xc3\"}", "\x01"}) {
    const bool has_id = std::string(line) == "{\"id\":1" || std::string(line) == "{\"id\":1,}";
    check_refused(line, "malformed_json", "", has_id ? json(1) : json());
  }
  check_refused(std::string("{\"id\":\0}", 8), "malformed_json", "", nullptr);
}

BOOST_AUTO_TEST_CASE(numbers_that_overflow) {
  const std::string line = base().dump();
  check_refused(replaced(line, "\"x\":[0.25", "\"x\":[1e999"), "not_finite", "a.x[0]", nullptr);
  check_refused(replaced(line, "[[30.0", "[[-1e400"), "not_finite", "law.K[0][0]", "generic");
  check_refused("{\"id\":1e999}", "not_finite", "id", nullptr);
  check_refused("{\"id\":0.95000000000000000000e309}", "not_finite", "id", nullptr);
}

BOOST_AUTO_TEST_CASE(deep_nesting) {
  for (std::size_t depth : {std::size_t(33), std::size_t(1000000)}) {
    check_refused(std::string(depth, '['), "too_deep", "", nullptr);
    std::string objects = "{\"id\":5,\"law\":";
    for (std::size_t i = 0; i < depth; ++i) objects += "{\"a\":";
    check_refused(objects, "too_deep", "", 5);
  }
}

BOOST_AUTO_TEST_CASE(large_lines) {
  const std::string many(std::size_t(4) << 20, 'x');
  check_refused("{\"id\":1,\"formulation\":\"" + many + "\"}", "unknown_formulation", "formulation", 1);
  check_refused("{\"id\":1,\"" + many + "\":0}", "unknown_key", std::string(60, 'x'), 1);
  std::string numbers = "{\"id\":1,\"law\":[0";
  for (int i = 0; i < 500000; ++i) numbers += ",0";
  check_refused(numbers + "]}", "missing_key", "formulation", 1);
}

BOOST_AUTO_TEST_CASE(singular_poses) {
  const double h = std::sqrt(0.5);
  const auto turned = [](const char* formulation, const json& q) {
    json request = base(formulation, Kind::angular);
    for (const char* node : {"a", "b"}) request[node]["q"] = request[node]["h"] = {1, 0, 0, 0};
    request["b"]["q"] = q;
    return request.dump();
  };
  check_refused(turned("cayley", {0, 0.6, 0, 0.8}), "singular_pose", "", "generic");   // phi = pi
  check_refused(turned("simbody_xyz", {h, 0, h, 0}), "singular_pose", "", "generic");  // gimbal lock, y
  check_refused(turned("drake_rpy", {h, 0, h, 0}), "singular_pose", "", "generic");
  check_refused(turned("field_a", {h, h, 0, 0}), "singular_pose", "", "generic");  // gimbal lock, x
  BOOST_TEST(!answer(turned("field_a", {h, 0, h, 0})).contains("error"));
  BOOST_TEST(!answer(turned("conformal", {0, 0.6, 0, 0.8})).contains("error"));  // regular to 2 pi
}

BOOST_AUTO_TEST_CASE(messages_help) {
  json request = base();
  request["formulation"] = "invarient";
  const std::string message = answer(request)["error"]["message"];
  BOOST_TEST(message.find("did you mean 'invariant'") != std::string::npos);
  BOOST_TEST(message.find("attached_a") != std::string::npos);
  // What is like nothing gets no suggestion.
  for (const char* key : {"hysteresis", "damping", "w"}) {
    json unlike = base();
    unlike["law"][key] = 1;
    const std::string text = answer(unlike)["error"]["message"];
    BOOST_TEST(text.find("did you mean") == std::string::npos, text);
    BOOST_TEST(text.find(key) != std::string::npos, text);
  }
}

BOOST_AUTO_TEST_CASE(keys_that_stand_twice) {
  check_refused(R"({"id":7,"kind":"angular","kind":"linear"})", "duplicate_key", "kind", 7);
  check_refused(R"({"id":7,"law":{"K":[1],"type":"linear","K":[2]}})", "duplicate_key", "law.K", 7);
  check_refused(R"({"id":7,"id":8})", "duplicate_key", "id", 7);
  check_refused(R"({"id":{"k":1,"k":2}})", "duplicate_key", "id.k", nullptr);
}

BOOST_AUTO_TEST_CASE(lines_of_too_many_values) {
  std::string numbers = "{\"id\":1,\"law\":[0";
  for (int i = 0; i < 1000000; ++i) numbers += ",0";
  check_refused(numbers + "]}", "too_many_values", "", 1);
}

BOOST_AUTO_TEST_SUITE_END()
