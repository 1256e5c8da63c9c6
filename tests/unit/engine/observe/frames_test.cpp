#include "engine/observe/frames.h"

#include <algorithm>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "tests/unit/engine/simulation/recorder.h"
#include "tests/unit/engine/simulation/scenes.h"

namespace rouleau::observe {
namespace {

class Frames : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    recorder_ = new Recorder;
    run_case(coarse_vessel_with_cells(2), *recorder_);
  }
  static void TearDownTestSuite() { delete recorder_; }

  static inline Recorder* recorder_ = nullptr;
};

TEST_F(Frames, ArraysHaveOneEntryAParticleAndFitTheCapacity) {
  ASSERT_EQ(recorder_->frames.size(), 5u);
  for (const Frame& frame : recorder_->frames) {
    const std::size_t n = frame.id.size();
    EXPECT_GT(n, 200u);
    EXPECT_LE(n, static_cast<std::size_t>(recorder_->header.capacity));
    EXPECT_EQ(frame.kind.size(), n);
    EXPECT_EQ(frame.cell.size(), n);
    for (const auto* field : {&frame.x, &frame.y, &frame.u, &frame.v, &frame.p}) EXPECT_EQ(field->size(), n);
  }
}

TEST(FrameFields, AreThoseTheCaseAsksFor) {
  Case scene = coarse_vessel();
  scene.duration = 3e-5;
  scene.output.fields = {Field::pressure};
  Recorder recorder;
  run_case(scene, recorder);
  const Frame& frame = recorder.frames.front();
  EXPECT_EQ(frame.p.size(), frame.id.size());
  EXPECT_TRUE(frame.u.empty() && frame.v.empty() && frame.wall_shear_stress.empty());
}

TEST_F(Frames, IdsAreUniqueInAFrame) {
  for (const Frame& frame : recorder_->frames) {
    EXPECT_EQ(std::set(frame.id.begin(), frame.id.end()).size(), frame.id.size());
  }
}

TEST_F(Frames, MembraneNodesComeFirstCellByCellAndStayTheSame) {
  const auto& nodes = recorder_->header.nodes_per_cell;
  ASSERT_EQ(nodes.size(), 2u);
  const std::size_t membrane = static_cast<std::size_t>(nodes[0] + nodes[1]);
  for (const Frame& frame : recorder_->frames) {
    for (std::size_t i = 0; i < frame.id.size(); ++i) {
      ASSERT_EQ(frame.kind[i] == ParticleKind::membrane, i < membrane);
      if (i < membrane) {
        ASSERT_EQ(frame.cell[i], i < static_cast<std::size_t>(nodes[0]) ? 0 : 1);
        ASSERT_EQ(frame.id[i], recorder_->frames[0].id[i]);
      } else {
        ASSERT_EQ(frame.kind[i] == ParticleKind::plasma, frame.cell[i] == -1);
      }
    }
  }
}

TEST_F(Frames, OutlinesRunCounterClockwise) {
  const Frame& frame = recorder_->frames.back();
  int first = 0;
  for (const int nodes : recorder_->header.nodes_per_cell) {
    double twice_area = 0;
    for (int q = 0; q < nodes; ++q) {
      const int a = first + q, b = first + (q + 1) % nodes;
      twice_area += frame.x[a] * frame.y[b] - frame.x[b] * frame.y[a];
    }
    EXPECT_NEAR(twice_area / 2, 0.6 * std::numbers::pi * 6.36e-6 * 6.36e-6 / 4, 0.05 * 1.9e-11);
    first += nodes;
  }
}

TEST_F(Frames, ParticlesAreInTheVesselAndInsideFluidStaysWithItsCell) {
  const Frame& start = recorder_->frames.front();
  const auto inside = std::count(start.kind.begin(), start.kind.end(), ParticleKind::inside);
  EXPECT_GT(inside, 10);
  for (const Frame& frame : recorder_->frames) {
    EXPECT_EQ(std::count(frame.kind.begin(), frame.kind.end(), ParticleKind::inside), inside);
    for (std::size_t i = 0; i < frame.id.size(); ++i) {
      ASSERT_GT(frame.y[i], 0);
      ASSERT_LT(frame.y[i], 10e-6);
      ASSERT_GT(frame.x[i], -1e-6);
      ASSERT_LT(frame.x[i], 31e-6);
    }
  }
}

}  // namespace
}  // namespace rouleau::observe
