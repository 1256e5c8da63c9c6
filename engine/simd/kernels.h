#pragma once

#include <limits>

namespace rouleau::simd {

/// The few loops in which most of the time goes, each compiled for plain x86-64 and for AVX2 from the same
/// source and without contraction, so that both give the same bits. Rows of pairs begin anywhere and are
/// padded to a multiple of `lanes` with pairs that do nothing.
inline constexpr int lanes = 8;

inline constexpr int padded(int count) {
  return (count + lanes - 1) / lanes * lanes;
}

/// Particles filed by bins, readable up to `lanes` beyond the last.
struct FiledPlaces {
  const double* x;
  const double* y;
  const int* id;
};

/// Some of them in a row, and the point that they are seen from.
struct PlaceRun {
  int from, count;
  double x0, y0;
};

/// Places around a particle, padded with places far away.
struct Candidates {
  const float* x;
  const float* y;
  const int* id;
  int count;
};

/// Where pairs are written, with room for `lanes` more than there are candidates.
struct PairRoom {
  int* id;
  float* dx;
  float* dy;
  unsigned char* sets;  ///< scratch: two for each eight candidates
};

struct PairCounts {
  int near = 0, all = 0;
  int last = -1;  ///< the highest id among them
};

/// Rows of a neighbour list: pairs begin[i] to end[i] (padded) are those of row i.
struct PairRows {
  int rows;
  const int* begin;
  const int* end;
  const int* j;
};

/// Positions of the pairs relative to their particle.
struct PairOffsets {
  const float* dx;
  const float* dy;
  const float* r;
};

/// Some rows, and where the weights of each row of the list begin.
struct RowChoice {
  const int* row;  ///< [rows]
  int rows;
  const int* weight_begin;  ///< [list rows]
};

/// A least-squares fit (see LeastSquares) of some rows, over pairs with j < j_end.
struct FitTask {
  RowChoice choice{};
  int j_end = std::numeric_limits<int>::max();
  float radius = 0;
  float* dx = nullptr;
  float* dy = nullptr;
  float* laplacian = nullptr;     ///< null: not wanted
  bool quartic = false;           ///< r^4 in the basis, too
  unsigned char* poor = nullptr;  ///< [rows] set where the normal matrix is not safely definite
};

/// A matrix as linear::SparseRows holds it.
struct MatrixRows {
  int rows;
  const int* begin;  ///< [rows + 1]
  const int* column;
  const float* value;
  const double* diagonal;
};

struct Kernels {
  /// Brings runs of places together, relative to their points; writes up to `lanes` places too many.
  void (*collect)(const FiledPlaces&, const PlaceRun* runs, int count, float* x, float* y, int* id);
  /// Pairs of particle `self` at (x, y), the near ones first, padded.
  PairCounts (*find_pairs)(const Candidates&, int self, float x, float y, float radius, float near_radius,
                           const PairRoom& out);
  /// Distances of the pairs of all rows; the padding from last[i] on is at the radius.
  void (*distances)(const PairRows&, const int* last, const float* dx, const float* dy, float radius,
                    float* r);

  void (*fit)(const PairRows&, const PairOffsets&, const FitTask&);

  // Sums of weight * (value_j - value_i) of velocities interleaved as u0, v0, u1, v1, ...; the products leave
  // out value_i.
  /// out [rows]: du/dx + dv/dy
  void (*divergences)(const PairRows&, const float* dx, const float* dy, const double* uv, double* out);
  /// out [rows][2], and the sum of each row's weights
  void (*velocity_laplacians)(const PairRows&, const float* laplacian, const double* uv, double* out,
                              double* weights);
  /// out [rows][2], in float: for the steps of a solver
  void (*velocity_products)(const PairRows&, const float* weight, const float* uv, float* out);

  /// out [rows][8]: d/dx and d/dy of four fields, interleaved likewise
  void (*field_gradients)(const PairRows&, const float* dx, const float* dy, const double* fields,
                          double* out);
  /// out [chosen rows][2]: df/dx, df/dy
  void (*gradients)(const PairRows&, const RowChoice&, const float* dx, const float* dy, const double* f,
                    double* out);

  /// out [rows][2]: sums over the neighbours, once moved, of (1 - r/reach)^3 and the unit vector away from
  /// them.
  /// @param moved  displacements, interleaved
  void (*crowding)(const PairRows&, const float* dx, const float* dy, const float* moved, float reach,
                   float* out);

  /// out = matrix x in
  void (*matrix_products)(const MatrixRows&, const double* in, double* out);
};

enum class Path { plain, avx2 };

/// Whether this processor can run a path.
bool available(Path path);
/// The path in use: the best there is, unless another one was chosen.
Path path();
/// Chooses a path for the whole process, for tests; not while anything is computed.
void choose(Path path);

const Kernels& kernels();

extern const Kernels plain_kernels;
extern const Kernels avx2_kernels;

}  // namespace rouleau::simd
