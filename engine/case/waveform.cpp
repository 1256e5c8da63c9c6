#include "engine/case/waveform.h"

#include <algorithm>
#include <cmath>

namespace rouleau {

double waveform_factor(const Inflow& inflow, double time) {
  const std::vector<WaveformPoint>& points = inflow.waveform;
  if (points.empty()) return 1;
  const auto later = std::upper_bound(points.begin(), points.end(), time,
                                      [](double t, const WaveformPoint& point) { return t < point.time; });
  if (later == points.begin()) return points.front().factor;
  if (later == points.end()) return points.back().factor;
  const WaveformPoint& earlier = *(later - 1);
  return std::lerp(earlier.factor, later->factor, (time - earlier.time) / (later->time - earlier.time));
}

double largest_factor(const Inflow& inflow) {
  if (inflow.waveform.empty()) return 1;
  double largest = 0;
  for (const WaveformPoint& point : inflow.waveform) largest = std::max(largest, std::abs(point.factor));
  return largest;
}

}  // namespace rouleau
