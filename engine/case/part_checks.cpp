#include "engine/case/part_checks.h"

#include <string>

#include <nlohmann/json.hpp>

#include "engine/case/wording.h"

namespace rouleau {
namespace {

using nlohmann::json;

/// The least-squares operators fail with fewer neighbours than this radius holds.
constexpr double least_implicit_radius = 2.6;

bool is_given(const json& document, const char* pointer) {
  return document.contains(json::json_pointer(pointer));
}

std::string kind_of(const Vessel& vessel) {
  if (vessel.shape == Shape::bifurcation) return "a bifurcation";
  const std::string ends = vessel.ends == Ends::open       ? "an open "
                           : vessel.ends == Ends::periodic ? "a periodic "
                                                           : "a closed ";
  return ends + (vessel.shape == Shape::box ? "box" : "vessel");
}

void check_drive(const json& given, const Vessel& vessel, Faults& faults) {
  const std::string kind = kind_of(vessel);
  if (!is_open(vessel)) {
    if (is_given(given, "/inflow")) faults.add("/inflow", kind + " has no inlet; leave it out");
    if (is_given(given, "/outflow")) faults.add("/outflow", kind + " has no outlet; leave it out");
  } else if (is_given(given, "/body_acceleration")) {
    faults.add("/body_acceleration", kind + " is driven by its inflow; leave it out, or take periodic ends");
  }
  if (is_given(given, "/vessel/wall_velocity") && !may_move_walls(vessel)) {
    faults.add("/vessel/wall_velocity",
               vessel.shape == Shape::box
                   ? kind + " has no walls; leave it out"
                   : kind + " with moving walls has no developed flow to feed; take periodic ends");
  }
  if (vessel.shape != Shape::bifurcation && is_given(given, "/outflow/pressure/0")) {
    faults.add("/outflow/pressure", "found a list of 2, but there is one outlet; allowed is one number");
  }
}

void check_contents(const Case& scene, Faults& faults) {
  const Vessel& vessel = scene.vessel;
  if (vessel.ends == Ends::periodic && vessel.shape == Shape::box && !scene.thrombi.empty()) {
    faults.add("/thrombi", kind_of(vessel) + " has no walls for thrombi to sit on; leave them out");
  }
  for (std::size_t k = 0; k < scene.cells.size(); ++k) {
    const std::string place = pointer_to("/cells", k);
    if (!deflates(scene.cells[k]) || is_open(vessel) || !faults.clean(place)) continue;
    faults.add(pointer_to(place, "shape"),
               "found circle, but from " + kind_of(vessel) +
                   " the fluid of a cell that deflates cannot leave; take rest, an open vessel, or fill 1");
  }
  for (std::size_t k = 0; k < scene.thrombi.size(); ++k) {
    const bool lower = scene.thrombi[k].wall == Wall::lower;
    const double speed = lower ? vessel.wall_velocity.lower : vessel.wall_velocity.upper;
    if (speed == 0 || !faults.clean(pointer_to("/thrombi", k))) continue;
    faults.add(pointer_to("/thrombi", k), std::string("sits on the ") + (lower ? "lower" : "upper") +
                                              " wall, which moves at " + rounded(speed, "m/s") +
                                              "; a thrombus needs a wall at rest");
  }
}

void check_initial(const json& given, const Case& scene, Faults& faults) {
  const Vessel& vessel = scene.vessel;
  const bool vortices = scene.initial.flow == InitialFlow::taylor_green;
  if (vortices && (vessel.shape != Shape::box || vessel.ends != Ends::periodic)) {
    faults.add("/initial/flow", "taylor_green fills a periodic box, and this is " + kind_of(vessel) +
                                    "; allowed are auto, rest and, but in a box, developed");
  }
  if (scene.initial.flow == InitialFlow::developed && vessel.shape == Shape::box) {
    faults.add("/initial/flow", kind_of(vessel) + " has no developed flow; allowed are auto and rest" +
                                    (vessel.ends == Ends::periodic ? " and taylor_green" : ""));
  }
  if (vortices && !is_given(given, "/initial/velocity")) {
    faults.add("/initial/velocity",
               "missing; taylor_green needs the greatest velocity of its vortices (m/s)");
  }
  if (!vortices && is_given(given, "/initial/velocity")) {
    faults.add("/initial/velocity", "only taylor_green takes a velocity; leave it out");
  }
}

void check_waveform(const Inflow& inflow, Faults& faults) {
  for (std::size_t k = 1; k < inflow.waveform.size(); ++k) {
    const double before = inflow.waveform[k - 1].time, now = inflow.waveform[k].time;
    if (now > before) continue;
    faults.add(pointer_to("/inflow/waveform", k), "found the time " + in_words(now) + " s after " +
                                                      in_words(before) + " s; times must increase");
  }
}

void check_numerics(const json& given, const Numerics& numerics, Faults& faults) {
  const bool implicit = numerics.viscosity == Viscosity::implicit;
  const bool paper = numerics.preset == Preset::paper;
  if (paper == implicit) {
    faults.add("/numerics/viscosity",
               paper ? "found implicit, but the preset paper is the published scheme, which takes substeps; "
                       "leave it out, or choose another preset"
                     : "found substeps, which belong to the published scheme; choose the preset paper");
    return;
  }
  if (implicit && numerics.kernel_radius < least_implicit_radius) {
    faults.add("/numerics/kernel_radius",
               "found " + in_words(numerics.kernel_radius) + "; the least-squares operators need at least " +
                   in_words(least_implicit_radius) + ", only the preset paper takes less");
  }
  if (implicit && is_given(given, "/numerics/substeps")) {
    faults.add("/numerics/substeps", "implicit viscosity takes no substeps; leave it out");
  }
}

/// What the published scheme has not.
void check_preset_of_cells(const Case& scene, Faults& faults) {
  if (scene.numerics.preset != Preset::paper) return;
  for (std::size_t k = 0; k < scene.cells.size(); ++k) {
    const std::string place = pointer_to("/cells", k);
    if (!faults.clean(place)) continue;
    if (scene.cells[k].shape != CellShape::rest) {
      faults.add(pointer_to(place, "shape"),
                 "found circle, but in the preset paper cells start relaxed; take rest or another preset");
    }
    if (scene.cells[k].viscosity_ratio != 1) {
      faults.add(pointer_to(place, "viscosity_ratio"),
                 "found " + in_words(scene.cells[k].viscosity_ratio) +
                     ", but in the preset paper cells are as viscous as plasma; take 1 or another preset");
    }
  }
}

}  // namespace

void check_parts(const json& given, const Case& scene, Faults& faults) {
  if (faults.clean("/vessel")) {
    check_drive(given, scene.vessel, faults);
    check_contents(scene, faults);
    if (faults.clean("/initial")) check_initial(given, scene, faults);
  }
  if (faults.clean("/inflow/waveform")) check_waveform(scene.inflow, faults);
  if (faults.clean("/numerics")) {
    check_numerics(given, scene.numerics, faults);
    check_preset_of_cells(scene, faults);
  }
}

}  // namespace rouleau
