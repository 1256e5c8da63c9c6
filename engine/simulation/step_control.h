#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "engine/effects/state.h"

namespace rouleau {

/// What holds a time step where it is.
enum class Limit {
  planned,   ///< the plan's step: given by the case, or a fifth of a spacing for the fastest fluid expected
  flow,      ///< half a spacing for the fastest fluid there is
  viscous,   ///< explicit viscous sub-steps
  elastic,   ///< how far a link of a membrane may stretch
  error,     ///< of the time integration
  rejected,  ///< a step was taken again smaller, and the step grows back
  end,       ///< the duration
};
inline constexpr int limits = 7;

std::string_view name_of(Limit limit);

/// How many steps were taken again for the same cause: "error", or the quantity that broke its bound.
struct Rejection {
  std::string cause;
  long steps = 0;
};

/// What happened to the steps of a run.
struct StepCounts {
  std::array<long, limits> bound{};  ///< steps held back by each limit
  long rejected = 0;
  std::vector<Rejection> rejections;  ///< what for
  double least = 0, most = 0;  ///< steps taken, own units; the last one, cut to the duration, not counted
};

/// Chooses each time step.
class StepControl {
 public:
  /// @param fixed  every step is the planned one: the published scheme's density source grows as its inverse
  ///               square, so that a smaller step cures nothing
  StepControl(double planned, double duration, bool fixed)
      : planned_(planned), duration_(duration), fixed_(fixed) {}

  /// The next step from `state`; sets `limit()`.
  double choose(const effects::State& state);
  Limit limit() const { return limit_; }

  /// Whether the step just made is to be accepted as far as its error goes.
  /// @param change  rms change of velocity along the particles' paths, over the rms velocity (at least 1)
  bool accurate(double dt, double change) const;

  /// From now on the planned step is another one.
  void plan(double planned) { planned_ = planned; }

  void accept(double dt, double change);
  /// After a breach: whether the step may be tried again, smaller.
  /// @param cause  "error", or the quantity that broke its bound
  bool reject(double dt, const std::string& cause);

  const StepCounts& counts() const { return counts_; }

  /// What one step leaves for the next, for a checkpoint.
  template <class Stream>
  friend void visit(Stream& stream, StepControl& control) {
    stream(control.allowed_by_error_, control.allowed_after_rejection_, control.rejections_in_a_row_,
           control.counts_);
  }

 private:
  double planned_;
  double duration_;
  bool fixed_;
  double allowed_by_error_ = 1e300;
  double allowed_after_rejection_ = 1e300;
  Limit limit_ = Limit::planned;
  int rejections_in_a_row_ = 0;
  StepCounts counts_;
};

}  // namespace rouleau
