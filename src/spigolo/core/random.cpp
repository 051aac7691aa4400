// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/core/random.cpp
#include "spigolo/core/random.h"

#include <bit>
#include <cmath>

namespace spigolo {
namespace {

// Natural logarithm of s in (0, 1) by sums and products alone: libraries differ in the last bit of
// std::log, these bits do not. log s = e ln 2 + 2 artanh((m-1)/(m+1)), m in [sqrt(1/2), sqrt(2)).
double portable_log(double s) {
  int exponent = 0;
  double m = std::frexp(s, &exponent);
  if (m < 0.70710678118654752) m *= 2, --exponent;
  const double t = (m - 1) / (m + 1), t2 = t * t;
  double series = 0;
  for (int n = 23; n >= 1; n -= 2) series = series * t2 + 1.0 / n;
  return exponent * 0.69314718055994531 + 2 * t * series;
}

}  // namespace

Random::Random(std::uint64_t seed) {
  for (std::uint64_t& word : state_) {
    seed += 0x9e3779b97f4a7c15u;
    std::uint64_t z = seed;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    word = z ^ (z >> 31);
  }
}

std::uint64_t Random::bits() {
  const std::uint64_t result = std::rotl(state_[1] * 5, 7) * 9, shifted = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= shifted;
  state_[3] = std::rotl(state_[3], 45);
  return result;
}

double Random::uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

std::uint64_t Random::below(std::uint64_t n) {
  const std::uint64_t limit = ~std::uint64_t{0} - ~std::uint64_t{0} % n;
  std::uint64_t b = bits();
  while (b >= limit) b = bits();
  return b % n;
}

double Random::normal() {
  while (true) {
    const double u = uniform(-1, 1), v = uniform(-1, 1), s = u * u + v * v;
    if (s > 0 && s < 1) return u * std::sqrt(-2 * portable_log(s) / s);
  }
}

Vec3 Random::in_ball() {
  while (true) {
    const double x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
    if (const Vec3 p{x, y, z}; squared_norm(p) <= 1) return p;
  }
}

Vec3 Random::on_sphere() {
  while (true) {
    const Vec3 p = in_ball();
    if (squared_norm(p) > 1e-6) return normalized(p);
  }
}

}  // namespace spigolo
