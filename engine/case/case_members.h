#pragma once

#include <nlohmann/json.hpp>

#include "engine/case/case.h"

namespace rouleau {

/// The words that stand for the choices; every one also stands in the table of keys (case_keys.cpp).
NLOHMANN_JSON_SERIALIZE_ENUM(Shape, {{Shape::straight, "straight"},
                                     {Shape::bifurcation, "bifurcation"},
                                     {Shape::box, "box"}})
NLOHMANN_JSON_SERIALIZE_ENUM(Ends,
                             {{Ends::open, "open"}, {Ends::periodic, "periodic"}, {Ends::closed, "closed"}})
NLOHMANN_JSON_SERIALIZE_ENUM(Profile, {{Profile::plug, "plug"}, {Profile::parabolic, "parabolic"}})
NLOHMANN_JSON_SERIALIZE_ENUM(InitialFlow, {{InitialFlow::automatic, "auto"},
                                           {InitialFlow::rest, "rest"},
                                           {InitialFlow::developed, "developed"},
                                           {InitialFlow::taylor_green, "taylor_green"}})
NLOHMANN_JSON_SERIALIZE_ENUM(Wall, {{Wall::lower, "lower"}, {Wall::upper, "upper"}})
NLOHMANN_JSON_SERIALIZE_ENUM(CellShape, {{CellShape::rest, "rest"}, {CellShape::circle, "circle"}})
NLOHMANN_JSON_SERIALIZE_ENUM(Switch, {{Switch::automatic, "auto"}, {Switch::on, "on"}, {Switch::off, "off"}})
NLOHMANN_JSON_SERIALIZE_ENUM(Preset, {{Preset::standard, "standard"},
                                      {Preset::draft, "draft"},
                                      {Preset::fine, "fine"},
                                      {Preset::paper, "paper"}})
NLOHMANN_JSON_SERIALIZE_ENUM(Viscosity,
                             {{Viscosity::implicit, "implicit"}, {Viscosity::substeps, "substeps"}})
NLOHMANN_JSON_SERIALIZE_ENUM(Refine, {{Refine::automatic, "auto"}, {Refine::off, "off"}})
NLOHMANN_JSON_SERIALIZE_ENUM(Field, {{Field::velocity, "velocity"},
                                     {Field::pressure, "pressure"},
                                     {Field::wall_shear_stress, "wall_shear_stress"}})

/// A case from a document whose every key is known and whose every value is sound. What it leaves out takes
/// its default.
Case case_from_sound(const nlohmann::json& document);

}  // namespace rouleau
