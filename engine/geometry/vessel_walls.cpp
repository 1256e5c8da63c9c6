#include "engine/geometry/vessel_walls.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/geometry/wall_leg.h"

namespace rouleau::geometry {

namespace {

Point operator+(const Point& a, const Point& b) {
  return {a[0] + b[0], a[1] + b[1]};
}
Point operator*(double s, const Point& a) {
  return {s * a[0], s * a[1]};
}

/// What a case says of its walls, in the outline's units.
struct Description {
  double length, height;
  WallVelocity speed;
  std::array<Branch, 2> branches;
  double half_angle;               ///< radians
  std::vector<Bump> lower, upper;  ///< sorted by x, as on a straight wall
};

Description describe(const Case& scene, double unit_length, double unit_velocity) {
  const Vessel& v = scene.vessel;
  Description d{v.length / unit_length,
                v.diameter / unit_length,
                {v.wall_velocity.lower / unit_velocity, v.wall_velocity.upper / unit_velocity,
                 v.wall_velocity.left / unit_velocity, v.wall_velocity.right / unit_velocity},
                v.branches,
                v.half_angle * std::numbers::pi / 180,
                {},
                {}};
  for (Branch& branch : d.branches) {
    branch = {branch.length / unit_length, branch.diameter / unit_length};
  }
  for (const Thrombus& t : scene.thrombi) {
    const bool on_lower = t.wall == Wall::lower;
    (on_lower ? d.lower : d.upper)
        .push_back({{t.x / unit_length, on_lower ? 0 : d.height}, t.radius / unit_length});
  }
  for (auto* bumps : {&d.lower, &d.upper}) {
    std::sort(bumps->begin(), bumps->end(),
              [](const Bump& a, const Bump& b) { return a.centre[0] < b.centre[0]; });
  }
  return d;
}

std::vector<Bump> reversed(std::vector<Bump> bumps) {
  std::reverse(bumps.begin(), bumps.end());
  return bumps;
}

/// What two parallel walls leave open, and what stands on them.
double gap_between(const std::vector<Bump>& lower, const std::vector<Bump>& upper, double width,
                   double period) {
  double least = width;
  for (const Bump& a : lower) least = std::min(least, width - a.radius);
  for (const Bump& b : upper) {
    least = std::min(least, width - b.radius);
    for (const Bump& a : lower) {
      double dx = a.centre[0] - b.centre[0];
      if (period > 0) dx -= period * std::round(dx / period);
      least = std::min(least, std::hypot(dx, width) - a.radius - b.radius);
    }
  }
  return least;
}

/// Adds the area and takes the bounds of the fluid without thrombi, from its corners counter-clockwise.
void measure(const std::vector<Point>& corners, VesselWalls& walls) {
  walls.bounds = {corners[0][0], corners[0][1], corners[0][0], corners[0][1]};
  double twice_area = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto& [x, y] = corners[k];
    const auto& [next_x, next_y] = corners[(k + 1) % corners.size()];
    twice_area += x * next_y - next_x * y;
    auto& b = walls.bounds;
    b = {std::min(b.x0, x), std::min(b.y0, y), std::max(b.x1, x), std::max(b.y1, y)};
  }
  walls.area += twice_area / 2;
}

/// Adds the chain that was made of the legs, and the thrombi on them.
void add_chain(WallChain chain, const std::vector<WallLeg>& legs, VesselWalls& walls) {
  walls.chains.push_back(std::move(chain));
  for (const WallLeg& leg : legs) {
    for (const Bump& bump : leg.bumps) {
      walls.bumps.push_back(bump);
      walls.area -= std::numbers::pi * bump.radius * bump.radius / 2;
    }
  }
}

VesselWalls straight_walls(const Description& d, bool open) {
  VesselWalls walls;
  const WallLeg lower{{0, 0}, {d.length, 0}, d.speed.lower, d.lower};
  const WallLeg upper{{d.length, d.height}, {0, d.height}, -d.speed.upper, reversed(d.upper)};
  for (const WallLeg& leg : {lower, upper}) {
    walls.planes.push_back(behind(leg));
    add_chain(open ? chain_of({leg}, false) : periodic_chain(leg), {leg}, walls);
  }
  if (open) {
    walls.inlets = {{{0, 0}, 0, 1, -1, 0, d.height}};
    walls.outlets = {{{d.length, 0}, 0, 1, 1, 0, d.height}};
  } else {
    walls.period_x = d.length;
  }
  walls.narrowest = gap_between(d.lower, d.upper, d.height, walls.period_x);
  measure({{0, 0}, {d.length, 0}, {d.length, d.height}, {0, d.height}}, walls);
  return walls;
}

VesselWalls box_walls(const Description& d, bool periodic) {
  VesselWalls walls;
  const Point a{0, 0}, b{d.length, 0}, c{d.length, d.height}, e{0, d.height};
  measure({a, b, c, e}, walls);
  walls.narrowest = d.height;
  if (periodic) {
    walls.period_x = d.length;
    walls.period_y = d.height;
    return walls;
  }
  const std::vector<WallLeg> legs = {{a, b, d.speed.lower, d.lower},
                                     {b, c, d.speed.right},
                                     {c, e, -d.speed.upper, reversed(d.upper)},
                                     {e, a, -d.speed.left}};
  for (const WallLeg& leg : legs) walls.planes.push_back(behind(leg));
  add_chain(chain_of(legs, true), legs, walls);
  walls.narrowest = std::min(d.length, gap_between(d.lower, d.upper, d.height, 0));
  return walls;
}

/// Moves the thrombi past the trunk's end to the branch's outer wall at the same x.
std::vector<Bump> take_past(double x, std::vector<Bump>& bumps, const Point& along) {
  std::vector<Bump> past;
  while (!bumps.empty() && bumps.back().centre[0] > x) {
    Bump bump = bumps.back();
    bump.centre[1] += (bump.centre[0] - x) * along[1] / along[0];
    past.insert(past.begin(), bump);
    bumps.pop_back();
  }
  return past;
}

/// The outer walls leave the trunk's in two corners at its end. Each inner wall is its outer wall moved by
/// the branch's diameter; the two meet in the apex.
VesselWalls bifurcation_walls(Description d) {
  VesselWalls walls;
  const double c = std::cos(d.half_angle), s = std::sin(d.half_angle);
  const auto [lower, upper] = d.branches;
  const Point down{c, -s}, up{c, s};                    // along the branches
  const Point inward_lower{s, c}, inward_upper{s, -c};  // from the outer wall to the inner one
  const Point lower_corner{d.length, 0}, upper_corner{d.length, d.height};
  const Point lower_outer = lower_corner + lower.length * down;
  const Point upper_outer = upper_corner + upper.length * up;
  const Point lower_inner = lower_outer + lower.diameter * inward_lower;
  const Point upper_inner = upper_outer + upper.diameter * inward_upper;
  // Along the lower inner wall, from the foot of the corner's perpendicular to where it meets the other.
  const double to_apex =
      (((lower.diameter + upper.diameter) * c - d.height) / s + (upper.diameter - lower.diameter) * s / c) /
      2;
  const Point apex = lower_corner + lower.diameter * inward_lower + to_apex * down;

  const std::vector<Bump> on_lower = take_past(d.length, d.lower, down);
  const std::vector<Bump> on_upper = take_past(d.length, d.upper, up);
  const std::vector<std::vector<WallLeg>> chains = {
      {{{0, 0}, lower_corner, 0, d.lower}, {lower_corner, lower_outer, 0, on_lower}},
      {{lower_inner, apex}, {apex, upper_inner}},
      {{upper_outer, upper_corner, 0, reversed(on_upper)},
       {upper_corner, {0, d.height}, 0, reversed(d.upper)}}};
  for (const auto& legs : chains) {
    HalfPlane before = behind(legs[0]);
    before.at = legs[1].from;
    walls.wedges.push_back({before, behind(legs[1])});
    add_chain(chain_of(legs, false), legs, walls);
  }
  walls.inlets = {{{0, 0}, 0, 1, -1, 0, d.height}};
  walls.outlets = {{lower_outer, s, c, c, -s, lower.diameter}, {upper_inner, -s, c, c, s, upper.diameter}};
  walls.narrowest =
      std::min({gap_between(d.lower, d.upper, d.height, 0), gap_between(on_lower, {}, lower.diameter, 0),
                gap_between({}, on_upper, upper.diameter, 0)});
  measure({{0, 0},
           lower_corner,
           lower_outer,
           lower_inner,
           apex,
           upper_inner,
           upper_outer,
           upper_corner,
           {0, d.height}},
          walls);
  return walls;
}

}  // namespace

VesselWalls walls_of(const Case& scene, double unit_length, double unit_velocity) {
  const Description d = describe(scene, unit_length, unit_velocity);
  const bool periodic = scene.vessel.ends == Ends::periodic;
  VesselWalls walls;
  switch (scene.vessel.shape) {
    case Shape::straight:
      walls = straight_walls(d, !periodic);
      break;
    case Shape::bifurcation:
      walls = bifurcation_walls(d);
      break;
    case Shape::box:
      walls = box_walls(d, periodic);
      break;
  }
  walls.length = d.length;
  walls.height = d.height;
  return walls;
}

}  // namespace rouleau::geometry
