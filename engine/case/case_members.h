#pragma once

#include <nlohmann/json.hpp>

#include "engine/case/case.h"

namespace rouleau {

/// The words that stand for the choices; every one also stands in the table of keys (case_keys.cpp).
NLOHMANN_JSON_SERIALIZE_ENUM(Profile, {{Profile::plug, "plug"}, {Profile::parabolic, "parabolic"}})
NLOHMANN_JSON_SERIALIZE_ENUM(Wall, {{Wall::lower, "lower"}, {Wall::upper, "upper"}})
NLOHMANN_JSON_SERIALIZE_ENUM(Switch, {{Switch::automatic, "auto"}, {Switch::on, "on"}, {Switch::off, "off"}})
NLOHMANN_JSON_SERIALIZE_ENUM(Preset, {{Preset::standard, "standard"},
                                      {Preset::draft, "draft"},
                                      {Preset::fine, "fine"}})

/// A case from a document whose every key is known and whose every value is sound. What it leaves out takes
/// its default.
Case case_from_sound(const nlohmann::json& document);

}  // namespace rouleau
