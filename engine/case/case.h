#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rouleau {

/// A scene as a person describes it: SI units, angles in degrees, x along the vessel from its inlet and
/// y across it from the lower wall. Every member holds its default, so `Case{}` with a vessel and a
/// duration is complete. Read from JSON by `read_case` (case_json.h), which also checks it.

/// A straight vessel, open at both ends.
struct Vessel {
  double length = 0;    ///< m
  double diameter = 0;  ///< m
};

struct Plasma {
  double density = 1000;              ///< kg/m3
  double kinematic_viscosity = 1e-6;  ///< m2/s
};

enum class Profile { plug, parabolic };

struct Inflow {
  double velocity = 0.005;          ///< mean over the inlet, m/s
  Profile profile = Profile::plug;  ///< the study feeds a plug
};

struct Outflow {
  double pressure = 0;  ///< Pa, at the outlet plane
};

enum class Wall { lower, upper };

/// A semicircle on a wall.
struct Thrombus {
  Wall wall = Wall::lower;
  double x = 0;       ///< of its centre, m
  double radius = 0;  ///< m
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
};

enum class Switch { automatic, on, off };

enum class Preset { draft, standard, fine };

/// How the scene is computed. After `read_case` every knob is filled in, from the preset where the case
/// does not name it.
struct Numerics {
  Preset preset = Preset::standard;
  double spacing = 4e-7;             ///< d0, m
  std::optional<double> time_step;   ///< s; none: the plan chooses
  double kernel_radius = 3.1;        ///< in d0
  double pressure_tolerance = 1e-2;  ///< relative residual at which the pressure solver stops
  int threads = 1;
};

struct OutputSettings {
  double series_interval = 2e-5;  ///< s; 0: no series
  double frame_interval = 1e-4;   ///< s; 0: no frames
};

struct Case {
  std::string name;
  Vessel vessel;
  Plasma plasma;
  Inflow inflow;
  Outflow outflow;
  std::vector<Thrombus> thrombi;
  std::vector<RedCell> cells;
  std::map<std::string, Switch> effects;  ///< by effect name; absent: automatic
  Numerics numerics;
  double duration = 0;  ///< s of simulated time
  OutputSettings output;
};

}  // namespace rouleau
