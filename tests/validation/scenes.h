#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "engine/case/case.h"

namespace rouleau::validation {

/// What a scene is run at.
struct Resolution {
  int across = 25;  ///< particle spacings over the height of the vessel; in shear over the cell's diameter
  Preset preset = Preset::standard;
};

/// How far a run is from its reference.
struct Measurement {
  double simulated_time = 0;  ///< s
  long steps = 0;
  int particles = 0;                                   ///< at the end, solved for
  std::vector<std::pair<std::string, double>> errors;  ///< name, and size relative to the reference
  std::vector<std::pair<std::string, double>> values;  ///< what they are of, where that is worth knowing

  /// @throws std::out_of_range
  double error(const std::string& name) const;
};

/// A flow whose answer is known.
struct Scene {
  std::string name;
  std::string reference;  ///< the entry of references.json that says what it is compared with
  std::function<Measurement(const Resolution&)> run;
};

/// All of them.
const std::vector<Scene>& scenes();

/// @throws std::out_of_range if there is none of this name
const Scene& scene_named(const std::string& name);

/// The numbers of a preset, for a vessel of this height. The published scheme's step goes with the square of
/// the spacing, as its viscous sub-steps do.
Numerics numerics_at(const Resolution& resolution, double height);

// Couette and Poiseuille flow from rest, steady Poiseuille flow, oscillating flow: channel_scenes.cpp.
Measurement run_couette_start(const Resolution& resolution);
Measurement run_poiseuille_start(const Resolution& resolution);
Measurement run_poiseuille(const Resolution& resolution, Profile profile);
Measurement run_long_channel(const Resolution& resolution);
Measurement run_womersley(const Resolution& resolution);

// Closed and periodic boxes: box_scenes.cpp.
Measurement run_taylor_green(const Resolution& resolution);
Measurement run_hydrostatic(const Resolution& resolution);
Measurement run_cavity(const Resolution& resolution);

// Slow flow over bumps and into branches: stokes_scenes.cpp.
/// @param bump  its entry among the references
Measurement run_bump(const Resolution& resolution, const std::string& bump, bool on_both_walls);
Measurement run_bifurcation(const Resolution& resolution);
Measurement run_unequal_bifurcation(const Resolution& resolution);

// Cells in shear flow: shear_scenes.cpp.
/// @param ring  its entry among the references
Measurement run_ring(const Resolution& resolution, const std::string& ring);
/// @param vesicle  its entry among the references
Measurement run_vesicle(const Resolution& resolution, const std::string& vesicle, bool inextensible);
/// The viscosity ratio from which on a vesicle tumbles.
Measurement run_tumbling(const Resolution& resolution);

// Cells that attract one another: aggregation_scenes.cpp.
Measurement run_adhering_vesicles(const Resolution& resolution);
Measurement run_rouleau(const Resolution& resolution);

// A cell in the study's vessel, and one that nothing moves: cell_scenes.cpp.
Measurement run_cell_in_channel(const Resolution& resolution);
Measurement run_held_past_thrombus(const Resolution& resolution);
Measurement run_resting_cell(const Resolution& resolution);

}  // namespace rouleau::validation
