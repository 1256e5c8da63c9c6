#include "engine/case/vessel_outline.h"

#include <cmath>
#include <numbers>

namespace rouleau {
namespace {

using Point = std::array<double, 2>;

double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

VesselOutline chain(const std::vector<Point>& corners, const std::vector<std::string>& names) {
  VesselOutline outline;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    outline.sides.push_back({corners[k], corners[(k + 1) % corners.size()], names[k]});
  }
  return outline;
}

VesselOutline rectangle(const Vessel& vessel) {
  const std::vector<std::string> names =
      vessel.shape == Shape::box && vessel.ends == Ends::closed
          ? std::vector<std::string>{"lower wall", "right wall", "upper wall", "left wall"}
      : is_open(vessel) ? std::vector<std::string>{"lower wall", "outlet", "upper wall", "inlet"}
                        : std::vector<std::string>{"lower wall", "right end", "upper wall", "left end"};
  const double length = vessel.length, diameter = vessel.diameter;
  VesselOutline outline = chain({{0, 0}, {length, 0}, {length, diameter}, {0, diameter}}, names);
  outline.lower = {0};
  outline.upper = {2};
  return outline;
}

/// The far ends of a branch's outer and inner wall; `down` is 1 for the lower branch and -1 for the upper
/// one.
std::array<Point, 2> outlet_of(const Vessel& vessel, const Branch& branch, double down) {
  const double s = std::sin(radians(vessel.half_angle)), c = std::cos(radians(vessel.half_angle));
  const Point outer = {vessel.length + branch.length * c,
                       (down > 0 ? 0 : vessel.diameter) - down * branch.length * s};
  return {outer, {outer[0] + branch.diameter * s, outer[1] + down * branch.diameter * c}};
}

VesselOutline bifurcation(const Vessel& vessel) {
  const auto [lower_outer, lower_inner] = outlet_of(vessel, vessel.branches[0], 1);
  const auto [upper_outer, upper_inner] = outlet_of(vessel, vessel.branches[1], -1);
  VesselOutline outline = chain({{0, 0},
                                 {vessel.length, 0},
                                 lower_outer,
                                 lower_inner,
                                 apex_of(vessel),
                                 upper_inner,
                                 upper_outer,
                                 {vessel.length, vessel.diameter},
                                 {0, vessel.diameter}},
                                {"trunk's lower wall", "lower branch's outer wall", "lower outlet",
                                 "lower branch's inner wall", "upper branch's inner wall", "upper outlet",
                                 "upper branch's outer wall", "trunk's upper wall", "inlet"});
  outline.lower = {0, 1};
  outline.upper = {7, 6};
  outline.inner = {3, 4};
  return outline;
}

}  // namespace

bool VesselOutline::contains(const Point& point) const {
  bool inside = false;
  for (const auto& [from, to, name] : sides) {
    if ((from[1] > point[1]) == (to[1] > point[1])) continue;
    const double t = (point[1] - from[1]) / (to[1] - from[1]);
    if (point[0] < std::lerp(from[0], to[0], t)) inside = !inside;
  }
  return inside;
}

double VesselOutline::area() const {
  double twice = 0;
  for (const auto& [from, to, name] : sides) twice += from[0] * to[1] - from[1] * to[0];
  return twice / 2;
}

VesselOutline outline_of(const Vessel& vessel) {
  return vessel.shape == Shape::bifurcation ? bifurcation(vessel) : rectangle(vessel);
}

Point apex_of(const Vessel& vessel) {
  const double s = std::sin(radians(vessel.half_angle)), c = std::cos(radians(vessel.half_angle));
  const double lower = vessel.branches[0].diameter, upper = vessel.branches[1].diameter;
  return {vessel.length + (lower + upper - vessel.diameter * c) / (2 * s),
          vessel.diameter / 2 + (lower - upper) / (2 * c)};
}

}  // namespace rouleau
