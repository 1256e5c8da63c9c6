#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rouleau {

/// A scene as a person describes it: SI units, angles in degrees, x along the vessel from its inlet and
/// y across it from the lower wall. Every member holds its default, so `Case{}` with a vessel and a
/// duration is complete. Read from JSON by `read_case` (case_json.h), which also checks it.

enum class Shape {
  straight,     ///< two parallel walls
  bifurcation,  ///< a trunk and two branches
  box,          ///< closed by four walls, or periodic both ways
};

enum class Ends {
  open,      ///< plasma enters and leaves
  periodic,  ///< what leaves at one end enters at the other
  closed,    ///< of a box: four walls
};

/// Of each wall along itself: along x of the lower and upper one, along y of a box's left and right one. m/s
struct WallVelocity {
  double lower = 0, upper = 0;
  double left = 0, right = 0;
};

struct Branch {
  double length = 0;    ///< of its outer wall, m
  double diameter = 0;  ///< m
};

/// What the blood flows through. Of a bifurcation `length` and `diameter` are the trunk's, of a box they are
/// its width and height.
struct Vessel {
  double length = 0;    ///< m
  double diameter = 0;  ///< m
  Shape shape = Shape::straight;
  Ends ends = Ends::open;  ///< a bifurcation's are open
  WallVelocity wall_velocity{};
  std::array<Branch, 2> branches{};  ///< the lower one, the upper one
  double half_angle = 30;            ///< between a branch and the trunk's axis, degrees
};

/// Whether plasma enters and leaves.
inline bool is_open(const Vessel& vessel) {
  return vessel.ends == Ends::open;
}

/// Whether it has walls that may move: with open ends they would leave no developed flow to feed, and a
/// periodic box has none.
inline bool may_move_walls(const Vessel& vessel) {
  return vessel.shape == Shape::box ? vessel.ends == Ends::closed : vessel.ends == Ends::periodic;
}

struct Plasma {
  double density = 1000;              ///< kg/m3
  double kinematic_viscosity = 1e-6;  ///< m2/s
};

enum class Profile { plug, parabolic };

/// A point of the waveform: `factor` times the inflow's velocity at `time`.
struct WaveformPoint {
  double time = 0;  ///< s
  double factor = 1;
};

struct Inflow {
  double velocity = 0.005;              ///< mean over the inlet, m/s
  Profile profile = Profile::plug;      ///< the study feeds a plug
  std::vector<WaveformPoint> waveform;  ///< by time; linear between points, held before the first and after
                                        ///< the last; none: steady
};

struct Outflow {
  std::array<double, 2> pressure{};  ///< Pa, at the outlet plane; of a bifurcation lower and upper
};

enum class InitialFlow {
  automatic,  ///< developed where the vessel is open, else at rest
  rest,
  developed,     ///< the parabola of the free vessel
  taylor_green,  ///< of a periodic box: one pair of vortices each way
};

/// The plasma at the start; cells are at rest.
struct Initial {
  InitialFlow flow = InitialFlow::automatic;
  double velocity = 0;  ///< of the vortices, m/s
};

enum class Wall { lower, upper };

/// A semicircle on a wall.
struct Thrombus {
  Wall wall = Wall::lower;
  double x = 0;       ///< of its centre, m
  double radius = 0;  ///< m
};

enum class CellShape {
  rest,    ///< the force-free shape at its area
  circle,  ///< the circle that it is deflated from: it deflates during the run
};

/// A red cell. Its moduli are per unit depth and do not depend on the particle spacing.
struct RedCell {
  double x = 0;                   ///< of its centre, m
  double y = 0;                   ///< m
  double diameter = 6.36e-6;      ///< of the circle it is deflated from, m
  double fill = 0.5;              ///< its area over that circle's
  double angle = 90;              ///< of the long axis to x, degrees
  double stretch_modulus = 1e-5;  ///< E_s, N/m
  double bend_modulus = 4.8e-18;  ///< B, J
  double viscosity_ratio = 1;     ///< inside over plasma
  CellShape shape = CellShape::rest;
};

/// Whether it gives up some of its area in the course of the run.
inline bool deflates(const RedCell& cell) {
  return cell.shape == CellShape::circle && cell.fill < 1;
}

enum class Switch { automatic, on, off };

/// What a case says of an effect.
struct EffectWish {
  EffectWish() = default;
  EffectWish(Switch wished, std::map<std::string, double> given = {})
      : position(wished), parameters(std::move(given)) {}
  bool operator==(const EffectWish&) const = default;

  Switch position = Switch::automatic;
  std::map<std::string, double> parameters{};  ///< by name, SI; the effect says which it has
};

enum class Preset {
  draft,
  standard,
  fine,
  paper,  ///< the published scheme
};

enum class Viscosity { implicit, substeps };

/// What becomes of a cell that is squeezed thinner than the particles can carry.
enum class Refine {
  automatic,  ///< the run goes on with a finer spacing
  off,        ///< it ends
};

/// How the scene is computed. After `read_case` every knob is filled in, from the preset where the case
/// does not name it.
struct Numerics {
  Preset preset = Preset::standard;
  double spacing = 4e-7;            ///< d0, m
  std::optional<double> time_step;  ///< s; none: the plan chooses
  double kernel_radius = 3.1;       ///< in d0
  Viscosity viscosity = Viscosity::implicit;
  int substeps = 12;                 ///< of a viscous step, where it is explicit (eqs. 16 to 18)
  double pressure_tolerance = 1e-2;  ///< relative residual at which the pressure solver stops
  int threads = 1;
  Refine refine = Refine::automatic;
};

enum class Field { velocity, pressure, wall_shear_stress };

struct OutputSettings {
  double series_interval = 2e-5;                                ///< s; 0: no series
  double frame_interval = 1e-4;                                 ///< s; 0: no frames
  std::vector<Field> fields{Field::velocity, Field::pressure};  ///< what frames carry beside positions
};

/// Velocity and pressure on a line, and the flow through it, at every time of the series.
struct Probe {
  std::string name;
  std::array<double, 2> from{}, to{};  ///< m; the same for a single point
  int points = 1;                      ///< evenly spaced from `from` to `to`, both included
};

struct Case {
  std::string name;
  Vessel vessel;
  Plasma plasma;
  Inflow inflow;
  Outflow outflow;
  std::array<double, 2> body_acceleration{};  ///< m/s2
  Initial initial{};
  std::vector<Thrombus> thrombi;
  std::vector<RedCell> cells;
  std::map<std::string, EffectWish> effects;  ///< by effect name; absent: automatic
  Numerics numerics;
  double duration = 0;  ///< s of simulated time
  OutputSettings output;
  std::vector<Probe> probes;
};

/// Whether particles start on a square lattice, enter in columns, and a plug is fed at the inflow's velocity,
/// as the study has it: in the published scheme with cells.
inline bool starts_as_published(const Case& scene) {
  return scene.numerics.preset == Preset::paper && !scene.cells.empty();
}

/// How the plasma moves at the start, once the scene has decided.
inline InitialFlow initial_flow(const Case& scene) {
  if (scene.initial.flow != InitialFlow::automatic) return scene.initial.flow;
  return is_open(scene.vessel) ? InitialFlow::developed : InitialFlow::rest;
}

}  // namespace rouleau
