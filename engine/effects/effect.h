#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/case/case.h"
#include "engine/effects/state.h"

namespace rouleau::effects {

/// The stages of a step, in order. Particles move first, so that at the end of a step position, velocity and
/// pressure belong to the same instant.
enum class Stage { motion, boundaries, operators, forces, viscosity, pressure, checks };

std::string_view name_of(Stage stage);

/// One job in the step.
class Effect {
 public:
  virtual ~Effect() = default;
  virtual void apply(State& state) = 0;
};

/// Whether a scene calls for an effect, and what in the case decided that.
struct Need {
  bool called_for = false;
  std::string reason;
  std::string pointer;
  bool on_request = false;  ///< not called for, but the scene can carry it
};

/// What the catalogue knows of an effect. It stands beside the effect's code.
struct EffectKind {
  std::string_view name;
  Stage stage;
  bool optional;  ///< a case may switch it off (or, where the scene can carry it, on)
  Need (*need)(const Case& scene);
  std::unique_ptr<Effect> (*make)(State& state);
  bool (*awake)(const State& state) = nullptr;  ///< whether a step needs it; none: each does
};

/// Every effect there is, in the order in which a step runs them.
const std::vector<const EffectKind*>& catalogue();

/// The usual answers of `EffectKind::need`.
Need always(std::string reason);
Need needs_cells(const Case& scene, std::string reason);
/// The same, in a vessel that they can leave.
Need needs_cells_that_leave(const Case& scene, std::string reason);
/// The usual answer of `EffectKind::awake` where `needs_cells` called for it: not once every cell has left.
bool has_membranes(const State& state);
/// Called for by the published scheme (preset `paper`) alone.
Need of_published_scheme(const Case& scene, std::string reason);
/// `need` in the published scheme, and nowhere else.
Need of_published_scheme(const Case& scene, Need need);
/// `need`, except in the published scheme, which does without.
Need of_accurate_scheme(const Case& scene, Need need);

}  // namespace rouleau::effects
