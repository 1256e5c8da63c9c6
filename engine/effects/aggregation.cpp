#include "engine/effects/aggregation.h"

#include <cstdio>
#include <vector>

#include "engine/case/scales.h"
#include "engine/cells/morse.h"
#include "engine/cells/ring_image.h"
#include "engine/effects/contact.h"

namespace rouleau::effects {

namespace {

class Aggregation : public Effect {
 public:
  explicit Aggregation(const State& state) {
    const auto given = [&](std::string_view name) { return parameter(state.scene, aggregation, name); };
    law_ = {given("well_depth") / state.scales.tension(), given("zero_force_distance") / state.scales.length,
            given("scaling_factor") * state.scales.length};
  }

  /// Not while no two cells are within the potential's reach.
  bool awake(const State& state) override {
    find_boxes(state);
    bool near = false;
    for (std::size_t a = 0; a < boxes_.size() && !near; ++a) {
      for (std::size_t b = 0; b < a && !near; ++b) near = reach(boxes_[a].whole(), boxes_[b].whole());
      state.outline.visit_images([&](double dx, double dy) {
        const cells::Box image = boxes_[a].whole().displaced(dx, dy);
        for (std::size_t b = 0; b <= a && !near; ++b) near = reach(image, boxes_[b].whole());
      });
    }
    return near;
  }

  void apply(State& state) override {
    find_boxes(state);
    for (std::size_t c = 0; c < state.cells.size(); ++c) {
      for (std::size_t other = 0; other < state.cells.size(); ++other) {
        if (other != c) attract(state, c, boxes_[c], other);
      }
      state.outline.visit_images([&](double dx, double dy) { attract_image(state, c, dx, dy); });
    }
  }

 private:
  void find_boxes(const State& state) {
    boxes_.clear();
    for (const CellState& cell : state.cells) boxes_.emplace_back(state.ring(cell));
  }

  bool reach(const cells::Box& a, const cells::Box& b) const { return a.distance(b) <= law_.reach(); }

  /// A cell that is displaced by whole periods, towards all of them.
  void attract_image(State& state, std::size_t c, double dx, double dy) {
    const cells::Box there = boxes_[c].whole().displaced(dx, dy);
    for (std::size_t other = 0; other < state.cells.size(); ++other) {
      if (!reach(there, boxes_[other].whole())) continue;
      attract(state, c, cells::RingImage(boxes_[c].ring(), dx, dy).boxes(), other);
    }
  }

  /// The nodes of cell c, which are in `at`, and the links of another one.
  void attract(State& state, std::size_t c, const cells::LinkBoxes& at, std::size_t other) {
    const int first = state.cells[c].first_node;
    contacts_.clear();
    cells::append_adhesion(at, first, boxes_[other], state.cells[other].first_node, law_.reach(), contacts_);
    cells::add_adhesion_forces(contacts_, at.ring(), first, law_, state.load.fx, state.load.fy);
    cells::append_contact_stiffness(contacts_, law_, state.load.stiffness);
  }

  cells::MorseLaw law_;
  std::vector<cells::LinkBoxes> boxes_;
  std::vector<cells::Contact> contacts_;
};

/// Where contact would hold membranes farther apart than they attract one another to.
Need too_coarse(double distance, double spacing) {
  char reason[200];
  std::snprintf(reason, sizeof reason,
                "membranes are in contact within %.2g spacings, %.3g um: they cannot come to a zero-force "
                "distance of %.3g um; the spacing may be at most %.3g um",
                membrane_contact_range, membrane_contact_range * spacing * 1e6, distance * 1e6,
                distance / membrane_contact_range * 1e6);
  return {false, reason, "/effects/aggregation/zero_force_distance"};
}

Need need(const Case& scene) {
  Need can = of_accurate_scheme(scene, needs_cells(scene, "cells attract one another"));
  if (!can.called_for) return can;
  if (scene.cells.size() < 2 && scene.vessel.ends != Ends::periodic)
    return {false, "there is no other cell, nor an image of it, to attract", "/cells"};
  const double distance = parameter(scene, aggregation, "zero_force_distance");
  if (distance < membrane_contact_range * scene.numerics.spacing)
    return too_coarse(distance, scene.numerics.spacing);
  return on_request(can, "cells do not attract one another unless the case says so");
}

}  // namespace

const EffectKind aggregation{
    "aggregation",
    Stage::forces,
    true,
    need,
    [](State& state) -> std::unique_ptr<Effect> { return std::make_unique<Aggregation>(state); },
    "while no two cells are within reach of one another",
    {{"well_depth", "J/m2", "Energy of adhesion of two membranes per area at the zero-force distance.",
      5.2e-8, 1e-12, 1e-3},
     {"zero_force_distance", "m", "Distance at which two membranes neither attract nor repel one another.",
      0.49e-6, 1e-9, 1e-5},
     {"scaling_factor", "1/m", "Inverse of the length over which the attraction falls off.", 3.84e6, 1e5,
      1e9}},
    {.membrane_node = 180}};

}  // namespace rouleau::effects
