#include "tests/stability/scenes.h"

namespace rouleau::stability {

namespace {

// Of the lumen of the channel.
constexpr double closing_radius = 8e-6;

Report run_closed_without_cell(Form form) {
  Case scene = past_thrombus(form, closing_radius);
  scene.cells.clear();
  return watched(scene);
}

Report run_closed_with_cell(Form form) {
  return watched(past_thrombus(form, closing_radius));
}

/// A cell on the axis of a symmetric bifurcation, twice over: it must take the same branch again.
Report run_apex(Form form) {
  const bool full = form == Form::full;
  constexpr double diameter = 20e-6;
  Case scene = channel(form);
  scene.vessel = {full ? 80e-6 : 30e-6, diameter, Shape::bifurcation};
  scene.vessel.branches.fill({full ? 40e-6 : 30e-6, 10e-6});
  scene.cells.push_back(cell_at(scene.vessel.length - 10e-6, diameter / 2));
  scene.duration = full ? 6e-3 : 3.5e-3;
  SceneRun first(scene);
  const SceneRun second(scene);
  first.report.worst["repeat"] = {.value = deviation(first.path, second.path, 0), .bound = 0};
  return first.report;
}

/// Two cells abreast meet two thrombi of 12 d0 face to face, which leave 10.4 um for 15.
Report run_jammed_pair(Form form) {
  constexpr double diameter = 20e-6;
  Case scene = channel(form);
  scene.vessel.diameter = diameter;
  for (const Wall wall : {Wall::lower, Wall::upper}) {
    scene.thrombi.push_back({wall, thrombus_place(form), 4.8e-6});
  }
  for (const double y : {0.25, 0.75}) scene.cells.push_back(cell_at(cell_place(form), y * diameter));
  return watched(scene);
}

}  // namespace

std::vector<Scene> narrow_scenes() {
  return {{"closed_80", "a thrombus closing 80 % of the lumen", run_closed_without_cell},
          {"closed_80_cell", "a cell and a thrombus closing 80 % of the lumen", run_closed_with_cell},
          {"apex", "a cell meeting the apex of a bifurcation dead centre, twice", run_apex},
          {"jammed_pair", "two cells at the symmetric pair of 12 d0 thrombi", run_jammed_pair}};
}

}  // namespace rouleau::stability
