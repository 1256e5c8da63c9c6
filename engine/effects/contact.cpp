#include "engine/effects/contact.h"

#include <algorithm>
#include <cmath>

#include "engine/cells/contact.h"
#include "engine/cells/ring_image.h"

namespace rouleau::effects {

namespace {

// In spacings: how near a wall must come; how many links along the same membrane
// count as its own neighbourhood.
constexpr double wall_range = 0.5;
constexpr int own_neighbourhood = 6;
// In spacings: where nothing is this much farther off, nothing can come in range until a node has moved half
// of it.
constexpr double clearance = 1;
// Acceleration of a node at 0.38 of the range, in nu U / d0^2: ten times what viscous traction can bring up.
constexpr double strength = 10;

class Contacts : public CellEffect {
 public:
  /// Not while the membranes have moved too little since nothing was near for anything to be in range.
  bool awake(const State& state) override {
    return has_membranes(state) && !(still_clear(state) || look_around(state));
  }

  void apply(State& state) override {
    find_boxes(state);
    bool touches = false;
    for (std::size_t c = 0; c < state.cells.size(); ++c) {
      find_walls(state, c, wall_range * state.spacing);
      touches |= push(state, c, wall_range);
      find_membranes(state, c, membrane_contact_range * state.spacing);
      touches |= push(state, c, membrane_contact_range);
    }
    if (touches) ++state.counters.contact_steps;
  }

 private:
  bool still_clear(const State& state) const {
    const auto nodes = static_cast<std::size_t>(state.particles.membrane_end());
    if (clear_x_.size() != nodes) return false;
    const double most = 0.5 * clearance * state.spacing;
    for (std::size_t i = 0; i < nodes; ++i) {
      const double dx = state.particles.x[i] - clear_x_[i], dy = state.particles.y[i] - clear_y_[i];
      if (dx * dx + dy * dy > most * most) return false;
    }
    return true;
  }

  /// Whether nothing is near; then notes where the nodes are.
  bool look_around(const State& state) {
    find_boxes(state);
    clear_x_.clear();
    clear_y_.clear();
    for (std::size_t c = 0; c < state.cells.size() && contacts_.empty(); ++c) {
      find_walls(state, c, (wall_range + clearance) * state.spacing);
      find_membranes(state, c, (membrane_contact_range + clearance) * state.spacing);
    }
    const bool clear = contacts_.empty();
    contacts_.clear();
    if (!clear) return false;
    const auto& particles = state.particles;
    clear_x_.assign(particles.x.begin(), particles.x.begin() + particles.membrane_end());
    clear_y_.assign(particles.y.begin(), particles.y.begin() + particles.membrane_end());
    return true;
  }

  void find_boxes(const State& state) {
    boxes_.clear();
    for (const CellState& cell : state.cells) boxes_.emplace_back(state.ring(cell));
  }

  void find_walls(const State& state, std::size_t c, double range) {
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

  void find_membranes(const State& state, std::size_t c, double range) {
    for (std::size_t other = 0; other < state.cells.size(); ++other) {
      cells::append_contacts(boxes_[c], state.cells[c].first_node, boxes_[other],
                             state.cells[other].first_node, range, other == c ? own_neighbourhood : -1,
                             contacts_);
    }
    state.outline.visit_images([&](double dx, double dy) { find_image(state, c, range, dx, dy); });
  }

  /// The contacts of a cell that is displaced by whole periods.
  void find_image(const State& state, std::size_t c, double range, double away_x, double away_y) {
    const cells::RingImage image(boxes_[c].ring(), away_x, away_y);
    for (std::size_t other = 0; other < state.cells.size(); ++other) {
      cells::append_contacts(image.boxes(), state.cells[c].first_node, boxes_[other],
                             state.cells[other].first_node, range, -1, contacts_);
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
  std::vector<double> clear_x_, clear_y_;  ///< [membrane nodes] when nothing was near; empty: something was
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
                         "while no wall and no other membrane is near",
                         {},
                         {.membrane_node = 170}};

}  // namespace rouleau::effects
