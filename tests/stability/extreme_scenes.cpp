#include <cmath>
#include <numbers>

#include "tests/stability/scenes.h"

namespace rouleau::stability {

namespace {

Report run_moduli(Form form, double factor) {
  Case scene = past_thrombus(form);
  scene.cells[0].stretch_modulus *= factor;
  scene.cells[0].bend_modulus *= factor;
  return watched(scene);
}

Report run_viscosity_ratio(Form form, double ratio) {
  Case scene = past_thrombus(form);
  scene.cells[0].viscosity_ratio = ratio;
  return watched(scene);
}

/// By the inflow's speed and the vessel's diameter; the moduli go with the speed, so that the cell deforms
/// as much.
Report run_reynolds(Form form, double number) {
  Case scene = past_thrombus(form);
  const double faster =
      number * scene.plasma.kinematic_viscosity / scene.vessel.diameter / scene.inflow.velocity;
  scene.inflow.velocity *= faster;
  scene.duration /= faster;
  scene.cells[0].stretch_modulus *= faster;
  scene.cells[0].bend_modulus *= faster;
  return watched(scene);
}

Report run_fast_inflow(Form form) {
  constexpr double faster = 10;
  Case scene = past_thrombus(form);
  scene.inflow.velocity *= faster;
  scene.duration /= faster;
  return watched(scene);
}

/// The study's plug instead of the developed flow.
Report run_plug_inlet(Form form) {
  Case scene = past_thrombus(form);
  scene.inflow.profile = Profile::plug;
  return watched(scene);
}

/// mean + amplitude cos(2 pi t / period), by straight pieces.
std::vector<WaveformPoint> wave(double mean, double amplitude, double period, double duration) {
  constexpr int pieces = 50;  // a period
  std::vector<WaveformPoint> points;
  for (int k = 0; k * period / pieces <= duration; ++k) {
    points.push_back({k * period / pieces, mean + amplitude * std::cos(2 * std::numbers::pi * k / pieces)});
  }
  return points;
}

Report run_pulsating_inflow(Form form) {
  Case scene = past_thrombus(form);
  scene.inflow.waveform = wave(1, 0.9, 0.5e-3, scene.duration);
  return watched(scene);
}

/// From the foot of the thrombus to and fro.
Report run_reversing_inflow(Form form) {
  Case scene = past_thrombus(form);
  scene.cells[0].x = scene.thrombi[0].x - 7e-6;
  scene.inflow.waveform = wave(0, 1, 0.5 * scene.duration, scene.duration);
  return watched(scene);
}

/// The same scene at another size: Reynolds and capillary numbers are kept.
Report run_scaled(Form form, double factor) {
  Case scene = past_thrombus(form);
  for (double* length :
       {&scene.vessel.length, &scene.vessel.diameter, &scene.thrombi[0].x, &scene.thrombi[0].radius,
        &scene.cells[0].x, &scene.cells[0].y, &scene.cells[0].diameter, &scene.numerics.spacing}) {
    *length *= factor;
  }
  scene.inflow.velocity /= factor;
  scene.duration *= factor * factor;
  scene.cells[0].stretch_modulus /= factor;
  scene.cells[0].bend_modulus *= factor;
  return watched(scene);
}

}  // namespace

std::vector<Scene> extreme_scenes() {
  const auto with = [](auto run, double value) { return [=](Form form) { return run(form, value); }; };
  return {{"moduli_x100", "both moduli times 100, past the 8 d0 thrombus", with(run_moduli, 100)},
          {"moduli_x001", "both moduli divided by 100, past the 8 d0 thrombus", with(run_moduli, 0.01)},
          {"viscosity_ratio_1", "viscosity ratio 1", with(run_viscosity_ratio, 1)},
          {"viscosity_ratio_5", "viscosity ratio 5", with(run_viscosity_ratio, 5)},
          {"viscosity_ratio_50", "viscosity ratio 50", with(run_viscosity_ratio, 50)},
          {"reynolds_001", "Re = 0.01, past the 8 d0 thrombus", with(run_reynolds, 0.01)},
          {"reynolds_1", "Re = 1", with(run_reynolds, 1)},
          {"reynolds_10", "Re = 10", with(run_reynolds, 10)},
          {"reynolds_100", "Re = 100", with(run_reynolds, 100)},
          {"plug_inlet", "a plug at the inlet, past the 8 d0 thrombus", run_plug_inlet},
          {"inflow_x10", "inflow 10 times faster, the cell as it is", run_fast_inflow},
          {"inflow_pulsating", "inflow pulsating between 0.1 and 1.9", run_pulsating_inflow},
          {"inflow_reversing", "inflow reversing, a cell at the foot of the thrombus", run_reversing_inflow},
          {"scale_small", "all lengths divided by 1000", with(run_scaled, 1e-3)},
          {"scale_large", "all lengths times 1000", with(run_scaled, 1e3)}};
}

}  // namespace rouleau::stability
