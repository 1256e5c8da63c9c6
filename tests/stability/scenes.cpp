#include "tests/stability/scenes.h"

#include <stdexcept>

namespace rouleau::stability {

const std::vector<Scene>& scenes() {
  static const std::vector<Scene> all = [] {
    std::vector<Scene> found;
    for (const auto& part : {narrow_scenes(), crowded_scenes(), extreme_scenes(), numerical_scenes()}) {
      found.insert(found.end(), part.begin(), part.end());
    }
    return found;
  }();
  return all;
}

const Scene& scene_named(const std::string& name) {
  for (const Scene& scene : scenes()) {
    if (scene.name == name) return scene;
  }
  throw std::out_of_range("no scene is called " + name);
}

Case channel(Form form) {
  Case scene;
  scene.vessel = {form == Form::full ? 80e-6 : 45e-6, 10e-6};
  scene.duration = form == Form::full ? 8e-3 : 3e-3;
  scene.inflow.profile = Profile::parabolic;
  scene.output = {0, 0, {}};
  return scene;
}

double thrombus_place(Form form) {
  return form == Form::full ? 32e-6 : 20e-6;
}

double cell_place(Form form) {
  return form == Form::full ? 16e-6 : 8e-6;
}

RedCell cell_at(double x, double y) {
  RedCell cell;
  cell.x = x;
  cell.y = y;
  return cell;
}

Case past_thrombus(Form form, double radius) {
  Case scene = channel(form);
  scene.thrombi.push_back({Wall::lower, thrombus_place(form), radius});
  scene.cells.push_back(cell_at(cell_place(form), scene.vessel.diameter / 2));
  return scene;
}

Report watched(const Case& scene, const Simulation::Rearrangement& rearrange) {
  return SceneRun(scene, rearrange).report;
}

}  // namespace rouleau::stability
