#include "engine/case/scene_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "engine/case/cell_envelope.h"
#include "engine/case/wording.h"

namespace rouleau {
namespace {

/// Lengths are read from decimal text: a scene that fits exactly must not fail by the last bit.
constexpr double rounding = 1e-9;

class SceneChecks {
 public:
  SceneChecks(const Case& scene, Faults& faults) : scene_(scene), faults_(faults) {
    for (std::size_t k = 0; k < scene.thrombi.size(); ++k) {
      if (faults.clean(pointer_to("/thrombi", k))) thrombi_.push_back(k);
    }
    for (std::size_t k = 0; k < scene.cells.size(); ++k) {
      if (!faults.clean(pointer_to("/cells", k))) continue;
      cells_.push_back(k);
      envelopes_.push_back(cell_envelope(scene.cells[k]));
    }
  }

  void resolution() {
    const double spacing = scene_.numerics.spacing;
    const double least = std::min(scene_.vessel.diameter, scene_.vessel.length) / spacing;
    if (least < least_particles_across * (1 - rounding)) {
      faults_.add("/numerics/spacing", meters(spacing) + " puts " + rounded(least, "particles") +
                                           " across the vessel (" + meters(scene_.vessel.length) + " by " +
                                           meters(scene_.vessel.diameter) + "); at least " +
                                           in_words(least_particles_across) + " are needed");
    }
    const double particles = scene_.vessel.length * scene_.vessel.diameter / (spacing * spacing);
    if (particles > most_particles) {
      faults_.add("/numerics/spacing", meters(spacing) + " fills the vessel with " +
                                           rounded(particles, "particles") + "; at most " +
                                           in_words(most_particles) + " are allowed");
    }
  }

  void each_thrombus() {
    const double straight = scene_.numerics.kernel_radius * scene_.numerics.spacing;
    for (const std::size_t k : thrombi_) {
      const Thrombus& thrombus = scene_.thrombi[k];
      const std::string place = pointer_to("/thrombi", k);
      const double from = thrombus.x - thrombus.radius;
      const double to = thrombus.x + thrombus.radius;
      if (from < straight - tolerance() || to > scene_.vessel.length - straight + tolerance()) {
        faults_.add(place, "the thrombus reaches from x = " + meters(from) + " to " + meters(to) +
                               "; it must lie between " + meters(straight) + " and " +
                               meters(scene_.vessel.length - straight) +
                               ", one kernel radius of straight wall off the ends");
      }
      if (thrombus.radius < scene_.numerics.spacing - tolerance()) {
        faults_.add(pointer_to(place, "radius"), "found " + meters(thrombus.radius) +
                                                     "; at least one spacing is needed, " +
                                                     meters(scene_.numerics.spacing));
      }
      const double gap = scene_.vessel.diameter - thrombus.radius;
      if (closes(gap)) {
        faults_.add(place, "the thrombus closes the vessel: it leaves " + meters(gap) + needed_gap());
      }
    }
  }

  void pairs_of_thrombi() {
    for (std::size_t i = 0; i < thrombi_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const Thrombus& one = scene_.thrombi[thrombi_[i]];
        const Thrombus& other = scene_.thrombi[thrombi_[j]];
        const double across = one.wall == other.wall ? 0 : scene_.vessel.diameter;
        const double gap = std::hypot(one.x - other.x, across) - one.radius - other.radius;
        const std::string place = pointer_to("/thrombi", thrombi_[i]);
        const std::string pair = "thrombus " + std::to_string(thrombi_[j]);
        if (one.wall == other.wall && gap < -tolerance()) {
          faults_.add(place, "overlaps " + pair + " on the same wall by " + meters(-gap));
        }
        if (one.wall != other.wall && closes(gap)) {
          faults_.add(place, "closes the vessel together with " + pair + ": they leave " +
                                 meters(std::max(gap, 0.0)) + needed_gap());
        }
      }
    }
  }

  void each_cell() {
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const std::string place = pointer_to("/cells", cells_[i]);
      inside_vessel(envelopes_[i], place);
      outside_thrombi(envelopes_[i], place);
      const RedCell& cell = scene_.cells[cells_[i]];
      const double thickness = cell.fill * cell.diameter / 2;
      const double needed = least_cell_thickness * scene_.numerics.spacing;
      if (thickness < needed - tolerance()) {
        faults_.add(place, "the cell is " + meters(thickness) + " thick in the mean; at least " +
                               in_words(least_cell_thickness) + " spacings are needed, " + meters(needed));
      }
    }
  }

  void pairs_of_cells() {
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const double gap =
            axis_distance(envelopes_[i], envelopes_[j]) - envelopes_[i].radius - envelopes_[j].radius;
        if (gap < -tolerance()) {
          faults_.add(pointer_to("/cells", cells_[i]),
                      "overlaps cell " + std::to_string(cells_[j]) + " by " + meters(-gap) + as_estimated());
        }
      }
    }
  }

 private:
  static std::string meters(double length) { return rounded(length, "m"); }

  static std::string as_estimated() { return ", taking the cell in its rest shape"; }

  std::string needed_gap() const {
    return " open; more than " + in_words(least_gap) + " spacings are needed, " +
           meters(least_gap * scene_.numerics.spacing);
  }

  double tolerance() const { return rounding * scene_.vessel.length; }

  bool closes(double gap) const { return gap <= least_gap * scene_.numerics.spacing + tolerance(); }

  void inside_vessel(const Capsule& cell, const std::string& place) {
    const auto [left, right] = std::minmax(cell.from[0], cell.to[0]);
    const auto [bottom, top] = std::minmax(cell.from[1], cell.to[1]);
    const auto beyond = [&](double by, const std::string& what) {
      if (by > tolerance()) {
        faults_.add(place, "the cell reaches " + meters(by) + " beyond the " + what + as_estimated());
      }
    };
    beyond(cell.radius - bottom, "lower wall");
    beyond(top + cell.radius - scene_.vessel.diameter, "upper wall");
    beyond(cell.radius - left, "inlet");
    beyond(right + cell.radius - scene_.vessel.length, "outlet");
  }

  void outside_thrombi(const Capsule& cell, const std::string& place) {
    for (const std::size_t k : thrombi_) {
      const Thrombus& thrombus = scene_.thrombi[k];
      const double y = thrombus.wall == Wall::lower ? 0 : scene_.vessel.diameter;
      const double gap = axis_distance(cell, std::array{thrombus.x, y}) - cell.radius - thrombus.radius;
      if (gap < -tolerance()) {
        faults_.add(place, "the cell reaches " + meters(-gap) + " into thrombus " + std::to_string(k) +
                               as_estimated());
      }
    }
  }

  const Case& scene_;
  Faults& faults_;
  std::vector<std::size_t> thrombi_;  ///< those without a fault of their own
  std::vector<std::size_t> cells_;
  std::vector<Capsule> envelopes_;  ///< of `cells_`
};

void check_amount_of_output(const Case& scene, Faults& faults) {
  const auto check = [&](const char* pointer, double interval, double most) {
    if (interval > 0 && scene.duration / interval > most) {
      faults.add(pointer, "found " + rounded(interval, "s") + ", which makes " +
                              rounded(scene.duration / interval, "entries") +
                              " in the whole duration; at most " + in_words(most) + " are allowed");
    }
  };
  check("/output/series_interval", scene.output.series_interval, most_series_rows);
  check("/output/frame_interval", scene.output.frame_interval, most_frames);
}

}  // namespace

void check_scene(const Case& scene, Faults& faults) {
  const bool output_known = faults.clean("/output") && faults.clean("/duration");
  if (faults.clean("/vessel") && faults.clean("/numerics")) {
    SceneChecks checks(scene, faults);
    checks.resolution();
    checks.each_thrombus();
    checks.pairs_of_thrombi();
    checks.each_cell();
    checks.pairs_of_cells();
  }
  if (output_known) check_amount_of_output(scene, faults);
}

}  // namespace rouleau
