#include "engine/case/case_members.h"

#include "engine/case/case_json.h"
#include "engine/case/presets.h"

namespace rouleau {
namespace {

using nlohmann::json;

/// One value for both branches, or a list of the lower and the upper one.
template <typename Member>
void take_pair(const json& object, const char* name, std::array<Member, 2>& pair) {
  const auto value = object.find(name);
  if (value == object.end()) return;
  for (std::size_t k = 0; k < 2; ++k) (value->is_array() ? (*value)[k] : *value).get_to(pair[k]);
}

template <typename Member>
void take(const json& object, const char* name, Member& member) {
  if (const auto value = object.find(name); value != object.end()) value->get_to(member);
}

}  // namespace

void from_json(const json& object, WallVelocity& walls) {
  take(object, "lower", walls.lower);
  take(object, "upper", walls.upper);
  take(object, "left", walls.left);
  take(object, "right", walls.right);
}

void from_json(const json& object, Branch& branch) {
  take(object, "length", branch.length);
  take(object, "diameter", branch.diameter);
}

void to_json(json& object, const Branch& branch) {
  object = {{"length", branch.length}, {"diameter", branch.diameter}};
}

void from_json(const json& object, Vessel& vessel) {
  take(object, "shape", vessel.shape);
  if (vessel.shape == Shape::box) vessel.ends = Ends::closed;
  take(object, "ends", vessel.ends);
  take(object, "wall_velocity", vessel.wall_velocity);
  take(object, vessel.shape == Shape::box ? "width" : "length", vessel.length);
  take(object, vessel.shape == Shape::box ? "height" : "diameter", vessel.diameter);
  if (const auto trunk = object.find("trunk"); trunk != object.end()) {
    take(*trunk, "length", vessel.length);
    take(*trunk, "diameter", vessel.diameter);
  }
  take_pair(object, "branches", vessel.branches);
  take(object, "half_angle", vessel.half_angle);
}

void to_json(json& object, const Vessel& vessel) {
  object = {{"shape", vessel.shape}};
  if (vessel.shape == Shape::bifurcation) {
    object["trunk"] = Branch{vessel.length, vessel.diameter};
    object["branches"] = vessel.branches;
    object["half_angle"] = vessel.half_angle;
    return;
  }
  const bool box = vessel.shape == Shape::box;
  object[box ? "width" : "length"] = vessel.length;
  object[box ? "height" : "diameter"] = vessel.diameter;
  object["ends"] = vessel.ends;
  const WallVelocity& walls = vessel.wall_velocity;
  if (may_move_walls(vessel)) {
    object["wall_velocity"] = {{"lower", walls.lower}, {"upper", walls.upper}};
    if (box) object["wall_velocity"].update({{"left", walls.left}, {"right", walls.right}});
  }
}

void from_json(const json& object, Plasma& plasma) {
  take(object, "density", plasma.density);
  take(object, "kinematic_viscosity", plasma.kinematic_viscosity);
}

void to_json(json& object, const Plasma& plasma) {
  object = {{"density", plasma.density}, {"kinematic_viscosity", plasma.kinematic_viscosity}};
}

void from_json(const json& pair, WaveformPoint& point) {
  pair.at(0).get_to(point.time);
  pair.at(1).get_to(point.factor);
}

void to_json(json& pair, const WaveformPoint& point) {
  pair = json::array({point.time, point.factor});
}

void from_json(const json& object, Inflow& inflow) {
  take(object, "velocity", inflow.velocity);
  take(object, "profile", inflow.profile);
  take(object, "waveform", inflow.waveform);
}

void to_json(json& object, const Inflow& inflow) {
  object = {{"velocity", inflow.velocity}, {"profile", inflow.profile}, {"waveform", inflow.waveform}};
}

void from_json(const json& object, Outflow& outflow) {
  take_pair(object, "pressure", outflow.pressure);
}

void from_json(const json& object, Initial& initial) {
  take(object, "flow", initial.flow);
  take(object, "velocity", initial.velocity);
}

void to_json(json& object, const Initial& initial) {
  object = {{"flow", initial.flow}};
  if (initial.flow == InitialFlow::taylor_green) object["velocity"] = initial.velocity;
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
  take(object, "shape", cell.shape);
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
            {"shape", cell.shape}};
}

void from_json(const json& object, Numerics& numerics) {
  take(object, "preset", numerics.preset);
  numerics = preset_numerics(numerics.preset);
  take(object, "spacing", numerics.spacing);
  if (const auto step = object.find("time_step"); step != object.end()) {
    numerics.time_step = step->is_number() ? std::optional(step->get<double>()) : std::nullopt;
  }
  take(object, "kernel_radius", numerics.kernel_radius);
  take(object, "viscosity", numerics.viscosity);
  take(object, "substeps", numerics.substeps);
  take(object, "pressure_tolerance", numerics.pressure_tolerance);
  take(object, "threads", numerics.threads);
  take(object, "refine", numerics.refine);
}

void to_json(json& object, const Numerics& numerics) {
  object = {{"preset", numerics.preset},
            {"spacing", numerics.spacing},
            {"time_step", numerics.time_step ? json(*numerics.time_step) : json("auto")},
            {"kernel_radius", numerics.kernel_radius},
            {"viscosity", numerics.viscosity},
            {"pressure_tolerance", numerics.pressure_tolerance},
            {"threads", numerics.threads},
            {"refine", numerics.refine}};
  if (numerics.viscosity == Viscosity::substeps) object["substeps"] = numerics.substeps;
}

void from_json(const json& object, OutputSettings& output) {
  take(object, "series_interval", output.series_interval);
  take(object, "frame_interval", output.frame_interval);
  take(object, "fields", output.fields);
}

void to_json(json& object, const OutputSettings& output) {
  object = {{"series_interval", output.series_interval},
            {"frame_interval", output.frame_interval},
            {"fields", output.fields}};
}

void from_json(const json& object, Probe& probe) {
  take(object, "name", probe.name);
  take(object, "from", probe.from);
  probe.to = probe.from;
  take(object, "to", probe.to);
  take(object, "points", probe.points);
}

void to_json(json& object, const Probe& probe) {
  object = {{"name", probe.name}, {"from", probe.from}, {"to", probe.to}, {"points", probe.points}};
}

void from_json(const json& document, EffectWish& wish) {
  wish = document.is_object() ? EffectWish(Switch::on, document) : EffectWish(document.get<Switch>());
}

void to_json(json& document, const EffectWish& wish) {
  if (wish.parameters.empty()) {
    document = wish.position;
  } else {
    document = wish.parameters;
  }
}

Case case_from_sound(const json& document) {
  Case result;
  take(document, "name", result.name);
  take(document, "vessel", result.vessel);
  take(document, "plasma", result.plasma);
  take(document, "inflow", result.inflow);
  take(document, "outflow", result.outflow);
  take(document, "body_acceleration", result.body_acceleration);
  take(document, "initial", result.initial);
  take(document, "thrombi", result.thrombi);
  take(document, "cells", result.cells);
  take(document, "effects", result.effects);
  take(document, "numerics", result.numerics);
  take(document, "duration", result.duration);
  take(document, "output", result.output);
  take(document, "probes", result.probes);
  return result;
}

json to_json(const Case& resolved) {
  json document = {{"version", 1},
                   {"name", resolved.name},
                   {"vessel", resolved.vessel},
                   {"plasma", resolved.plasma},
                   {"initial", resolved.initial},
                   {"thrombi", resolved.thrombi},
                   {"cells", resolved.cells},
                   {"numerics", resolved.numerics},
                   {"duration", resolved.duration},
                   {"output", resolved.output},
                   {"probes", resolved.probes}};
  if (is_open(resolved.vessel)) {
    document["inflow"] = resolved.inflow;
    document["outflow"] = {{"pressure", resolved.outflow.pressure[0]}};
    if (resolved.vessel.shape == Shape::bifurcation) {
      document["outflow"]["pressure"] = resolved.outflow.pressure;
    }
  } else {
    document["body_acceleration"] = resolved.body_acceleration;
  }
  document["effects"] = json::object();
  for (const auto& [name, wish] : resolved.effects) document["effects"][name] = wish;
  return document;
}

}  // namespace rouleau
