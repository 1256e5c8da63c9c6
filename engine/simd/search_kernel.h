#pragma once

#include "engine/simd/vector.h"

namespace rouleau::simd {
namespace {

void collect(const FiledPlaces& places, const PlaceRun* runs, int count, float* x, float* y, int* id) {
  for (const PlaceRun* run = runs; run != runs + count; ++run) {
    const Doubles x0 = all(run->x0), y0 = all(run->y0);
    for (int k = 0; k < run->count; k += 4) {
      const int from = run->from + k;
      store(x + k, __builtin_convertvector(load<Doubles>(places.x + from) - x0, HalfFloats));
      store(y + k, __builtin_convertvector(load<Doubles>(places.y + from) - y0, HalfFloats));
      store(id + k, load<HalfInts>(places.id + from));
    }
    x += run->count;
    y += run->count;
    id += run->count;
  }
}

/// Brings out the pairs that a set has for each eight candidates; writes up to eight places too many.
inline void write_pairs(const Candidates& candidates, const unsigned char* sets, int stride, Floats x,
                        Floats y, const PairRoom& out, int at) {
  for (int k = 0; k < candidates.count; k += lanes, sets += stride) {
    const Compress chosen_ones(*sets);
    chosen_ones(load<Ints>(candidates.id + k), out.id + at);
    chosen_ones(load<Floats>(candidates.x + k) - x, out.dx + at);
    chosen_ones(load<Floats>(candidates.y + k) - y, out.dy + at);
    at += __builtin_popcount(*sets);
  }
}

PairCounts find_pairs(const Candidates& candidates, int self, float x, float y, float radius,
                      float near_radius, const PairRoom& out) {
  const Floats x0 = all(x), y0 = all(y);
  const Floats radius2 = all(radius * radius), near2 = all(near_radius * near_radius);
  PairCounts found;
  Ints last = -1 - Ints{};
  // Which ones, first: the far ones have their place once the near ones are counted.
  for (int k = 0; k < candidates.count; k += lanes) {
    const Floats dx = load<Floats>(candidates.x + k) - x0;
    const Floats dy = load<Floats>(candidates.y + k) - y0;
    const Ints id = load<Ints>(candidates.id + k);
    const Floats r2 = dx * dx + dy * dy;
    const Ints within = (r2 < radius2) & (id != self);
    const unsigned set = bits(within), near_set = bits(within & (r2 < near2));
    const Ints seen = (id & within) | ~within;
    last = seen > last ? seen : last;
    unsigned char* const sets = out.sets + 2 * (k / lanes);
    sets[0] = static_cast<unsigned char>(near_set);
    sets[1] = static_cast<unsigned char>(set & ~near_set);
    found.near += __builtin_popcount(near_set);
    found.all += __builtin_popcount(set);
  }
  for (int lane = 0; lane < lanes; ++lane) found.last = last[lane] > found.last ? last[lane] : found.last;
  write_pairs(candidates, out.sets, 2, x0, y0, out, 0);
  write_pairs(candidates, out.sets + 1, 2, x0, y0, out, found.near);
  store(out.id + found.all, self - Ints{});
  store(out.dx + found.all, Floats{});
  store(out.dy + found.all, Floats{});
  return found;
}

void distances(const PairRows& list, const int* last, const float* dx, const float* dy, float radius,
               float* r) {
  for (int i = 0; i < list.rows; ++i) {
    for (int k = list.begin[i]; k < list.end[i]; k += lanes) {
      const Floats x = load<Floats>(dx + k), y = load<Floats>(dy + k);
      store(r + k, root(x * x + y * y));
    }
    // At the radius the padding has weight 0 in everything.
    for (int k = last[i]; k < list.end[i]; ++k) r[k] = radius;
  }
}

}  // namespace
}  // namespace rouleau::simd
