#include <stdexcept>

#include "engine/cells/rest_shape.h"
#include "engine/cells/shape.h"
#include "engine/cells/shape_class.h"
#include "engine/cells/tank_treading.h"
#include "engine/observe/cell_measures.h"
#include "engine/observe/first_nodes.h"
#include "engine/observe/membrane_measures.h"
#include "engine/simulation/refinement.h"

// In place of all code of cells that the rest of the engine calls: with these the linker leaves all of it
// out.

namespace rouleau {

namespace {

[[noreturn]] void no_cells() {
  throw std::logic_error("this program has no cells");
}

}  // namespace

namespace cells {

RestShape rest_shape(const Material&, int, double) {
  no_cells();
}
TankTreading tank_treading(Ring, std::span<const double>, std::span<const double>) {
  no_cells();
}
Shape measure(Ring) {
  no_cells();
}
Nearest nearest(Ring, double, double) {
  no_cells();
}
bool contains(Ring, double, double) {
  no_cells();
}
std::string_view name_of(ShapeClass) {
  no_cells();
}

}  // namespace cells

namespace observe {

CellMeasures measure_cell(const effects::State&, const effects::CellState&) {
  no_cells();
}
MembraneMeasures measure_membrane(const effects::State&, std::size_t) {
  no_cells();
}
FirstNodes first_nodes(const effects::State&, const effects::CellState&) {
  no_cells();
}

}  // namespace observe

effects::State refined(const effects::State&, double) {
  no_cells();
}
void renew_nodes(effects::State&) {
  no_cells();
}

}  // namespace rouleau
