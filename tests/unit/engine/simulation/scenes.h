#pragma once

#include "engine/case/case.h"

namespace rouleau {

/// A short, coarse vessel: some 150 particles, 27 us a step.
inline Case coarse_vessel() {
  Case scene;
  scene.vessel = {15e-6, 10e-6};
  scene.numerics.spacing = 1e-6;
  scene.duration = 4e-4;
  scene.output = {4e-5, 1e-4};
  return scene;
}

inline Case coarse_vessel_with_cells(int cells = 1) {
  Case scene = coarse_vessel();
  scene.numerics.refine = Refine::off;  // its cells are hardly more than two spacings thick
  scene.vessel.length = 10e-6 * (cells + 1);
  for (int k = 0; k < cells; ++k) {
    RedCell cell;
    cell.x = 8e-6 + 9e-6 * k;
    cell.y = 5e-6;
    cell.fill = 0.6;
    scene.cells.push_back(cell);
  }
  return scene;
}

/// Two cells side by side in a periodic vessel of 20 um, their centres this far apart on either side of x
/// (m); around 0 the seam is between them.
inline Case pair_around(double x, double apart = 4e-6) {
  Case scene = coarse_vessel_with_cells(2);
  scene.vessel = {20e-6, 10e-6};
  scene.vessel.ends = Ends::periodic;
  scene.cells[0].x = x - apart / 2;
  scene.cells[1].x = x + apart / 2;
  if (scene.cells[0].x < 0) scene.cells[0].x += scene.vessel.length;
  return scene;
}

}  // namespace rouleau
