#include <array>

#include "engine/case/cell_envelope.h"
#include "tests/stability/scenes.h"

namespace rouleau::stability {

namespace {

/// One behind the other, past the 8 d0 thrombus.
Report run_row(Form form, int cells) {
  constexpr double gap = 4e-6;
  const double room = gap * (cells - 1);
  Case scene = channel(form);
  scene.vessel.length += room;
  scene.thrombi.push_back({Wall::lower, thrombus_place(form) + room, 3.2e-6});
  for (int k = 0; k < cells; ++k) scene.cells.push_back(cell_at(cell_place(form) + k * gap, 5e-6));
  return watched(scene);
}

/// In two rows of a vessel twice as wide, past a thrombus of 12 d0.
Report run_cluster(Form form, int cells) {
  constexpr double gap = 3.2e-6, diameter = 20e-6;
  const int columns = cells / 2;
  const double room = gap * (columns - 1);
  Case scene = channel(form);
  scene.vessel.length += room;
  scene.vessel.diameter = diameter;
  scene.thrombi.push_back({Wall::lower, thrombus_place(form) + room, 4.8e-6});
  for (int k = 0; k < columns; ++k) {
    for (const double y : {0.25, 0.75}) {
      scene.cells.push_back(cell_at(cell_place(form) + k * gap, y * diameter));
    }
  }
  return watched(scene);
}

/// As near as the checks of a case let them be: 0.05 d0 between the membranes, with no plasma between them.
Report run_nearly_touching(Form form) {
  Case scene = channel(form);
  RedCell cell = cell_at(cell_place(form), 5e-6);
  scene.cells.push_back(cell);
  cell.x += 2 * cell_envelope(cell).radius;
  scene.cells.push_back(cell);
  return watched(scene);
}

/// As near as the checks of a case let it be, beside the 8 d0 thrombus.
Report run_touching_thrombus(Form form) {
  Case scene = past_thrombus(form);
  const Thrombus& thrombus = scene.thrombi[0];
  RedCell& cell = scene.cells[0];
  const std::array foot{thrombus.x, 0.0};
  double far = cell.x, near = thrombus.x;
  while (near - far > 1e-12) {
    cell.x = 0.5 * (near + far);
    const Capsule envelope = cell_envelope(cell);
    const bool apart = axis_distance(envelope, foot) > envelope.radius + thrombus.radius;
    (apart ? far : near) = cell.x;
  }
  cell.x = far;
  return watched(scene);
}

}  // namespace

std::vector<Scene> crowded_scenes() {
  const auto row = [](int cells) { return [cells](Form form) { return run_row(form, cells); }; };
  const auto cluster = [](int cells) { return [cells](Form form) { return run_cluster(form, cells); }; };
  return {{"row_4", "four cells in a row, past the 8 d0 thrombus", row(4)},
          {"row_8", "eight cells in a row, past the 8 d0 thrombus", row(8)},
          {"cluster_4", "four cells in two rows, past a 12 d0 thrombus", cluster(4)},
          {"cluster_8", "eight cells in two rows, past a 12 d0 thrombus", cluster(8)},
          {"nearly_touching", "two membranes nearly touching at the start", run_nearly_touching},
          {"touching_thrombus", "a cell touching the 8 d0 thrombus at the start", run_touching_thrombus}};
}

}  // namespace rouleau::stability
