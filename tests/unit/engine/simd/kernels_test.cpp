#include "engine/simd/kernels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace rouleau::simd {
namespace {

/// Rows of random pairs over `places` particles, of every length from 0 up.
struct RandomRows {
  explicit RandomRows(unsigned seed) : random(seed) {
    for (int i = 0; i < rows; ++i) {
      begin.push_back(static_cast<int>(j.size()));
      const int length = padded(i % 41);
      for (int k = 0; k < length; ++k) {
        const float x = unit(random), y = unit(random);
        j.push_back(place(random));
        dx.push_back(x);
        dy.push_back(y);
        r.push_back(std::sqrt(x * x + y * y));
        w1.push_back(unit(random));
        w2.push_back(unit(random));
      }
    }
    begin.push_back(static_cast<int>(j.size()));
    all.resize(rows);
    std::iota(all.begin(), all.end(), 0);
    for (int k = 0; k < 4 * places; ++k) values.push_back(unit(random));
    for (int k = 0; k < 2 * places; ++k) moved.push_back(0.2F * unit(random));
  }

  PairRows list() const { return {rows, begin.data(), begin.data() + 1, j.data()}; }

  static constexpr int rows = 90, places = 120;
  std::mt19937 random;
  std::uniform_real_distribution<float> unit{-0.7F, 0.7F};
  std::uniform_int_distribution<int> place{0, places - 1};
  std::vector<int> begin, j, all;
  std::vector<float> dx, dy, r, w1, w2, moved;
  std::vector<double> values;
};

class BothPaths : public testing::TestWithParam<unsigned> {
 protected:
  void SetUp() override {
    if (!available(Path::avx2)) GTEST_SKIP() << "this processor has no AVX2";
  }

  RandomRows rows_{GetParam()};
};

/// Runs on plain and AVX2 kernels into results of the same length; they must not differ in a bit.
template <class Element, class Run>
void expect_same(std::size_t length, const Run& run) {
  std::vector<Element> plain(length, -1), fast(length, -2);
  run(plain_kernels, plain.data());
  run(avx2_kernels, fast.data());
  for (std::size_t k = 0; k < length; ++k) {
    if constexpr (sizeof(Element) == 8) {
      ASSERT_EQ(std::bit_cast<std::uint64_t>(plain[k]), std::bit_cast<std::uint64_t>(fast[k])) << k;
    } else {
      ASSERT_EQ(std::bit_cast<std::uint32_t>(plain[k]), std::bit_cast<std::uint32_t>(fast[k])) << k;
    }
  }
}

TEST_P(BothPaths, SumOverPairsAlike) {
  const auto list = rows_.list();
  const float *w1 = rows_.w1.data(), *w2 = rows_.w2.data();
  const double* uv = rows_.values.data();
  expect_same<double>(
      list.rows, [&](const Kernels& kernels, double* out) { kernels.divergences(list, w1, w2, uv, out); });
  expect_same<double>(8 * list.rows, [&](const Kernels& kernels, double* out) {
    kernels.field_gradients(list, w1, w2, uv, out);
  });
  expect_same<double>(3 * list.rows, [&](const Kernels& kernels, double* out) {
    kernels.velocity_laplacians(list, w1, uv, out, out + 2 * list.rows);
  });
  const std::vector<float> in_float(rows_.values.begin(), rows_.values.end());
  expect_same<float>(2 * list.rows, [&](const Kernels& kernels, float* out) {
    kernels.velocity_products(list, w1, in_float.data(), out);
  });
  expect_same<double>(2 * list.rows, [&](const Kernels& kernels, double* out) {
    kernels.gradients(list, {rows_.all.data(), list.rows, list.begin}, w1, w2, uv, out);
  });
}

TEST_P(BothPaths, MultiplyMatricesAlike) {
  const MatrixRows matrix{RandomRows::rows, rows_.begin.data(), rows_.j.data(), rows_.w1.data(),
                          rows_.values.data()};
  expect_same<double>(matrix.rows, [&](const Kernels& kernels, double* out) {
    kernels.matrix_products(matrix, rows_.values.data(), out);
  });
}

TEST_P(BothPaths, MeasureCrowdingAlike) {
  const auto list = rows_.list();
  expect_same<float>(2 * list.rows, [&](const Kernels& kernels, float* out) {
    kernels.crowding(list, rows_.dx.data(), rows_.dy.data(), rows_.moved.data(), 0.9F, out);
  });
}

TEST_P(BothPaths, FitAlike) {
  const auto list = rows_.list();
  const std::size_t pairs = rows_.j.size();
  for (const auto& [with_laplacian, quartic] :
       {std::pair(true, true), std::pair(true, false), std::pair(false, false)}) {
    expect_same<float>(3 * pairs + list.rows, [&](const Kernels& kernels, float* out) {
      std::fill(out, out + 3 * pairs, 0.0F);
      std::vector<unsigned char> poor(list.rows);
      kernels.fit(list, {rows_.dx.data(), rows_.dy.data(), rows_.r.data()},
                  {{rows_.all.data(), list.rows, list.begin},
                   80,
                   1.0F,
                   out,
                   out + pairs,
                   with_laplacian ? out + 2 * pairs : nullptr,
                   quartic,
                   poor.data()});
      std::copy(poor.begin(), poor.end(), out + 3 * pairs);
      EXPECT_GT(std::count(poor.begin(), poor.end(), 1), 5);
      EXPECT_GT(std::count(poor.begin(), poor.end(), 0), 40);
    });
  }
}

TEST_P(BothPaths, CollectPlacesAlike) {
  std::vector<double> x(40), y(40);
  std::vector<int> id(40);
  std::iota(id.begin(), id.end(), 0);
  for (int k = 0; k < 40; ++k) {
    x[k] = 10 * rows_.unit(rows_.random);
    y[k] = 10 * rows_.unit(rows_.random);
  }
  const std::vector<PlaceRun> runs{
      {3, 5, 0.1, 0.2}, {20, 0, 1, 1}, {12, 9, -0.3, 7}, {0, 1, 0, 0}, {28, 4, 2, 1}};
  constexpr std::size_t total = 19;
  expect_same<float>(3 * total, [&](const Kernels& kernels, float* out) {
    std::vector<float> found_x(total + lanes), found_y(total + lanes);
    std::vector<int> found_id(total + lanes);
    kernels.collect({x.data(), y.data(), id.data()}, runs.data(), static_cast<int>(runs.size()),
                    found_x.data(), found_y.data(), found_id.data());
    EXPECT_EQ(found_id[5], 12);
    EXPECT_EQ(found_x[5], static_cast<float>(x[12] + 0.3));
    EXPECT_EQ(found_id[total - 1], 31);
    for (std::size_t k = 0; k < total; ++k) {
      out[3 * k] = found_x[k];
      out[3 * k + 1] = found_y[k];
      out[3 * k + 2] = static_cast<float>(found_id[k]);
    }
  });
}

TEST_P(BothPaths, FindTheSamePairsInTheSameOrder) {
  std::uniform_real_distribution<float> place(-1.5F, 1.5F);
  for (int count = 0; count < 70; ++count) {
    std::vector<float> x(padded(count), 1e30F), y(padded(count), 1e30F);
    std::vector<int> id(padded(count));
    std::iota(id.begin(), id.end(), 100);
    for (int k = 0; k < count; ++k) {
      x[k] = place(rows_.random);
      y[k] = place(rows_.random);
    }
    const int self = 100 + count / 2;
    const std::size_t room = padded(count) + 2 * lanes;
    // As floats: the numbers found, ids, dx, dy, r.
    expect_same<float>(4 * room + 3, [&](const Kernels& kernels, float* out) {
      std::vector<int> j(room);
      std::vector<float> dx(room), dy(room), r(room);
      std::vector<unsigned char> sets(room);
      const PairCounts found = kernels.find_pairs({x.data(), y.data(), id.data(), count}, self, 0.1F, -0.2F,
                                                  1.2F, 0.8F, {j.data(), dx.data(), dy.data(), sets.data()});
      const int begin[] = {0, padded(found.all)};
      kernels.distances({1, begin, begin + 1, j.data()}, &found.all, dx.data(), dy.data(), 1.2F, r.data());
      std::fill(out, out + 4 * room + 3, 0.0F);
      out[0] = static_cast<float>(found.near);
      out[1] = static_cast<float>(found.all);
      out[4 * room + 2] = static_cast<float>(found.last);
      EXPECT_EQ(found.last, found.all ? *std::max_element(j.begin(), j.begin() + found.all) : -1);
      for (int k = 0; k < padded(found.all); ++k) {
        out[4 * k + 2] = static_cast<float>(j[k]);
        out[4 * k + 3] = dx[k];
        out[4 * k + 4] = dy[k];
        out[4 * k + 5] = r[k];
      }
    });
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, BothPaths, testing::Range(1u, 4u));

TEST(Kernels, APathThatIsNotThereIsNotTaken) {
  const Path before = path();
  choose(Path::plain);
  EXPECT_EQ(path(), Path::plain);
  EXPECT_EQ(&kernels(), &plain_kernels);
  choose(Path::avx2);
  EXPECT_EQ(path(), available(Path::avx2) ? Path::avx2 : Path::plain);
  choose(before);
}

}  // namespace
}  // namespace rouleau::simd
