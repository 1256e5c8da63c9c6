#pragma once

#include "engine/observe/output.h"

namespace rouleau::service {

/// Hands what a run delivers to two outputs, to the durable one first: what others see is then kept as well.
class FanOut : public Output {
 public:
  FanOut(Output& first, Output& second) : first_(first), second_(second) {}

  void begin(const RunHeader& header) override {
    first_.begin(header);
    second_.begin(header);
  }
  void series_row(std::span<const double> row) override {
    first_.series_row(row);
    second_.series_row(row);
  }
  void probe_row(double time, std::span<const ProbeValues> row) override {
    first_.probe_row(time, row);
    second_.probe_row(time, row);
  }
  void frame(const Frame& frame) override {
    first_.frame(frame);
    second_.frame(frame);
  }
  void progress(const Progress& progress) override {
    first_.progress(progress);
    second_.progress(progress);
  }

 private:
  Output& first_;
  Output& second_;
};

}  // namespace rouleau::service
