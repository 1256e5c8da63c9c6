#include "service/commands/progress_line.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <unistd.h>

#include <fmt/format.h>

namespace rouleau::service {

namespace {

constexpr int bar_width = 24;

std::string describe(const Progress& progress) {
  return fmt::format("{:5.1f} %  {:.3f} of {:.3f} ms  {:.0f} steps/s  {} left", 100 * progress.fraction,
                     1e3 * progress.simulated_time, 1e3 * progress.duration, progress.steps_per_second,
                     format_time_left(progress.eta_s));
}

}  // namespace

std::string format_time_left(double seconds) {
  if (!(seconds >= 0) || seconds > 1e8) return "unknown time";
  const long whole = std::lround(seconds);
  if (whole >= 3600) return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
  if (whole >= 60) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} s", whole);
}

ProgressLine::ProgressLine() : terminal_(::isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (drawn_) std::cerr << '\n';
}

void ProgressLine::redraw(const std::string& text) {
  std::cerr << "\r\033[K" << text << std::flush;
  drawn_ = true;
}

void ProgressLine::show(const Progress& progress) {
  show(progress.fraction, describe(progress));
}

void ProgressLine::show(double fraction, const std::string& text) {
  if (terminal_) {
    const int filled = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * bar_width);
    redraw('[' + std::string(static_cast<std::size_t>(filled), '=') +
           std::string(static_cast<std::size_t>(bar_width - filled), ' ') + "] " + text);
    return;
  }
  const auto now = Clock::now();
  const bool far_enough = fraction >= last_fraction_ + 0.1;
  const bool long_enough = !last_time_ || now - *last_time_ >= std::chrono::seconds(2);
  if (!far_enough || !long_enough) return;
  last_fraction_ = fraction;
  last_time_ = now;
  std::cerr << text << std::endl;
}

}  // namespace rouleau::service
