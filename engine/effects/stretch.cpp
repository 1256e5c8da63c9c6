#include "engine/effects/stretch.h"

#include "engine/cells/stretch.h"
#include "engine/effects/elastic_energy.h"
#include "engine/effects/inextensible.h"

namespace rouleau::effects {

const EffectKind stretch{"stretch",
                         Stage::forces,
                         true,
                         [](const Case& scene) {
                           if (is_inextensible(scene))
                             return Need{false, "the membranes are inextensible", "/effects/inextensible"};
                           return needs_cells(scene, "a cell's membrane resists being stretched");
                         },
                         [](State&) -> std::unique_ptr<Effect> {
                           return std::make_unique<ElasticEnergy>(cells::add_stretch_forces,
                                                                  cells::append_stretch_stiffness);
                         },
                         CellEffect::rests,
                         {},
                         {.membrane_node = 30}};

}  // namespace rouleau::effects
