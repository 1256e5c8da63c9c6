#include "tests/validation/scenes.h"

#include <cmath>
#include <stdexcept>

#include "engine/case/presets.h"

namespace rouleau::validation {

double Measurement::error(const std::string& name) const {
  for (const auto& [known, value] : errors) {
    if (known == name) return value;
  }
  throw std::out_of_range("no error is called " + name);
}

const std::vector<Scene>& scenes() {
  const auto bump = [](const char* name, bool both) {
    return Scene{name, "bumps", [name, both](const Resolution& r) { return run_bump(r, name, both); }};
  };
  const auto poiseuille = [](const char* name, Profile profile) {
    return Scene{name, "poiseuille", [profile](const Resolution& r) { return run_poiseuille(r, profile); }};
  };
  const auto ring = [](const char* name) {
    return Scene{name, "elastic_ring_in_shear", [name](const Resolution& r) { return run_ring(r, name); }};
  };
  const auto vesicle = [](const char* name) {
    return Scene{name, "vesicle_in_shear",
                 [name](const Resolution& r) { return run_vesicle(r, name, false); }};
  };
  const auto held = [](const char* name, const char* reference) {
    return Scene{name, "vesicle_in_shear",
                 [reference](const Resolution& r) { return run_vesicle(r, reference, true); }};
  };
  static const std::vector<Scene> all{{"couette_start", "couette_start", run_couette_start},
                                      {"poiseuille_start", "poiseuille_start", run_poiseuille_start},
                                      poiseuille("poiseuille_plug", Profile::plug),
                                      poiseuille("poiseuille_parabolic", Profile::parabolic),
                                      {"long_channel", "long_channel", run_long_channel},
                                      {"womersley", "womersley", run_womersley},
                                      {"taylor_green", "taylor_green", run_taylor_green},
                                      {"hydrostatic", "hydrostatic", run_hydrostatic},
                                      {"cavity_re100", "cavity_re100", run_cavity},
                                      bump("bump_016", false),
                                      bump("bump_032", false),
                                      bump("bump_048", false),
                                      bump("bump_pair", true),
                                      {"bifurcation", "bifurcation", run_bifurcation},
                                      {"bifurcation_unequal", "bifurcation_unequal", run_unequal_bifurcation},
                                      ring("ring_soft"),
                                      ring("ring_stiff"),
                                      ring("ring_bending"),
                                      vesicle("vesicle_090"),
                                      vesicle("vesicle_080"),
                                      vesicle("vesicle_080_ratio_2"),
                                      vesicle("vesicle_080_ratio_4"),
                                      held("vesicle_090_inextensible", "vesicle_090"),
                                      held("vesicle_080_inextensible", "vesicle_080"),
                                      held("vesicle_080_ratio_4_inextensible", "vesicle_080_ratio_4"),
                                      {"vesicle_tumbling", "vesicle_in_shear", run_tumbling},
                                      {"cell_in_channel", "cell_in_channel", run_cell_in_channel},
                                      {"adhering_vesicles", "adhering_vesicles", run_adhering_vesicles},
                                      {"rouleau", "rouleau", run_rouleau},
                                      {"thrombus_inextensible", "kept_lengths", run_held_past_thrombus},
                                      {"resting_cell", "resting_cell", run_resting_cell}};
  return all;
}

const Scene& scene_named(const std::string& name) {
  for (const Scene& scene : scenes()) {
    if (scene.name == name) return scene;
  }
  throw std::out_of_range("no scene is called " + name);
}

Numerics numerics_at(const Resolution& resolution, double height) {
  Numerics numerics = preset_numerics(resolution.preset);
  const double preset_spacing = numerics.spacing;
  numerics.spacing = height / resolution.across;
  if (numerics.time_step) *numerics.time_step *= std::pow(numerics.spacing / preset_spacing, 2);
  return numerics;
}

}  // namespace rouleau::validation
