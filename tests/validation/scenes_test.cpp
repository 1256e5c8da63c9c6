#include "tests/validation/scenes.h"

#include <gtest/gtest.h>

namespace rouleau::validation {
namespace {

/// At a resolution that takes a second or so.
Measurement coarse(const std::string& name, int across = 25) {
  return scene_named(name).run({across, Preset::standard});
}

// By the time 0.05 H^2/nu the wall's jump is still a few spacings wide.
TEST(Validation, CouetteFlowFromRest) {
  const Measurement m = coarse("couette_start");
  EXPECT_LE(m.error("velocity_at_0.05"), 0.01);
  EXPECT_LE(m.error("velocity_at_0.1"), 0.003);
  EXPECT_LE(m.error("velocity_at_0.5"), 0.002);
}

TEST(Validation, PoiseuilleFlowFromRest) {
  const Measurement m = coarse("poiseuille_start");
  EXPECT_LE(m.error("velocity_at_0.05"), 0.01);
  EXPECT_LE(m.error("velocity_at_0.1"), 0.006);
  EXPECT_LE(m.error("velocity_at_0.5"), 0.002);
}

TEST(Validation, PoiseuilleFlowWithoutPulses) {
  const Measurement plug = coarse("poiseuille_plug");
  EXPECT_LE(plug.error("profile_worst"), 0.002);
  EXPECT_LE(plug.error("flux_ripple"), 0.002);
  const Measurement parabolic = coarse("poiseuille_parabolic");
  EXPECT_LE(parabolic.error("profile_worst"), 0.0002);
  EXPECT_LE(parabolic.error("flux_ripple"), 0.002);
}

TEST(Validation, AChannelOfFortyDiametersEndsAsItsMiddle) {
  const Measurement m = coarse("long_channel", 16);
  EXPECT_LE(m.error("end_against_middle"), 0.002);
  EXPECT_LE(m.error("profile_at_end"), 0.002);
}

TEST(Validation, FlowThatReverses) {
  const Measurement m = coarse("womersley", 16);
  EXPECT_LE(m.error("velocity"), 0.006);
  EXPECT_LE(m.error("particles_a_cycle"), 0.005);
}

// 0.1 % is asked for at 100 across: half as many do.
TEST(Validation, VorticesDecay) {
  const Measurement coarser = coarse("taylor_green", 25), finer = coarse("taylor_green", 50);
  EXPECT_LE(finer.error("decay_rate"), 0.001);
  EXPECT_GE(coarser.error("velocity_rms") / finer.error("velocity_rms"), 3.4);  // order 1.8 and more
}

TEST(Validation, PlasmaAtRestUnderItsWeight) {
  const Measurement m = coarse("hydrostatic");
  EXPECT_LE(m.error("pressure"), 1e-3);
  EXPECT_LE(m.error("speed_over_sqrt_gH"), 1e-6);
}

// 3e-3 is asked for at 100 across, which takes minutes: what second order makes of it at 25 is 16 times that.
TEST(Validation, CavityWithAMovingLid) {
  const Measurement m = coarse("cavity_re100", 25);
  EXPECT_LE(m.error("u_on_the_vertical"), 0.01);
  EXPECT_LE(m.error("v_on_the_horizontal"), 0.01);
}

// 1 % and 2 % are asked for at 50 across. Crests that are four spacings high (0.16) have no shear stress to
// speak of at 25.
TEST(Validation, FlowOverBumps) {
  for (const char* name : {"bump_016", "bump_032", "bump_048", "bump_pair"}) {
    const Measurement m = coarse(name);
    EXPECT_LE(m.error("peak_velocity"), 0.01) << name;
    EXPECT_LE(m.error("extra_pressure_drop"), 0.03) << name;
    EXPECT_LE(m.error("crest_shear"), 0.03) << name;
  }
}

TEST(Validation, FlowDividesIntoBranches) {
  EXPECT_LE(coarse("bifurcation").error("share"), 0.002);
  EXPECT_LE(coarse("bifurcation_unequal").error("share"), 0.03);
}

}  // namespace
}  // namespace rouleau::validation
