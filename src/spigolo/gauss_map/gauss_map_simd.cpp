// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/gauss_map/gauss_map_simd.cpp - compiled once per instruction set, chosen at run time
#include <algorithm>
#include <cmath>

#include "spigolo/gauss_map/edges.h"
#include "spigolo/gauss_map/gauss_map.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spigolo/gauss_map/gauss_map_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace spigolo {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Appends the normals of the triangles (p, p_i, p_j) for all j > i.
std::size_t append_normals(const Edges& e, std::size_t i, std::size_t n, std::size_t filled,
                           GaussMap& map) {
  const hn::ScalableTag<float> d;
  const auto ax = hn::Set(d, e.x[i]), ay = hn::Set(d, e.y[i]), az = hn::Set(d, e.z[i]);
  const auto smallest = hn::Set(d, static_cast<float>(degenerate_sine * degenerate_sine));
  for (std::size_t j = i + 1; j < n; j += hn::Lanes(d)) {
    const auto bx = hn::LoadU(d, &e.x[j]), by = hn::LoadU(d, &e.y[j]), bz = hn::LoadU(d, &e.z[j]);
    const auto nx = hn::Sub(hn::Mul(ay, bz), hn::Mul(az, by));  // (3.2)
    const auto ny = hn::Sub(hn::Mul(az, bx), hn::Mul(ax, bz));
    const auto nz = hn::Sub(hn::Mul(ax, by), hn::Mul(ay, bx));
    const auto squared = hn::Add(hn::Add(hn::Mul(nx, nx), hn::Mul(ny, ny)), hn::Mul(nz, nz));
    const auto valid = hn::And(hn::Ge(squared, smallest), hn::FirstN(d, n - j));
    const auto length = hn::Sqrt(squared);
    hn::CompressStore(hn::Div(nx, length), valid, d, &map.x[filled]);  // (3.3)
    hn::CompressStore(hn::Div(ny, length), valid, d, &map.y[filled]);
    filled += hn::CompressStore(hn::Div(nz, length), valid, d, &map.z[filled]);
  }
  return filled;
}

std::size_t all_normals(const Edges& edges, std::size_t n, GaussMap& map) {
  std::size_t filled = 0;
  for (std::size_t i = 0; i + 1 < n; ++i) filled = append_normals(edges, i, n, filled, map);
  return filled;
}

}  // namespace HWY_NAMESPACE
}  // namespace spigolo
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace spigolo {
HWY_EXPORT(all_normals);

void compute_gauss_map(const Vec3& p, std::span<const Vec3> neighbors, GaussMap& map) {
  Edges edges;
  std::size_t n = 0;
  for (const Vec3& neighbor : neighbors) {
    const Vec3 e = neighbor - p;
    const double length = norm(e);
    if (length == 0 || n == Edges::most) continue;
    edges.x[n] = static_cast<float>(e.x / length);
    edges.y[n] = static_cast<float>(e.y / length);
    edges.z[n++] = static_cast<float>(e.z / length);
  }
  const std::size_t triangles = n * (n - (n > 0)) / 2;
  if (map.x.size() < triangles + Edges::widest_vector)
    for (std::vector<float>* axis : {&map.x, &map.y, &map.z})
      axis->resize(triangles + Edges::widest_vector);
  map.size = HWY_DYNAMIC_DISPATCH(all_normals)(edges, n, map);
  // Whoever reads full vectors finds zeros behind the last normal, never a NaN.
  for (std::vector<float>* axis : {&map.x, &map.y, &map.z})
    std::fill_n(axis->begin() + static_cast<std::ptrdiff_t>(map.size), Edges::widest_vector, 0.0f);
}

}  // namespace spigolo
#endif  // HWY_ONCE
