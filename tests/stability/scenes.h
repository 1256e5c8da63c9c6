#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/stability/scene_run.h"

namespace rouleau::stability {

/// Brief: seconds, for every test run. Full: the vessel of the study and times in which a cell passes it.
enum class Form { brief, full };

/// A scene that breaks solvers, and what is asked of it beside the bounds of the Watcher.
struct Scene {
  std::string name;
  std::string text;  ///< what it is, for a person
  std::function<Report(Form)> run;
};

/// All of them.
const std::vector<Scene>& scenes();

/// @throws std::out_of_range if there is none of this name
const Scene& scene_named(const std::string& name);

// By what makes them hard, in files of that name.
std::vector<Scene> narrow_scenes();     ///< narrow_scenes.cpp: vessels nearly closed, and cells in throats
std::vector<Scene> crowded_scenes();    ///< crowded_scenes.cpp: many cells, and surfaces that nearly touch
std::vector<Scene> extreme_scenes();    ///< extreme_scenes.cpp: moduli, viscosities, speeds, sizes
std::vector<Scene> numerical_scenes();  ///< numerical_scenes.cpp: step, spacing, starting particles, time

/// The straight vessel of section 2.4, shorter in the brief form, with the time that a cell takes to pass it.
/// Fed with the developed flow: where a plug meets the walls the velocity jumps, and what fits find there
/// would hide everything else. The scene plug_inlet has it.
Case channel(Form form);
/// Where a thrombus and a cell are in it.
double thrombus_place(Form form);
double cell_place(Form form);

/// The channel with a thrombus on its lower wall (section 3.1 has 3.2 um) and the study's cell.
Case past_thrombus(Form form, double radius = 3.2e-6);
/// An upright cell of the study at (x, y).
RedCell cell_at(double x, double y);

/// Runs a case that nothing beside the Watcher's bounds is asked of.
Report watched(const Case& scene, const Simulation::Rearrangement& rearrange = {});

}  // namespace rouleau::stability
