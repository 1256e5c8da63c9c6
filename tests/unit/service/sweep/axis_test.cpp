#include "service/sweep/axis.h"

#include <algorithm>
#include <limits>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace rouleau::service {
namespace {

std::vector<Axis> axes_of(const std::vector<std::size_t>& sizes) {
  std::vector<Axis> axes;
  for (const std::size_t size : sizes) axes.push_back({"/a", std::vector<nlohmann::json>(size)});
  return axes;
}

RC_GTEST_PROP(Axis, AGridHasEveryCombinationOnceTheLastAxisFastest, ()) {
  const auto sizes = *rc::gen::container<std::vector<std::size_t>>(*rc::gen::inRange<std::size_t>(1, 5),
                                                                   rc::gen::inRange<std::size_t>(1, 6));
  const auto axes = axes_of(sizes);
  std::size_t product = 1;
  for (const std::size_t size : sizes) product *= size;
  RC_ASSERT(point_count(axes, SweepMode::grid, product) == product);
  RC_ASSERT(!point_count(axes, SweepMode::grid, product - 1));

  std::vector<std::vector<std::size_t>> choices;
  for (std::size_t k = 0; k < product; ++k) {
    choices.push_back(choice_at(axes, SweepMode::grid, k));
    for (std::size_t a = 0; a < sizes.size(); ++a) RC_ASSERT(choices.back()[a] < sizes[a]);
  }
  RC_ASSERT(std::is_sorted(choices.begin(), choices.end()));
  RC_ASSERT(std::set(choices.begin(), choices.end()).size() == product);
}

RC_GTEST_PROP(Axis, AZipHasAsManyPointsAsEachAxisHasValues, ()) {
  const auto size = *rc::gen::inRange<std::size_t>(1, 50);
  const auto axes = axes_of(std::vector(*rc::gen::inRange<std::size_t>(1, 5), size));
  RC_ASSERT(point_count(axes, SweepMode::zip, 50) == size);
  const auto point = *rc::gen::inRange<std::size_t>(0, size);
  RC_ASSERT(choice_at(axes, SweepMode::zip, point) == std::vector(axes.size(), point));
}

TEST(Axis, ManyLongAxesAreTooManyPoints) {
  EXPECT_FALSE(point_count(axes_of(std::vector<std::size_t>(16, 65536)), SweepMode::grid,
                           std::numeric_limits<std::size_t>::max()));
  EXPECT_FALSE(point_count(axes_of({11}), SweepMode::zip, 10));
  EXPECT_FALSE(point_count({}, SweepMode::grid, 10));
}

RC_GTEST_PROP(Axis, EvenlySpacedValuesRiseAndEndExactly, ()) {
  const double from = *rc::gen::arbitrary<int>() * 1e-7;
  const double to = from + *rc::gen::inRange(1, 1000) * 1e-3;
  const auto count = *rc::gen::inRange<std::size_t>(2, 200);
  const auto values = evenly_spaced(from, to, count);
  RC_ASSERT(values.size() == count);
  RC_ASSERT(values.front() == from && values.back() == to);
  for (std::size_t k = 1; k < count; ++k) RC_ASSERT(values[k] > values[k - 1]);
}

TEST(Axis, OneValueAloneIsTheFirst) {
  EXPECT_EQ(evenly_spaced(2, 7, 1), std::vector<double>{2});
}

}  // namespace
}  // namespace rouleau::service
