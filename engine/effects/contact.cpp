#include "engine/effects/contact.h"

#include <algorithm>
#include <cmath>

#include "engine/cells/contact.h"
#include "engine/cells/ring_image.h"

namespace rouleau::effects {

namespace {

// In spacings: how near a wall and another membrane must come, and how many links along the same membrane
// count as its own neighbourhood.
constexpr double wall_range = 0.5;
constexpr double membrane_range = 0.75;
constexpr int own_neighbourhood = 6;
// Acceleration of a node at 0.38 of the range, in nu U / d0^2: ten times what viscous traction can bring up.
constexpr double strength = 10;

class Contacts : public Effect {
 public:
  void apply(State& state) override {
    boxes_.clear();
    for (const CellState& cell : state.cells) boxes_.emplace_back(state.ring(cell));
    bool touches = false;
    for (std::size_t c = 0; c < state.cells.size(); ++c) {
      find_walls(state, c);
      touches |= push(state, c, wall_range);
      find_membranes(state, c);
      touches |= push(state, c, membrane_range);
    }
    if (touches) ++state.counters.contact_steps;
  }

 private:
  void find_walls(const State& state, std::size_t c) {
    const double range = wall_range * state.spacing;
    const cells::Box& box = boxes_[c].whole();
    const double reach = std::hypot(box.x1 - box.x0, box.y1 - box.y0) / 2 + range;
    if (state.outline.distance((box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2).value > reach) return;
    const int first = state.cells[c].first_node;
    const cells::Ring ring = boxes_[c].ring();
    for (std::size_t q = 0; q < ring.size(); ++q) {
      const int node = first + static_cast<int>(q);
      state.outline.visit_near(ring.x[q], ring.y[q], range, [&](const geometry::WallDistance& wall) {
        contacts_.push_back(
            {.link = {node, node}, .nx = -wall.nx, .ny = -wall.ny, .gap = wall.value, .weight = 1});
      });
    }
    for (const geometry::Wedge& wedge : state.outline.wedges()) {
      cells::append_disc_contacts(boxes_[c], first, wedge.before.at, 0, range, contacts_);
    }
    for (const geometry::Bump& bump : state.outline.bumps()) {
      const double away = state.periods_x((box.x0 + box.x1) / 2 - bump.centre[0]);
      cells::append_disc_contacts(boxes_[c], first, {bump.centre[0] + away, bump.centre[1]}, bump.radius,
                                  range, contacts_);
    }
  }

  void find_membranes(const State& state, std::size_t c) {
    for (std::size_t other = 0; other < state.cells.size(); ++other) {
      cells::append_contacts(boxes_[c], state.cells[c].first_node, boxes_[other],
                             state.cells[other].first_node, membrane_range * state.spacing,
                             other == c ? own_neighbourhood : -1, contacts_);
    }
    state.outline.visit_images([&](double dx, double dy) { find_image(state, c, dx, dy); });
  }

  /// The contacts of a cell that is displaced by whole periods.
  void find_image(const State& state, std::size_t c, double away_x, double away_y) {
    const cells::RingImage image(boxes_[c].ring(), away_x, away_y);
    for (std::size_t other = 0; other < state.cells.size(); ++other) {
      cells::append_contacts(image.boxes(), state.cells[c].first_node, boxes_[other],
                             state.cells[other].first_node, membrane_range * state.spacing, -1, contacts_);
    }
  }

  /// Whether there was anything to push.
  bool push(State& state, std::size_t c, double range) {
    if (contacts_.empty()) return false;
    const double force = strength * state.viscosity * state.cells[c].material.rest_length / state.spacing;
    const cells::ContactLaw law{force, range * state.spacing};
    cells::add_contact_forces(contacts_, law, state.load.fx, state.load.fy);
    cells::append_contact_stiffness(contacts_, law, state.load.stiffness);
    contacts_.clear();
    return true;
  }

  std::vector<cells::LinkBoxes> boxes_;
  std::vector<cells::Contact> contacts_;
};

}  // namespace

const EffectKind contact{"contact",
                         Stage::forces,
                         true,
                         [](const Case& scene) {
                           return of_accurate_scheme(
                               scene, needs_cells(scene, "a cell can come near walls and membranes"));
                         },
                         [](State&) -> std::unique_ptr<Effect> { return std::make_unique<Contacts>(); },
                         has_membranes};

}  // namespace rouleau::effects
