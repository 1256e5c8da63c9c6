#include <functional>

#include <gtest/gtest.h>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "engine/case/case_keys.h"
#include "tests/unit/engine/case/case_samples.h"

namespace rouleau::testing {
namespace {

using nlohmann::json;

const valijson::Schema& parsed_schema() {
  static valijson::Schema schema;
  static const bool once = [] {
    const valijson::adapters::NlohmannJsonAdapter adapter(case_schema());
    valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(adapter, schema);
    return true;
  }();
  (void)once;
  return schema;
}

bool schema_accepts(const json& document) {
  valijson::Validator validator(valijson::Validator::kStrongTypes);
  return validator.validate(parsed_schema(), valijson::adapters::NlohmannJsonAdapter(document), nullptr);
}

/// A scene in which nothing touches anything, whatever is changed in it within the ranges tried here.
json roomy_case() {
  json document = to_json(read_case(published_case()));
  document["effects"]["bending"] = "auto";
  return document;
}

void expect_agreement(const json& document) {
  const std::vector<Fault> faults = faults_of(document);
  EXPECT_EQ(schema_accepts(document), faults.empty())
      << document << (faults.empty() ? "" : "\n" + faults[0].pointer + ": " + faults[0].message);
}

/// Calls `visit` with the pointer of each member of the table, entry 0 standing for the entries of a list.
void for_each_key(const Key& object, const std::string& pointer,
                  const std::function<void(const Key&, const std::string&)>& visit) {
  for (const Key& member : object.members) {
    const std::string place = pointer + '/' + member.name;
    visit(member, place);
    for_each_key(member, member.kind == Kind::list ? place + "/0" : place, visit);
  }
}

TEST(CaseSchema, AcceptsWhatTheReaderAccepts) {
  EXPECT_TRUE(schema_accepts(minimal_case()));
  EXPECT_TRUE(schema_accepts(published_case()));
  EXPECT_TRUE(schema_accepts(roomy_case()));
}

TEST(CaseSchema, RefusesTheSameTypesAsTheReaderForEveryKey) {
  const std::vector<json> wrong = {nullptr,    true,  "1",  "", "no such choice", json::array(), {1, 2},
                                   {{"a", 1}}, -1e30, 1e30, 0.5};
  int refused = 0;
  for_each_key(case_key(), "", [&](const Key& key, const std::string& place) {
    if (key.name == "name") return;
    for (const json& value : wrong) {
      const bool sound_but_misplaced = value == 0.5 && key.kind == Kind::number;
      const bool sound = key.kind == Kind::list && value.empty();
      if (sound_but_misplaced || sound) continue;
      const json document = with(roomy_case(), place, value);
      expect_agreement(document);
      if (!schema_accepts(document)) ++refused;
    }
  });
  EXPECT_GT(refused, 300);
}

TEST(CaseSchema, HasTheSameBoundsAsTheReaderForEveryNumber) {
  int tried = 0;
  for_each_key(case_key(), "", [&](const Key& key, const std::string& place) {
    if (key.kind != Kind::number) return;
    const Range& range = key.range;
    for (const double bound : {range.least, range.most, 0.0, 1.001 * range.most, range.least - 1e-13}) {
      // The reader also checks the scene: only what it says about this key by itself is compared.
      const json document = with(roomy_case(), place, bound);
      const std::string message = message_at(faults_of(document), place);
      EXPECT_EQ(schema_accepts(document), message.find("allowed is") == std::string::npos)
          << place << " " << bound;
      ++tried;
    }
  });
  EXPECT_GE(tried, 100);
}

TEST(CaseSchema, RequiresTheSameKeysAsTheReader) {
  for_each_key(case_key(), "", [&](const Key& key, const std::string& place) {
    json document = roomy_case();
    const json::json_pointer pointer(place);
    document[pointer.parent_pointer()].erase(key.name);
    expect_agreement(document);
    EXPECT_EQ(schema_accepts(document), !key.required) << place;
  });
}

TEST(CaseSchema, AllowsNoOtherKeyAnywhere) {
  for (const char* place :
       {"/x", "/vessel/x", "/plasma/x", "/inflow/x", "/outflow/x", "/thrombi/0/y", "/cells/0/z",
        "/numerics/x", "/output/fields", "/effects/Bad", "/effects/_x", "/effects/a__b", "/effects/1"}) {
    const json document = with(roomy_case(), place, "on");
    EXPECT_FALSE(schema_accepts(document)) << place;
    expect_agreement(document);
  }
  expect_agreement(with(roomy_case(), "/effects/a_b2", "on"));
}

TEST(CaseSchema, AgreesOnTextsListsAndSwitches) {
  for (const json& name : {json(std::string(200, 'x')), json(std::string(201, 'x')), json("tab\t"),
                           json("\x7f"), json("µµ"), json(3), json("")}) {
    expect_agreement(with(roomy_case(), "/name", name));
  }
  expect_agreement(with(roomy_case(), "/cells", json::array()));
  expect_agreement(with(roomy_case(), "/thrombi", json(65, roomy_case()["thrombi"][0])));
  for (const json& position :
       {json("on"), json("off"), json("auto"), json("ON"), json(true), json(nullptr)}) {
    expect_agreement(with(roomy_case(), "/effects/bending", position));
  }
  for (const json& step : {json("auto"), json(1e-6), json("Auto"), json(0), json(-1), json(nullptr)}) {
    expect_agreement(with(roomy_case(), "/numerics/time_step", step));
  }
  for (const json& interval : {json(0), json(0.0), json(1e-13), json(1e-3), json(-1), json(2000)}) {
    expect_agreement(with(roomy_case(), "/output/frame_interval", interval));
  }
  for (const json& document : {json(nullptr), json(3), json::array(), json("x")}) expect_agreement(document);
}

TEST(CaseSchema, DescribesEveryKeyAndStatesUnitsAndDefaults) {
  for_each_key(case_key(), "", [&](const Key& key, const std::string& place) {
    json schema = case_schema();
    std::string path;
    for (std::size_t from = 1; from < place.size();) {
      const std::size_t to = std::min(place.find('/', from), place.size());
      const std::string token = place.substr(from, to - from);
      schema = token == "0" ? schema.at("items") : schema.at("properties").at(token);
      from = to + 1;
    }
    EXPECT_EQ(schema.at("description"), key.description) << place;
    EXPECT_TRUE(key.description.ends_with('.')) << place;
    EXPECT_EQ(schema.value("unit", ""), key.unit) << place;
    EXPECT_EQ(schema.contains("default"), !key.fallback.is_null()) << place;
    if (schema.contains("default")) {
      EXPECT_TRUE(schema_accepts(with(roomy_case(), place, key.fallback))) << place;
    }
  });
  EXPECT_EQ(case_schema().at("$schema"), "http://json-schema.org/draft-07/schema#");
}

}  // namespace
}  // namespace rouleau::testing
