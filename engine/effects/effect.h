#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/case/case.h"
#include "engine/effects/cost.h"
#include "engine/effects/state.h"

namespace rouleau::effects {

/// The stages of a step, in order. Particles move first, so that at the end of a step position, velocity and
/// pressure belong to the same instant.
enum class Stage { motion, boundaries, operators, forces, viscosity, pressure, checks, observers };

std::string_view name_of(Stage stage);

/// One job in the step.
class Effect {
 public:
  virtual ~Effect() = default;
  /// Whether the scene needs it now, asked before each turn: where it sleeps it is not applied, and the
  /// answer is the same. It may keep for `apply` what it found out.
  virtual bool awake(const State&) { return true; }
  virtual void apply(State& state) = 0;
};

/// Whether any cell is left in the vessel.
bool has_membranes(const State& state);

/// The usual effect of cells: it sleeps once all of them have left.
class CellEffect : public Effect {
 public:
  static constexpr std::string_view rests = "once every cell has left the vessel";
  bool awake(const State& state) override { return has_membranes(state); }
};

/// Whether a scene calls for an effect, and what in the case decided that.
struct Need {
  bool called_for = false;
  std::string reason;
  std::string pointer;
  bool on_request = false;  ///< not called for, but the scene can carry it
};

/// A number that a case may give an effect: "effects": {"aggregation": {"well_depth": 1e-7}}.
struct Parameter {
  std::string_view name;
  std::string_view unit;         ///< SI; "1" where it has none
  std::string_view description;  ///< one sentence
  double fallback;
  double least, most;  ///< both allowed
};

/// What the catalogue knows of an effect. It stands beside the effect's code.
struct EffectKind {
  std::string_view name;
  Stage stage;
  bool optional;  ///< a case may switch it off (or, where the scene can carry it, on)
  Need (*need)(const Case& scene);
  std::unique_ptr<Effect> (*make)(State& state);
  std::string_view rests = "";  ///< when it sleeps, as a part of a sentence
  std::vector<Parameter> parameters = {};
  Cost cost = {};  ///< each time that it is applied
};

/// Of an effect (or observer) by its name in the scene: what the case gives, else its default. SI.
template <class Kind>
double parameter(const Case& scene, const Kind& kind, std::string_view name) {
  if (const auto wish = scene.effects.find(std::string(kind.name)); wish != scene.effects.end()) {
    const auto& given = wish->second.parameters;
    if (const auto value = given.find(std::string(name)); value != given.end()) return value->second;
  }
  const auto declared = std::find_if(kind.parameters.begin(), kind.parameters.end(),
                                     [&](const Parameter& p) { return p.name == name; });
  return declared->fallback;
}

/// Every effect there is, in the order in which a step runs them.
const std::vector<const EffectKind*>& catalogue();

/// The usual answers of `EffectKind::need`.
Need always(std::string reason);
Need needs_cells(const Case& scene, std::string reason);
/// The same, in a vessel that they can leave.
Need needs_cells_that_leave(const Case& scene, std::string reason);
/// Called for by none: it runs where the case asks for it and the scene can carry it, as `can` says.
Need on_request(Need can, std::string reason);
/// Called for by the published scheme (preset `paper`) alone.
Need of_published_scheme(const Case& scene, std::string reason);
/// `need` in the published scheme, and nowhere else.
Need of_published_scheme(const Case& scene, Need need);
/// `need`, except in the published scheme, which does without.
Need of_accurate_scheme(const Case& scene, Need need);

}  // namespace rouleau::effects
