#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "service/api/etag.h"
#include "service/commands/case_file.h"
#include "service/commands/command.h"
#include "service/commands/progress_line.h"
#include "service/time_text.h"

namespace rouleau::service {
namespace {

TEST(Times, AreRfc3339) {
  EXPECT_EQ(format_time(0), "1970-01-01T00:00:00.000Z");
  EXPECT_EQ(format_time(1795318393042), "2026-11-22T03:33:13.042Z");
}

TEST(TimeLeft, IsSaidInTwoUnits) {
  EXPECT_EQ(format_time_left(8.4), "8 s");
  EXPECT_EQ(format_time_left(192), "3 min 12 s");
  EXPECT_EQ(format_time_left(3840), "1 h 04 min");
  EXPECT_EQ(format_time_left(-1), "unknown time");
}

TEST(ETags, AreComparedWeakly) {
  EXPECT_TRUE(names_etag("\"a\", W/\"b\"", "\"b\""));
  EXPECT_TRUE(names_etag("W/\"a\"", "W/\"a\""));
  EXPECT_TRUE(names_etag("*", "\"a\""));
  EXPECT_FALSE(names_etag("", "\"a\""));
  EXPECT_FALSE(names_etag("\"ab\"", "\"a\""));
}

TEST(Settings, ChangeACase) {
  nlohmann::json document = nlohmann::json::parse(R"({"vessel": {"length": 1}, "thrombi": [{"x": 2}]})");
  apply_settings(document,
                 {"/vessel/length=8e-5", "/thrombi/0/wall=lower", "/cells=[{\"x\":1}]", "/name=a=b"});
  EXPECT_EQ(document,
            nlohmann::json::parse(R"({"vessel": {"length": 8e-5}, "thrombi": [{"x": 2, "wall": "lower"}],
                                                "cells": [{"x": 1}], "name": "a=b"})"));
}

TEST(Settings, ThatFitNowhereAreBadInput) {
  for (const char* const setting : {"vessel=1", "/vessel", "/vessel/length/x=1", "/thrombi/a=1", ""}) {
    nlohmann::json document = nlohmann::json::parse(R"({"vessel": {"length": 1}, "thrombi": []})");
    EXPECT_THROW(apply_settings(document, {setting}), CommandError) << setting;
  }
}

}  // namespace
}  // namespace rouleau::service
