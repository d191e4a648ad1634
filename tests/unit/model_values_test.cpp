// Conversions, ranges and the JSON of values.
#include <limits>

#include <gtest/gtest.h>

#include "model_fakes.h"
#include "model/json_text.h"
#include "model/nearest_name.h"

namespace lumenshop {
namespace {

using fakes::error_of;
using lumen::PropertySpec;
using lumen::Value;
using lumen::ValueType;

PropertySpec spec_of(ValueType type, lumen::PropertyOptions options = {}) {
  PropertySpec spec;
  spec.id = "p";
  spec.type = type;
  spec.options = std::move(options);
  return spec;
}

Value parsed(const std::string& json, const PropertySpec& spec) { return from_json(Json::parse(json), spec); }

TEST(Conversion, AllowsExactlyTheTable) {
  constexpr int types = static_cast<int>(ValueType::data) + 1;
  for (int from = 0; from < types; ++from)
    for (int to = 0; to < types; ++to) {
      const auto a = static_cast<ValueType>(from), b = static_cast<ValueType>(to);
      const bool scalar = from <= 2, scalar_to = to <= 2;
      const bool vector_to = b == ValueType::vec2 || b == ValueType::vec3 || b == ValueType::vec4 || b == ValueType::color;
      const bool expected = from == to || (scalar && scalar_to && from < to) || (scalar && vector_to) ||
                            (a == ValueType::vec3 && b == ValueType::color) || (a == ValueType::color && b == ValueType::vec3);
      EXPECT_EQ(convertible(a, b), expected) << lumen::name_of(a) << " to " << lumen::name_of(b);
    }
}

TEST(Conversion, GivesTheValuesThatTheTablePromises) {
  EXPECT_EQ(convert(true, spec_of(ValueType::integer)), Value(1));
  EXPECT_EQ(convert(true, spec_of(ValueType::real)), Value(1.0f));
  EXPECT_EQ(convert(7, spec_of(ValueType::real)), Value(7.0f));
  EXPECT_EQ(convert(0.5f, spec_of(ValueType::vec3)), Value(glm::vec3(0.5f)));
  EXPECT_EQ(convert(2, spec_of(ValueType::vec2)), Value(glm::vec2(2)));
  EXPECT_EQ(convert(glm::vec3(1, 2, 3), spec_of(ValueType::color)), Value(lumen::Color(1, 2, 3)));
  EXPECT_EQ(convert(lumen::Color(1, 2, 3), spec_of(ValueType::vec3)), Value(glm::vec3(1, 2, 3)));
  EXPECT_EQ(convert(9.0f, spec_of(ValueType::real, {.min = 0, .max = 4})), Value(4.0f));
  EXPECT_NE(error_of([] { convert(1.5f, spec_of(ValueType::integer)); }), "");
}

TEST(Conversion, ClampsEachComponentAndMendsRotationsAndChoices) {
  EXPECT_EQ(clamped(glm::vec3(-1, 0.5f, 2), spec_of(ValueType::vec3, {.min = 0, .max = 1})), Value(glm::vec3(0, 0.5f, 1)));
  EXPECT_EQ(clamped(12, spec_of(ValueType::integer, {.min = 0.5, .max = 9.5})), Value(9));
  EXPECT_EQ(clamped(0, spec_of(ValueType::integer, {.min = 0.5, .max = 9.5})), Value(1));
  EXPECT_EQ(clamped(glm::quat(0, 3, 0, 4), spec_of(ValueType::rotation)), Value(glm::quat(0, 0.6f, 0, 0.8f)));
  EXPECT_EQ(clamped(glm::quat(0, 0, 0, 0), spec_of(ValueType::rotation)), Value(glm::quat(1, 0, 0, 0)));
  auto choice = spec_of(ValueType::choice, {.choices = {"a", "b"}});
  choice.default_value = lumen::Choice{"b"};
  EXPECT_EQ(clamped(lumen::Choice{"zzz"}, choice), Value(lumen::Choice{"b"}));
  EXPECT_EQ(clamped(std::vector<float>{-5, 5}, spec_of(ValueType::reals, {.min = 0, .max = 1})), Value(std::vector<float>{0, 1}));
}

TEST(JsonValue, RoundTripsEveryType) {
  const std::pair<ValueType, const char*> cases[] = {
      {ValueType::boolean, "true"}, {ValueType::integer, "-12"}, {ValueType::real, "0.1"}, {ValueType::vec2, "[1,2.5]"},
      {ValueType::vec3, "[1,2,3]"}, {ValueType::vec4, "[0.1,0.2,0.3,0.4]"}, {ValueType::color, "[0.72,0.04,0.05]"},
      {ValueType::rotation, "[0,0,1,0]"}, {ValueType::mat4, "[1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16]"}, {ValueType::string, "\"gr\u00fc\u00df\""},
      {ValueType::path, "\"a/b.vtp\""}, {ValueType::integers, "[1,2,3]"}, {ValueType::reals, "[0.1,1e+20]"}, {ValueType::strings, "[\"a\",\"\"]"},
      {ValueType::reference, "\"lamp\""}, {ValueType::references, "[\"a\",\"b\"]"},
      {ValueType::transfer_function, R"({"range":[-5,20.5],"points":[[-5,0,0,0,0],[20.5,1,0.5,0.25,1]]})"}};
  for (const auto& [type, text] : cases) {
    const Value value = parsed(text, spec_of(type));
    EXPECT_EQ(lumen::type_of(value), type);
    EXPECT_EQ(to_json(value).dump(), text);
  }
}

TEST(JsonValue, MatricesAreWrittenRowByRow) {
  const auto matrix = std::get<glm::mat4>(parsed("[1,0,0,7, 0,1,0,8, 0,0,1,9, 0,0,0,1]", spec_of(ValueType::mat4)));
  EXPECT_EQ(matrix[3], glm::vec4(7, 8, 9, 1));
}

TEST(JsonValue, OneReferenceIsAListOfOne) {
  EXPECT_EQ(parsed("\"a\"", spec_of(ValueType::references)), Value(lumen::References{{"a"}}));
  EXPECT_EQ(parsed("\"\"", spec_of(ValueType::references)), Value(lumen::References{}));
}

TEST(JsonValue, RefusesWhatIsNotTheType) {
  const std::pair<ValueType, const char*> cases[] = {
      {ValueType::boolean, "1"}, {ValueType::integer, "2.5"}, {ValueType::integer, "\"2\""}, {ValueType::real, "true"}, {ValueType::vec3, "[1,2]"},
      {ValueType::vec3, "[1,2,\"3\"]"}, {ValueType::color, "[1,2,3,4]"}, {ValueType::rotation, "[0,0,0,0]"}, {ValueType::mat4, "[1]"},
      {ValueType::string, "5"}, {ValueType::path, "null"}, {ValueType::integers, "[1.5]"}, {ValueType::strings, "[1]"}, {ValueType::reference, "[]"},
      {ValueType::references, "5"}, {ValueType::data, "\"a\""}, {ValueType::transfer_function, R"({"range":[1,0],"points":[[0,0,0,0,0],[1,1,1,1,1]]})"},
      {ValueType::transfer_function, R"({"range":[0,1],"points":[[0,0,0,0,0]]})"}, {ValueType::transfer_function, R"({"range":[0,1]})"},
      {ValueType::transfer_function, R"({"range":[0,1],"points":[[0,0,0,0,0],[1,1,1,1,1]],"more":1})"}};
  for (const auto& [type, text] : cases) EXPECT_NE(error_of([&] { parsed(text, spec_of(type)); }), "") << lumen::name_of(type) << " of " << text;
}

TEST(JsonValue, RefusesNumbersThatAreNotFiniteAndBoundsTheOthers) {
  EXPECT_NE(error_of([] { from_json(std::numeric_limits<double>::infinity(), spec_of(ValueType::real)); }), "");
  EXPECT_NE(error_of([] { from_json(std::numeric_limits<double>::quiet_NaN(), spec_of(ValueType::real)); }), "");
  EXPECT_EQ(parsed("1e300", spec_of(ValueType::real)), Value(std::numeric_limits<float>::max()));
  EXPECT_EQ(parsed("9223372036854775807", spec_of(ValueType::integer)), Value(std::numeric_limits<int>::max()));
  EXPECT_EQ(parsed("18446744073709551615", spec_of(ValueType::integer, {.max = 5})), Value(5));
  EXPECT_EQ(parsed("4.0", spec_of(ValueType::integer)), Value(4));
}

TEST(JsonValue, NamesTheChoicesAndTheNearestOne) {
  const std::string error = error_of([] { parsed("\"srted\"", spec_of(ValueType::choice, {.choices = {"plain", "sorted"}})); });
  EXPECT_NE(error.find("plain, sorted"), std::string::npos) << error;
  EXPECT_NE(error.find("did you mean 'sorted'?"), std::string::npos) << error;
}

TEST(JsonValue, RefusesListsBeyondTheBound) {
  Json list = Json::array();
  for (int i = 0; i < 65536; ++i) list.push_back(i);
  EXPECT_EQ(std::get<std::vector<int>>(from_json(list, spec_of(ValueType::integers))).size(), 65536u);
  list.push_back(0);
  EXPECT_NE(error_of([&] { from_json(list, spec_of(ValueType::integers)); }), "");
}

TEST(JsonText, PutsShortArraysAndLinksOnOneLine) {
  EXPECT_EQ(json_text(Json::parse(R"({"a":[1,2.5,"x"],"m":{"link":"s.mesh","expression":"2*x"},"t":{"points":[[0,1],[2,3]]},"n":{"type":"q","k":[]}})")),
            "{\n  \"a\": [1, 2.5, \"x\"],\n  \"m\": {\"link\": \"s.mesh\", \"expression\": \"2*x\"},\n  \"t\": {\n    \"points\": [\n      [0, 1],\n"
            "      [2, 3]\n    ]\n  },\n  \"n\": {\n    \"type\": \"q\",\n    \"k\": []\n  }\n}\n");
}

TEST(JsonText, NamesThePlaceOfAMistake) {
  EXPECT_EQ(error_of([] { parse_json("{\n  \"a\": 1,\n  oops\n}", "s.json"); }).rfind("s.json:3:3: not valid JSON", 0), 0u)
      << error_of([] { parse_json("{\n  \"a\": 1,\n  oops\n}", "s.json"); });
  EXPECT_NE(error_of([] { parse_json(" \n", "s.json"); }).find("empty"), std::string::npos);
  EXPECT_NE(error_of([] { parse_json("[1e999]", "s.json"); }).find("s.json:1"), std::string::npos);
  EXPECT_NE(error_of([] { parse_json("{\"a\": 1} x", "s.json"); }), "");
  EXPECT_NE(error_of([] { parse_json("]", "s.json"); }), "");
  EXPECT_NE(error_of([] { parse_json("\"\xff\"", "s.json"); }), "");
}

TEST(JsonText, BoundsDepthBeforeItParses) {
  const auto nested = [](int depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_EQ(error_of([&] { parse_json(nested(64), "s.json"); }), "");
  EXPECT_NE(error_of([&] { parse_json(nested(65), "s.json"); }).find("s.json:1:65: nested deeper than 64"), std::string::npos);
  EXPECT_NE(error_of([&] { parse_json(std::string(10'000'000, '['), "s.json"); }).find("nested deeper"), std::string::npos);
  EXPECT_EQ(error_of([&] { parse_json("[\"" + nested(100) + "\"]", "s.json"); }), "") << "brackets in strings are no nesting";
}

TEST(JsonText, LetsTheLaterOfTwoKeysCountAndNamesIt) {
  std::vector<std::string> duplicates;
  EXPECT_EQ(parse_json(R"({"a": 1, "b": 2, "a": {"c": 3}})", "s.json", &duplicates).dump(), R"({"a":{"c":3},"b":2})");
  EXPECT_EQ(duplicates, std::vector<std::string>{"a"});
}

TEST(JsonText, ReadsObjectsOfManyKeysInLinearTime) {
  std::string text = "{";
  for (int i = 0; i < 65536; ++i) text += (i ? ",\"k" : "\"k") + std::to_string(i) + "\":0";
  EXPECT_EQ(parse_json(text + "}", "s.json").size(), 65536u);
  EXPECT_NE(error_of([&] { parse_json(text + ",\"one\":1}", "s.json"); }).find("more than 65536"), std::string::npos);
}

TEST(NearestName, FindsTyposAndNothingElse) {
  EXPECT_EQ(nearest_name("radus", {"samples", "radius", "bias"}), "radius");
  EXPECT_EQ(nearest_name("wlal", {"wall", "lines"}), "wall");
  EXPECT_EQ(nearest_name("intensity", {"wall", "lines"}), "");
}

}  // namespace
}  // namespace lumenshop
