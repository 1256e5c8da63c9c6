#include "engine/case/content_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "engine/case/cell_envelope.h"
#include "engine/case/scene_checks.h"
#include "engine/case/wording.h"

namespace rouleau {
namespace {

using Point = std::array<double, 2>;

/// Where a thrombus sits: on one side of the vessel, and how far its centre is from that side's ends.
struct Seat {
  std::size_t side = 0;
  Point centre{};
  double from_left = 0;  ///< along the side, from its end nearer to the inlet
  double length = 0;     ///< of the side
};

double distance(const Point& one, const Point& other) {
  return std::hypot(one[0] - other[0], one[1] - other[1]);
}

Seat seat_of(const Thrombus& thrombus, const VesselOutline& outline) {
  const std::vector<std::size_t>& wall = thrombus.wall == Wall::lower ? outline.lower : outline.upper;
  for (const std::size_t k : wall) {
    Point left = outline.sides[k].from, right = outline.sides[k].to;
    if (left[0] > right[0]) std::swap(left, right);
    if (thrombus.x > right[0] && k != wall.back()) continue;
    const double t = (thrombus.x - left[0]) / (right[0] - left[0]);
    const double length = distance(left, right);
    return {k, {thrombus.x, left[1] + t * (right[1] - left[1])}, t * length, length};
  }
  return {};
}

class ContentChecks {
 public:
  ContentChecks(const Case& scene, const VesselOutline& outline, Faults& faults)
      : scene_(scene), outline_(outline), faults_(faults) {
    for (std::size_t k = 0; k < scene.thrombi.size(); ++k) {
      if (!faults.clean(pointer_to("/thrombi", k))) continue;
      thrombi_.push_back(k);
      seats_.push_back(seat_of(scene.thrombi[k], outline));
    }
    for (std::size_t k = 0; k < scene.cells.size(); ++k) {
      if (!faults.clean(pointer_to("/cells", k))) continue;
      cells_.push_back(k);
      envelopes_.push_back(cell_envelope(scene.cells[k]));
    }
  }

  void each_thrombus() {
    for (std::size_t i = 0; i < thrombi_.size(); ++i) {
      const Thrombus& thrombus = scene_.thrombi[thrombi_[i]];
      const std::string place = pointer_to("/thrombi", thrombi_[i]);
      on_straight_wall(thrombus, seats_[i], place);
      if (thrombus.radius < scene_.numerics.spacing - tolerance()) {
        faults_.add(pointer_to(place, "radius"), "found " + meters(thrombus.radius) +
                                                     "; at least one spacing is needed, " +
                                                     meters(scene_.numerics.spacing));
      }
      const double gap = to_opposite(thrombus, seats_[i]) - thrombus.radius;
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
        const double gap = distance(seats_[i].centre, seats_[j].centre) - one.radius - other.radius;
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
      const double needed = least_cell_thickness * spacing_that_divides();
      if (thickness < needed - tolerance()) {
        faults_.add(place, "the cell is " + meters(thickness) + " thick in the mean; at least " +
                               in_words(least_cell_thickness) + " spacings are needed, " + meters(needed));
      }
    }
  }

  void pairs_of_cells() {
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const std::string place = pointer_to("/cells", cells_[i]);
      for (std::size_t j = 0; j < i; ++j) {
        const double gap =
            least_distance(envelopes_[i],
                           [&](const Capsule& image) { return axis_distance(image, envelopes_[j]); }) -
            envelopes_[i].radius - envelopes_[j].radius;
        if (gap < -tolerance()) {
          faults_.add(place,
                      "overlaps cell " + std::to_string(cells_[j]) + " by " + meters(-gap) + as_estimated());
        }
      }
      apart_from_itself(envelopes_[i], place);
    }
  }

 private:
  static std::string meters(double length) { return rounded(length, "m"); }

  static std::string as_estimated() { return ", taking the cell in the shape it starts with"; }

  std::string needed_gap() const {
    return " open; more than " + in_words(least_gap) + " spacings are needed, " +
           meters(least_gap * scene_.numerics.spacing);
  }

  /// The height of the vessel: what the scene is computed with.
  double spacing_that_divides() const {
    return scene_.vessel.diameter / std::round(scene_.vessel.diameter / scene_.numerics.spacing);
  }

  double tolerance() const { return rounding * scene_.vessel.length; }

  void on_straight_wall(const Thrombus& thrombus, const Seat& seat, const std::string& place) {
    const double straight = scene_.numerics.kernel_radius * scene_.numerics.spacing;
    const double from = seat.from_left - thrombus.radius;
    const double to = seat.from_left + thrombus.radius;
    if (from >= straight - tolerance() && to <= seat.length - straight + tolerance()) return;
    faults_.add(place, "the thrombus reaches from " + meters(from) + " to " + meters(to) + " along the " +
                           outline_.sides[seat.side].name + "; it must lie between " + meters(straight) +
                           " and " + meters(seat.length - straight) +
                           ", one kernel radius of straight wall off its ends");
  }

  /// From the centre to the nearest wall that faces the thrombus.
  double to_opposite(const Thrombus& thrombus, const Seat& seat) const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto* sides :
         {thrombus.wall == Wall::lower ? &outline_.upper : &outline_.lower, &outline_.inner}) {
      for (const std::size_t k : *sides) {
        const VesselSide& side = outline_.sides[k];
        least = std::min(least, axis_distance(Capsule{side.from, side.to}, seat.centre));
      }
    }
    return least;
  }

  bool closes(double gap) const { return gap <= least_gap * scene_.numerics.spacing + tolerance(); }

  /// By how much what repeats itself is displaced, the nearest places included; {0, 0} first.
  std::vector<Point> image_offsets() const {
    std::vector<Point> offsets = {{0, 0}};
    if (scene_.vessel.ends != Ends::periodic) return offsets;
    const double length = scene_.vessel.length, height = scene_.vessel.diameter;
    for (const double a : {-length, 0.0, length}) {
      for (const double b : {-height, 0.0, height}) {
        const bool repeats = b == 0 || scene_.vessel.shape == Shape::box;
        if (repeats && (a != 0 || b != 0)) offsets.push_back({a, b});
      }
    }
    return offsets;
  }

  static Capsule displaced(const Capsule& cell, const Point& by) {
    return {
        {cell.from[0] + by[0], cell.from[1] + by[1]}, {cell.to[0] + by[0], cell.to[1] + by[1]}, cell.radius};
  }

  /// Of the cell's images.
  template <class Distance>
  double least_distance(const Capsule& cell, const Distance& distance) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Point& by : image_offsets()) least = std::min(least, distance(displaced(cell, by)));
    return least;
  }

  void apart_from_itself(const Capsule& cell, const std::string& place) {
    for (const Point& by : image_offsets()) {
      const double gap = axis_distance(cell, displaced(cell, by)) - 2 * cell.radius;
      if ((by[0] == 0 && by[1] == 0) || gap >= -tolerance()) continue;
      faults_.add(place, "overlaps its own image across the seam by " + meters(-gap) + as_estimated());
      return;
    }
  }

  /// Whether fluid goes on behind the side: the ends of a periodic vessel, all sides of a periodic box.
  bool is_seam(std::size_t side) const {
    if (scene_.vessel.ends != Ends::periodic) return false;
    return scene_.vessel.shape == Shape::box ||
           (side != outline_.lower.front() && side != outline_.upper.front());
  }

  void inside_vessel(const Capsule& cell, const std::string& place) {
    bool fits = true;
    for (std::size_t k = 0; k < outline_.sides.size(); ++k) {
      if (is_seam(k)) continue;
      const VesselSide& side = outline_.sides[k];
      const double clear = axis_distance(cell, Capsule{side.from, side.to});
      // An axis that passes through the side reaches as far beyond it as the end that lies outside.
      const double reached =
          clear > 0 ? clear : std::min({0.0, height_over(side, cell.from), height_over(side, cell.to)});
      if (cell.radius - reached > tolerance()) {
        fits = false;
        faults_.add(place, "the cell reaches " + meters(cell.radius - reached) + " beyond the " + side.name +
                               as_estimated());
      }
    }
    const Point centre = {(cell.from[0] + cell.to[0]) / 2, (cell.from[1] + cell.to[1]) / 2};
    if (fits && !outline_.contains(centre)) {
      faults_.add(place, "the cell lies outside the vessel" + as_estimated());
    }
  }

  /// Distance of a point from a side's line, positive on the fluid's side.
  static double height_over(const VesselSide& side, const Point& point) {
    const double x = side.to[0] - side.from[0], y = side.to[1] - side.from[1];
    return (x * (point[1] - side.from[1]) - y * (point[0] - side.from[0])) / std::hypot(x, y);
  }

  void outside_thrombi(const Capsule& cell, const std::string& place) {
    for (std::size_t i = 0; i < thrombi_.size(); ++i) {
      const Thrombus& thrombus = scene_.thrombi[thrombi_[i]];
      const double gap =
          least_distance(cell, [&](const Capsule& image) { return axis_distance(image, seats_[i].centre); }) -
          cell.radius - thrombus.radius;
      if (gap < -tolerance()) {
        faults_.add(place, "the cell reaches " + meters(-gap) + " into thrombus " +
                               std::to_string(thrombi_[i]) + as_estimated());
      }
    }
  }

  const Case& scene_;
  const VesselOutline& outline_;
  Faults& faults_;
  std::vector<std::size_t> thrombi_;  ///< those without a fault of their own
  std::vector<Seat> seats_;           ///< of `thrombi_`
  std::vector<std::size_t> cells_;
  std::vector<Capsule> envelopes_;  ///< of `cells_`
};

}  // namespace

void check_contents(const Case& scene, const VesselOutline& outline, Faults& faults) {
  ContentChecks checks(scene, outline, faults);
  checks.each_thrombus();
  checks.pairs_of_thrombi();
  checks.each_cell();
  checks.pairs_of_cells();
}

}  // namespace rouleau
