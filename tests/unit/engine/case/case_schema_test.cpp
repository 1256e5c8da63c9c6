#include <cmath>
#include <memory>
#include <set>

#include <gtest/gtest.h>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include "engine/case/key_checks.h"
#include "tests/unit/engine/case/case_samples.h"
#include "tests/unit/engine/case/key_walk.h"

namespace rouleau::testing {
namespace {

using nlohmann::json;

bool accepts(const valijson::Schema& schema, const json& document) {
  valijson::Validator validator(valijson::Validator::kStrongTypes);
  return validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(document), nullptr);
}

void parse(const json& text, valijson::Schema& schema) {
  const valijson::adapters::NlohmannJsonAdapter adapter(text);
  valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(adapter, schema);
}

bool schema_accepts(const json& document) {
  static const std::unique_ptr<const valijson::Schema> schema = [] {
    auto parsed = std::make_unique<valijson::Schema>();
    parse(case_schema(), *parsed);
    return parsed;
  }();
  return accepts(*schema, document);
}

/// What the reader finds in the keys by themselves, before it compares them with one another.
std::vector<std::string> places_refused(const json& document) {
  Faults faults;
  sound_part(document, case_key(), "", faults);
  try {
    faults.raise();
  } catch (const CaseError& error) {
    return pointers(error.faults());
  }
  return {};
}

/// Whether both accept it, after a failure if they differ.
bool expect_agreement(const json& document) {
  const std::vector<std::string> refused = places_refused(document);
  const bool accepted = schema_accepts(document);
  EXPECT_EQ(accepted, refused.empty()) << document << (refused.empty() ? "" : "\n" + refused[0]);
  return accepted;
}

/// Resolved cases that say every key of the table among them.
std::vector<json> full_cases() {
  std::vector<json> documents;
  for (const json& document : cases_of_every_kind()) documents.push_back(to_json(read_case(document)));
  for (json& document : documents) {
    document["effects"]["bending"] = "auto";
    document["probes"] = {{{"name", "centre"}, {"from", {5e-6, 5e-6}}, {"to", {5e-6, 5e-6}}, {"points", 1}}};
  }
  documents[0]["inflow"]["waveform"] = {{0.0, 1.0}, {0.5, -1.0}};
  return documents;
}

void for_each_key(const std::function<void(const json& document, const Key&, const std::string&)>& visit) {
  for (const json& document : full_cases()) {
    for_each_said(document, [&](const Key& key, const std::string& place, const json&) {
      visit(document, key, place);
    });
  }
}

TEST(CaseSchema, AcceptsWhatTheReaderAccepts) {
  for (const json& document : cases_of_every_kind()) {
    EXPECT_TRUE(schema_accepts(document)) << document;
    EXPECT_TRUE(schema_accepts(to_json(read_case(document)))) << document;
  }
  for (const json& document : full_cases()) {
    EXPECT_EQ(pointers(faults_of(document)), std::vector<std::string>()) << document;
    EXPECT_TRUE(schema_accepts(document)) << document;
  }
}

TEST(CaseSchema, RefusesTheSameTypesAsTheReaderForEveryKey) {
  const std::vector<json> wrong = {nullptr,    true,  "1",  "", "no such choice", json::array(), {1, 2},
                                   {{"a", 1}}, -1e30, 1e30, 0.5};
  int refused = 0;
  for_each_key([&](const json& document, const Key&, const std::string& place) {
    for (const json& value : wrong) {
      if (!expect_agreement(with(document, place, value))) ++refused;
    }
  });
  EXPECT_GT(refused, 2000);
}

TEST(CaseSchema, HasTheSameBoundsAsTheReaderForEveryNumber) {
  int tried = 0, refused = 0;
  for_each_key([&](const json& document, const Key& key, const std::string& place) {
    std::vector<json> values;
    const auto [least, most] = std::pair{key.range.least, key.range.most};
    if (key.kind == Kind::number) {
      values = {least,
                most,
                0.0,
                1.001 * most,
                least - 1e-13,
                std::nextafter(least, -1e300),
                std::nextafter(most, 1e300)};
    } else if (key.kind == Kind::integer) {
      // Whole numbers of integer type: this validator takes 1.0 for none, which draft 7 does.
      for (const double value : {least - 1, least, most, most + 1}) values.emplace_back(std::lround(value));
    }
    for (const json& value : values) {
      ++tried;
      if (!expect_agreement(with(document, place, value))) ++refused;
    }
  });
  EXPECT_GE(tried, 900);
  EXPECT_GE(refused, 400);
}

TEST(CaseSchema, RequiresTheSameKeysAsTheReader) {
  int required = 0;
  for_each_key([&](const json& document, const Key& key, const std::string& place) {
    json changed = document;
    const json::json_pointer pointer(place);
    json& parent = changed[pointer.parent_pointer()];
    if (!parent.is_object()) return;
    parent.erase(key.name);
    const bool accepted = expect_agreement(changed);
    if (place == "/vessel/shape") return;
    EXPECT_EQ(accepted, !key.required) << place;
    if (key.required) ++required;
  });
  EXPECT_GE(required, 30);
}

TEST(CaseSchema, AllowsTheSameMembersInEveryShapeAsTheReader) {
  const json trunk = {{"length", 80e-6}, {"diameter", 20e-6}};
  const std::vector<json> documents = full_cases();
  for (const json& document : documents) {
    for (const json& other : documents) {
      for (const auto& [name, value] : other["vessel"].items()) {
        expect_agreement(with(document, "/vessel/" + name, value));
      }
    }
    EXPECT_EQ(schema_accepts(with(document, "/vessel/trunk", trunk)),
              document["vessel"]["shape"] == "bifurcation");
  }
  for (const json& shape : {json("straight"), json("box"), json("bifurcation"), json("tube"), json(1)}) {
    expect_agreement(case_in({{"shape", shape}}));
    expect_agreement(with(minimal_case(), "/vessel/shape", shape));
    expect_agreement(with(box_case(), "/vessel/shape", shape));
  }
}

TEST(CaseSchema, AllowsNoOtherKeyAnywhere) {
  for (const json& document : full_cases()) {
    for (const char* place : {"/x", "/vessel/x", "/plasma/x", "/initial/x", "/numerics/x", "/output/x",
                              "/probes/0/x", "/effects/Bad", "/effects/_x", "/effects/a__b", "/effects/1"}) {
      EXPECT_FALSE(expect_agreement(with(document, place, "on"))) << place;
    }
    expect_agreement(with(document, "/effects/a_b2", "on"));
  }
  for (const char* place : {"/inflow/x", "/outflow/x", "/thrombi/0/y", "/cells/0/z"}) {
    EXPECT_FALSE(schema_accepts(with(full_cases()[0], place, "on"))) << place;
  }
  for (const char* place : {"/vessel/trunk/x", "/vessel/branches/1/x"}) {
    EXPECT_FALSE(schema_accepts(with(full_cases()[2], place, 1))) << place;
  }
}

TEST(CaseSchema, AgreesOnTextsListsAndSwitches) {
  const json full = full_cases()[0];
  for (const json& name : {json(std::string(200, 'x')), json(std::string(201, 'x')), json("tab\t"),
                           json("\x7f"), json("µµ"), json(3), json("")}) {
    expect_agreement(with(full, "/name", name));
    expect_agreement(with(full, "/probes/0/name", name));
  }
  for (const json& name : {json("a-b_9"), json("a b"), json("µ"), json(std::string(64, 'x')),
                           json(std::string(65, 'x')), json("a/b")}) {
    expect_agreement(with(full, "/probes/0/name", name));
  }
  for (const char* list : {"cells", "thrombi", "probes"}) {
    expect_agreement(with(full, std::string("/") + list, json::array()));
    expect_agreement(with(full, std::string("/") + list, json(32, full[list][0])));
    expect_agreement(with(full, std::string("/") + list, json(65, full[list][0])));
  }
  for (const json& position :
       {json("on"), json("off"), json("auto"), json("ON"), json(true), json(nullptr), json::object(),
        json{{"depth", 1e-7}}, json{{"Depth", 1}}, json{{"depth", "1"}}, json{{"depth", nullptr}}}) {
    expect_agreement(with(full, "/effects/bending", position));
  }
  for (const json& step : {json("auto"), json(1e-6), json("Auto"), json(0), json(-1), json(nullptr)}) {
    expect_agreement(with(full, "/numerics/time_step", step));
  }
  for (const json& interval : {json(0), json(0.0), json(1e-13), json(1e-3), json(-1), json(2000)}) {
    expect_agreement(with(full, "/output/frame_interval", interval));
  }
  for (const json& document : {json(nullptr), json(3), json::array(), json("x")}) expect_agreement(document);
}

TEST(CaseSchema, AgreesOnTuplesPairsAndListsWithoutRepetition) {
  const json full = full_cases()[0];
  const json point = {1.0, 2.0};
  for (const json& waveform :
       {json::array(), json::array({point}), json::array({point, {3}}), json::array({point, {3, 1, 1}}),
        json::array({1, 2}), json::array({{"1", 2}}), json(10'000, point), json(10'001, point)}) {
    expect_agreement(with(full, "/inflow/waveform", waveform));
  }
  const json branch = {{"length", 40e-6}, {"diameter", 10e-6}};
  for (const json& branches :
       {branch, json::array(), json::array({branch}), json::array({branch, branch}), json(3, branch),
        json::array({branch, 1}), json::array({branch, {{"length", 1}}})}) {
    expect_agreement(with(bifurcation_case(), "/vessel/branches", branches));
  }
  for (const json& pressure : {json(1), json::array({1, 2}), json::array({1}), json::array({1, "2"}),
                               json::array({1, 1e9}), json::array({1, 2, 3}), json("1")}) {
    expect_agreement(with(bifurcation_case(), "/outflow/pressure", pressure));
  }
  for (const json& fields : {json::array(), json::array({"velocity"}), json::array({"pressure", "velocity"}),
                             json::array({"velocity", "velocity"}), json::array({"speed"}), json("velocity"),
                             json::array({"velocity", "pressure", "wall_shear_stress"})}) {
    expect_agreement(with(full, "/output/fields", fields));
  }
}

void expect_described(const Key& key, json schema) {
  EXPECT_EQ(schema.at("description"), key.description) << key.name;
  EXPECT_TRUE(key.description.ends_with('.')) << key.name;
  EXPECT_EQ(schema.value("unit", ""), key.unit) << key.name;
  EXPECT_EQ(schema.contains("default"), !key.fallback.is_null()) << key.name;
  if (schema.contains("default")) {
    valijson::Schema parsed;
    parse(schema, parsed);
    EXPECT_TRUE(accepts(parsed, key.fallback)) << key.name;
  }
  if (key.or_pair) schema = json(schema["anyOf"][0]);
  if (key.kind == Kind::list) schema = json(schema["items"]);
  const Kind kind = key.kind == Kind::list ? key.entries : key.kind;
  if (kind == Kind::tuple) {
    for (std::size_t k = 0; k < key.members.size(); ++k) {
      EXPECT_EQ(schema["items"][k].at("title"), key.members[k].name);
      EXPECT_EQ(schema["items"][k].value("unit", ""), key.members[k].unit);
    }
    return;
  }
  for (const Key& member : key.members) expect_described(member, schema.at("properties").at(member.name));
  for (std::size_t k = 0; k < key.variants.size(); ++k) {
    for (const Key& member : members_of(key, key.variants[k])) {
      expect_described(member, schema.at("allOf")[k].at("then").at("properties").at(member.name));
    }
  }
}

TEST(CaseSchema, DescribesEveryKeyAndStatesUnitsAndDefaults) {
  expect_described(case_key(), case_schema());
  EXPECT_EQ(case_schema().at("$schema"), "http://json-schema.org/draft-07/schema#");
}

TEST(CaseSchema, IsTriedWithEveryKeyOfTheTable) {
  std::set<std::string> said;
  for_each_key([&](const json& document, const Key&, const std::string& place) {
    const bool shaped = place.starts_with("/vessel/");
    said.insert(shaped ? document["vessel"]["shape"].get<std::string>() + place : place);
  });
  const auto expect_said = [&](const auto& again, const std::vector<Key>& members, const std::string& pointer,
                               const std::string& shape) -> void {
    for (const Key& member : members) {
      std::string place = pointer + '/' + member.name;
      EXPECT_TRUE(said.contains(shape + place)) << shape + place;
      for (const Variant& variant : member.variants) {
        again(again, members_of(member, variant), place, variant.choice);
      }
      if (member.kind == Kind::tuple || member.entries == Kind::tuple || !member.variants.empty()) continue;
      if (member.kind == Kind::list || member.or_pair) place += "/0";
      again(again, member.members, place, shape);
    }
  };
  expect_said(expect_said, case_key().members, "", "");
}

}  // namespace
}  // namespace rouleau::testing
