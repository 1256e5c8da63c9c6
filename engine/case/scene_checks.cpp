#include "engine/case/scene_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "engine/case/content_checks.h"
#include "engine/case/vessel_outline.h"
#include "engine/case/wording.h"

namespace rouleau {
namespace {

using Point = std::array<double, 2>;

std::string meters(double length) {
  return rounded(length, "m");
}

struct VesselPart {
  std::string name;
  double length = 0, diameter = 0;  ///< m
};

std::vector<VesselPart> parts_of(const Vessel& vessel) {
  if (vessel.shape == Shape::box) return {{"box", vessel.length, vessel.diameter}};
  if (vessel.shape == Shape::straight) return {{"vessel", vessel.length, vessel.diameter}};
  return {{"trunk", vessel.length, vessel.diameter},
          {"lower branch", vessel.branches[0].length, vessel.branches[0].diameter},
          {"upper branch", vessel.branches[1].length, vessel.branches[1].diameter}};
}

void check_resolution(const Case& scene, const VesselOutline& outline, Faults& faults) {
  const double spacing = scene.numerics.spacing;
  for (const auto& [name, length, diameter] : parts_of(scene.vessel)) {
    const double least = std::min(diameter, length) / spacing;
    if (least >= least_particles_across * (1 - rounding)) continue;
    faults.add("/numerics/spacing", meters(spacing) + " puts " + rounded(least, "particles") +
                                        " across the " + name + " (" + meters(length) + " by " +
                                        meters(diameter) + "); at least " + in_words(least_particles_across) +
                                        " are needed");
  }
  const double particles = outline.area() / (spacing * spacing);
  if (particles > most_particles) {
    faults.add("/numerics/spacing", meters(spacing) + " fills the vessel with " +
                                        rounded(particles, "particles") + "; at most " +
                                        in_words(most_particles) + " are allowed");
  }
}

/// The flow develops before the apex and again behind it, over a diameter at least.
void check_apex(const Vessel& vessel, Faults& faults) {
  const Point apex = apex_of(vessel);
  if (apex[0] < vessel.diameter * (1 - rounding)) {
    faults.add("/vessel/trunk", "the branches' inner walls meet at x = " + meters(apex[0]) +
                                    "; at least the trunk's diameter, " + meters(vessel.diameter) +
                                    ", must lie before that: a trunk longer than " +
                                    meters(vessel.length + vessel.diameter - apex[0]) + " would do");
  }
  const double angle = vessel.half_angle * std::numbers::pi / 180;
  for (const std::size_t k : {0U, 1U}) {
    const double across = k == 0 ? apex[1] : vessel.diameter - apex[1];
    // How far along the branch's outer wall, from its corner, the apex lies.
    const double along = (apex[0] - vessel.length) * std::cos(angle) - across * std::sin(angle);
    const Branch& branch = vessel.branches[k];
    const double inner = branch.length - along;
    if (inner >= branch.diameter * (1 - rounding)) continue;
    faults.add("/vessel/branches", "the inner wall of the " + std::string(k == 0 ? "lower" : "upper") +
                                       " branch is " + meters(inner) + " long; at least its diameter, " +
                                       meters(branch.diameter) + ", is needed: a branch longer than " +
                                       meters(along + branch.diameter) + " would do");
  }
}

void check_probes(const Case& scene, const VesselOutline& outline, Faults& faults) {
  Point low = outline.sides[0].from, high = low;
  for (const VesselSide& side : outline.sides) {
    for (const std::size_t axis : {0U, 1U}) {
      low[axis] = std::min(low[axis], side.to[axis]);
      high[axis] = std::max(high[axis], side.to[axis]);
    }
  }
  const auto outside = [&](const Point& point, std::size_t axis) {
    const double tolerance = rounding * (high[axis] - low[axis]);
    return point[axis] < low[axis] - tolerance || point[axis] > high[axis] + tolerance;
  };
  for (std::size_t k = 0; k < scene.probes.size(); ++k) {
    const std::string place = pointer_to("/probes", k);
    if (!faults.clean(place)) continue;
    const Probe& probe = scene.probes[k];
    for (const auto& [name, point] : {std::pair{"from", probe.from}, std::pair{"to", probe.to}}) {
      for (const std::size_t axis : {0U, 1U}) {
        if (!outside(point, axis)) continue;
        faults.add(pointer_to(pointer_to(place, name), axis),
                   "found " + meters(point[axis]) + "; the vessel reaches from " + meters(low[axis]) +
                       " to " + meters(high[axis]));
      }
      if (probe.to == probe.from) break;
    }
  }
}

void check_points_of_probes(const std::vector<Probe>& probes, Faults& faults) {
  for (std::size_t k = 0; k < probes.size(); ++k) {
    const std::string place = pointer_to("/probes", k);
    if (!faults.clean(place)) continue;
    const bool line = probes[k].to != probes[k].from;
    if (line && probes[k].points == 1) {
      faults.add(pointer_to(place, "points"), "found 1 on a line; at least 2 are needed, one for either end");
    } else if (!line && probes[k].points > 1) {
      faults.add(pointer_to(place, "points"), "found " + std::to_string(probes[k].points) +
                                                  " where \"from\" and \"to\" are the same; allowed is 1");
    }
    for (std::size_t j = 0; j < k; ++j) {
      if (probes[j].name != probes[k].name || !faults.clean(pointer_to("/probes", j))) continue;
      faults.add(pointer_to(place, "name"), "found \"" + probes[k].name + "\", the name of probe " +
                                                std::to_string(j) + "; each needs its own");
      break;
    }
  }
}

void check_amount_of_output(const Case& scene, Faults& faults) {
  const auto check = [&](const char* pointer, double interval, double most) {
    if (interval > 0 && scene.duration / interval > most) {
      faults.add(pointer, "found " + rounded(interval, "s") + ", which makes " +
                              rounded(scene.duration / interval, "entries") +
                              " in the whole duration; at most " + in_words(most) + " are allowed");
    }
  };
  check("/output/series_interval", scene.output.series_interval, most_series_rows);
  check("/output/frame_interval", scene.output.frame_interval, most_frames);
}

}  // namespace

void check_scene(const Case& scene, Faults& faults) {
  const bool output_known = faults.clean("/output") && faults.clean("/duration");
  if (scene.vessel.shape == Shape::bifurcation && faults.clean("/vessel")) check_apex(scene.vessel, faults);
  if (faults.clean("/vessel")) {
    const VesselOutline outline = outline_of(scene.vessel);
    check_probes(scene, outline, faults);
    if (faults.clean("/numerics")) {
      check_resolution(scene, outline, faults);
      check_contents(scene, outline, faults);
    }
  }
  check_points_of_probes(scene.probes, faults);
  if (output_known) check_amount_of_output(scene, faults);
}

}  // namespace rouleau
