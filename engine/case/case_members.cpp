#include "engine/case/case_members.h"

#include "engine/case/case_json.h"
#include "engine/case/presets.h"

namespace rouleau {
namespace {

using nlohmann::json;

template <typename Member>
void take(const json& object, const char* name, Member& member) {
  if (const auto value = object.find(name); value != object.end()) value->get_to(member);
}

}  // namespace

void from_json(const json& object, Vessel& vessel) {
  take(object, "length", vessel.length);
  take(object, "diameter", vessel.diameter);
}

void to_json(json& object, const Vessel& vessel) {
  object = {
      {"shape", "straight"}, {"ends", "open"}, {"length", vessel.length}, {"diameter", vessel.diameter}};
}

void from_json(const json& object, Plasma& plasma) {
  take(object, "density", plasma.density);
  take(object, "kinematic_viscosity", plasma.kinematic_viscosity);
}

void to_json(json& object, const Plasma& plasma) {
  object = {{"density", plasma.density}, {"kinematic_viscosity", plasma.kinematic_viscosity}};
}

void from_json(const json& object, Inflow& inflow) {
  take(object, "velocity", inflow.velocity);
  take(object, "profile", inflow.profile);
}

void to_json(json& object, const Inflow& inflow) {
  object = {{"velocity", inflow.velocity}, {"profile", inflow.profile}};
}

void from_json(const json& object, Outflow& outflow) {
  take(object, "pressure", outflow.pressure[0]);
}

void to_json(json& object, const Outflow& outflow) {
  object = {{"pressure", outflow.pressure[0]}};
}

void from_json(const json& object, Thrombus& thrombus) {
  take(object, "wall", thrombus.wall);
  take(object, "x", thrombus.x);
  take(object, "radius", thrombus.radius);
}

void to_json(json& object, const Thrombus& thrombus) {
  object = {{"wall", thrombus.wall}, {"x", thrombus.x}, {"radius", thrombus.radius}};
}

void from_json(const json& object, RedCell& cell) {
  take(object, "x", cell.x);
  take(object, "y", cell.y);
  take(object, "diameter", cell.diameter);
  take(object, "fill", cell.fill);
  take(object, "angle", cell.angle);
  take(object, "stretch_modulus", cell.stretch_modulus);
  take(object, "bend_modulus", cell.bend_modulus);
  take(object, "viscosity_ratio", cell.viscosity_ratio);
}

void to_json(json& object, const RedCell& cell) {
  object = {{"x", cell.x},
            {"y", cell.y},
            {"diameter", cell.diameter},
            {"fill", cell.fill},
            {"angle", cell.angle},
            {"stretch_modulus", cell.stretch_modulus},
            {"bend_modulus", cell.bend_modulus},
            {"viscosity_ratio", cell.viscosity_ratio},
            {"shape", "rest"}};
}

void from_json(const json& object, Numerics& numerics) {
  take(object, "preset", numerics.preset);
  numerics = preset_numerics(numerics.preset);
  take(object, "spacing", numerics.spacing);
  if (const auto step = object.find("time_step"); step != object.end() && step->is_number()) {
    numerics.time_step = step->get<double>();
  }
  take(object, "kernel_radius", numerics.kernel_radius);
  take(object, "pressure_tolerance", numerics.pressure_tolerance);
  take(object, "threads", numerics.threads);
}

void to_json(json& object, const Numerics& numerics) {
  object = {{"preset", numerics.preset},
            {"spacing", numerics.spacing},
            {"time_step", numerics.time_step ? json(*numerics.time_step) : json("auto")},
            {"kernel_radius", numerics.kernel_radius},
            {"pressure_tolerance", numerics.pressure_tolerance},
            {"threads", numerics.threads}};
}

void from_json(const json& object, OutputSettings& output) {
  take(object, "series_interval", output.series_interval);
  take(object, "frame_interval", output.frame_interval);
}

void to_json(json& object, const OutputSettings& output) {
  object = {{"series_interval", output.series_interval}, {"frame_interval", output.frame_interval}};
}

Case case_from_sound(const json& document) {
  Case result;
  take(document, "name", result.name);
  take(document, "vessel", result.vessel);
  take(document, "plasma", result.plasma);
  take(document, "inflow", result.inflow);
  take(document, "outflow", result.outflow);
  take(document, "thrombi", result.thrombi);
  take(document, "cells", result.cells);
  take(document, "effects", result.effects);
  take(document, "numerics", result.numerics);
  take(document, "duration", result.duration);
  take(document, "output", result.output);
  return result;
}

json to_json(const Case& resolved) {
  json document = {{"version", 1},
                   {"name", resolved.name},
                   {"vessel", resolved.vessel},
                   {"plasma", resolved.plasma},
                   {"inflow", resolved.inflow},
                   {"outflow", resolved.outflow},
                   {"thrombi", resolved.thrombi},
                   {"cells", resolved.cells},
                   {"numerics", resolved.numerics},
                   {"duration", resolved.duration},
                   {"output", resolved.output}};
  document["effects"] = json::object();
  for (const auto& [name, position] : resolved.effects) document["effects"][name] = position;
  return document;
}

}  // namespace rouleau
