#include "engine/effects/bending.h"

#include "engine/cells/bending.h"
#include "engine/effects/elastic_energy.h"

namespace rouleau::effects {

const EffectKind bending{
    "bending",
    Stage::forces,
    true,
    [](const Case& scene) {
      return of_accurate_scheme(scene, needs_cells(scene, "a cell's membrane resists bending"));
    },
    [](State&) -> std::unique_ptr<Effect> {
      return std::make_unique<ElasticEnergy>(cells::add_bending_forces, cells::append_bending_stiffness);
    },
    CellEffect::rests,
    {},
    {.membrane_node = 110}};

}  // namespace rouleau::effects
