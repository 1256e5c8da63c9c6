#include <gmock/gmock.h>
#include <random>

#include <gtest/gtest.h>

#include "engine/case/faults.h"
#include "tests/unit/engine/case/case_samples.h"

namespace rouleau::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<Fault> parse_faults(std::string_view text) {
  try {
    parse_json(text);
  } catch (const CaseError& error) {
    return error.faults();
  }
  return {};
}

void expect_fault(std::string_view text, const std::string& pointer, const std::string& message) {
  const std::vector<Fault> faults = parse_faults(text);
  ASSERT_EQ(faults.size(), 1U) << text;
  EXPECT_EQ(faults[0].pointer, pointer) << text;
  EXPECT_THAT(faults[0].message, HasSubstr(message)) << text;
  EXPECT_NO_THROW(nlohmann::json(faults[0].message).dump());
}

TEST(BoundedJson, ReadsWhatTheLibraryReads) {
  for (const char* text : {"{}", "[]", "null", " 1e-6 ", "[1, -2, 3.5, true, null, \"\\u00b5m µm\"]",
                           R"({"a": {"b": [{"c": [[], {}]}, 2]}, "a/b": 1, "": 2})"}) {
    EXPECT_EQ(parse_json(text), nlohmann::json::parse(text)) << text;
  }
}

TEST(BoundedJson, RefusesDeepNestingWithoutRecursion) {
  const std::string allowed =
      std::string(max_case_depth, '[') + std::string(static_cast<std::size_t>(max_case_depth), ']');
  EXPECT_NO_THROW(parse_json(allowed));
  EXPECT_THAT(parse_faults('[' + allowed + ']').at(0).message, HasSubstr("16 levels"));
  EXPECT_THAT(parse_faults(std::string(200'000, '[')).at(0).message, HasSubstr("16 levels"));
  std::string objects;
  for (int k = 0; k < 20'000; ++k) objects += R"({"a":)";
  EXPECT_THAT(parse_faults(objects).at(0).message, HasSubstr("16 levels"));
}

TEST(BoundedJson, RefusesMoreBytesThanAllowed) {
  EXPECT_NO_THROW(parse_json('"' + std::string(max_case_bytes - 2, 'a') + '"'));
  expect_fault('"' + std::string(max_case_bytes - 1, 'a') + '"', "", "1048577 bytes");
  expect_fault(std::string(2 << 20, ' '), "", "at most 1048576");
}

TEST(BoundedJson, NamesEveryDuplicateKey) {
  const std::vector<Fault> faults = parse_faults(
      R"({"a": 1, "b": {"x/y": 1, "x/y": 2}, "c": [{}, {"k": 1, "k": {"z": 0, "z": 0}}], "a": 3})");
  EXPECT_THAT(pointers(faults), ElementsAre("/b/x~1y", "/c/1/k", "/c/1/k/z", "/a"));
  EXPECT_THAT(faults[0].message, HasSubstr("more than once"));
}

TEST(BoundedJson, SameKeyInDifferentObjectsIsNoDuplicate) {
  EXPECT_NO_THROW(parse_json(R"([{"a": {"a": 1}}, {"a": 1}])"));
}

TEST(BoundedJson, RefusesWhatIsNoFiniteNumber) {
  for (const char* word : {"NaN", "-NaN", "nan", "Infinity", "-Infinity", "inf", "-inf"}) {
    expect_fault(std::string(R"({"a": [0, )") + word + "]}", "/a/1", "NaN and Infinity");
  }
  expect_fault(R"({"a": {"b": 1e999}})", "/a/b", "too large");
  expect_fault(R"([-1e999])", "/0", "too large");
  expect_fault('[' + std::string(100'000, '9') + ']', "/0", "too large");
}

TEST(BoundedJson, NamesThePlaceOfBrokenText) {
  expect_fault("", "", "ends before");
  expect_fault("[[[", "/0/0/0", "ends before");
  expect_fault(R"({"a": "x)", "/a", "ends before");
  expect_fault("{\n  \"a\": 1\n  \"b\": 2\n}", "/a", "line 3, column");
  expect_fault("{} x", "", "after the end");
  expect_fault("{}{}", "", "after the end");
  expect_fault("{\"a\": \"\xff\"}", "/a", "UTF-8");
  expect_fault("{\"\xc3\x28\": 1}", "", "UTF-8");
  expect_fault("{\"a\": \"\xed\xa0\x80\"}", "/a", "UTF-8");
  expect_fault(R"({"a": "\ud800"})", "/a", "surrogate");
  expect_fault("{'a': 1}", "", "not valid JSON");
  expect_fault(R"({"a": 1,})", "/a", "not valid JSON");
  expect_fault(R"({"a": 01})", "/a", "not valid JSON");
  expect_fault("{\"a\": 1} // note", "", "after the end");
  expect_fault(std::string_view("{\"a\": \0}", 8), "", "zero byte");
  expect_fault(std::string_view("{}\0garbage", 10), "", "line 1, column 3");
}

TEST(BoundedJson, RefusesEndlessKeys) {
  expect_fault("{\"a\": {\"" + std::string(300, 'k') + "\": 1}}", "/a", "at most 256");
}

TEST(BoundedJson, AnswersToManyFaultsStayShort) {
  std::string text = "{";
  for (int k = 0; k < 50'000; ++k) text += "\"aaaa\": 1,";
  text += "\"b\": 1}";
  const std::vector<Fault> faults = parse_faults(text);
  EXPECT_EQ(faults.size(), max_listed_faults + 1);
  EXPECT_THAT(faults.back().message, HasSubstr("49899 more"));
}

TEST(BoundedJson, BrokenTextEndsInCaseErrorAndNothingElse) {
  const std::string sound = published_case().dump();
  std::mt19937 random(20);
  std::uniform_int_distribution<std::size_t> place(0, sound.size() - 1);
  std::uniform_int_distribution<int> byte(0, 255);
  int refused = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string text = sound.substr(0, round % 3 == 0 ? place(random) : sound.size());
    for (int k = round % 4; k > 0 && !text.empty(); --k)
      text[place(random) % text.size()] = static_cast<char>(byte(random));
    try {
      read_case(text);
    } catch (const CaseError& error) {
      ++refused;
      for (const Fault& fault : error.faults()) {
        EXPECT_NO_THROW((nlohmann::json{fault.pointer, fault.message}.dump())) << text;
      }
    }
  }
  EXPECT_GT(refused, 2000);
}

}  // namespace
}  // namespace rouleau::testing
