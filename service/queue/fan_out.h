#pragma once

#include <utility>
#include <vector>

#include "engine/simulation/output.h"

namespace rouleau::service {

/// Hands what a run delivers to several outputs, to the durable one first: what others see is then kept as
/// well.
class FanOut : public Output {
 public:
  explicit FanOut(std::vector<Output*> outputs) : outputs_(std::move(outputs)) {}

  void begin(const RunHeader& header) override {
    for (Output* output : outputs_) output->begin(header);
  }
  void series_row(std::span<const double> row) override {
    for (Output* output : outputs_) output->series_row(row);
  }
  void probe_row(double time, std::span<const ProbeValues> row) override {
    for (Output* output : outputs_) output->probe_row(time, row);
  }
  void frame(const Frame& frame) override {
    for (Output* output : outputs_) output->frame(frame);
  }
  void progress(const Progress& progress) override {
    for (Output* output : outputs_) output->progress(progress);
  }
  void checkpoint(const Checkpoint& checkpoint) override {
    for (Output* output : outputs_) output->checkpoint(checkpoint);
  }

 private:
  std::vector<Output*> outputs_;
};

}  // namespace rouleau::service
