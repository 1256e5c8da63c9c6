#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "engine/simulation/output.h"

namespace rouleau::service {

/// "1 h 04 min", "3 min 12 s", "8 s".
std::string format_time_left(double seconds);

/// Shows on standard error how far a run is: a bar that redraws itself on a terminal, elsewhere a plain line
/// every tenth of the way and at most one every two seconds.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const Progress& progress);
  /// Anything of which a fraction is done.
  void show(double fraction, const std::string& text);

 private:
  using Clock = std::chrono::steady_clock;

  void redraw(const std::string& text);

  bool terminal_;
  bool drawn_ = false;
  double last_fraction_ = -1;
  std::optional<Clock::time_point> last_time_;
};

}  // namespace rouleau::service
