// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/gauss_map/clustering_simd.cpp - compiled once per instruction set, chosen at run time
#include <algorithm>
#include <cmath>
#include <limits>

#include "spigolo/gauss_map/clustering.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spigolo/gauss_map/clustering_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace spigolo {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Rows are padded to 64 floats, which are whole rounds of four of these vectors.
using RowTag = hn::CappedTag<float, 16>;

// arccos on [0, 1] within 2e-8 (Abramowitz, Stegun 4.4.46).
template <class D, class V = hn::Vec<D>>
V arc_cosine(D d, V x) {
  V sum = hn::Set(d, -0.0012624911f);
  for (const float c : {0.0066700901f, -0.0170881256f, 0.0308918810f, -0.0501743046f, 0.0889789874f,
                        -0.2145988016f, 1.5707963050f})
    sum = hn::Add(hn::Mul(sum, x), hn::Set(d, c));
  return hn::Mul(hn::Sqrt(hn::Sub(hn::Set(d, 1.0f), x)), sum);
}

// Row i: the axial angles (3.4) of normal i to all others; infinite to itself and beyond the last.
void angles_to_all(const GaussMap& map, std::size_t i, std::size_t stride, float* row) {
  const RowTag d;
  const auto ax = hn::Set(d, map.x[i]), ay = hn::Set(d, map.y[i]), az = hn::Set(d, map.z[i]);
  const auto one = hn::Set(d, 1.0f);
  for (std::size_t j = 0; j < stride; j += hn::Lanes(d)) {
    const auto x = hn::Mul(ax, hn::LoadU(d, &map.x[j]));
    const auto y = hn::Mul(ay, hn::LoadU(d, &map.y[j]));
    const auto z = hn::Mul(az, hn::LoadU(d, &map.z[j]));
    const auto cosine = hn::Min(hn::Abs(hn::Add(hn::Add(x, y), z)), one);
    hn::StoreU(arc_cosine(d, cosine), d, row + j);
  }
  row[i] = std::numeric_limits<float>::infinity();
}

struct Nearest {
  std::uint32_t cluster;
  float distance;
};

// The nearest living cluster, the first of equals. Dead ones carry an infinity in `dead`.
Nearest nearest_in_row(const float* row, const float* dead, std::size_t stride) {
  const RowTag d;
  const std::size_t lanes = hn::Lanes(d);
  const auto at = [&](std::size_t j) {
    return hn::Add(hn::LoadU(d, row + j), hn::LoadU(d, dead + j));
  };
  auto least = at(0), least1 = at(lanes), least2 = at(2 * lanes), least3 = at(3 * lanes);
  for (std::size_t j = 4 * lanes; j < stride; j += 4 * lanes) {  // four chains hide the latency
    least = hn::Min(least, at(j));
    least1 = hn::Min(least1, at(j + lanes));
    least2 = hn::Min(least2, at(j + 2 * lanes));
    least3 = hn::Min(least3, at(j + 3 * lanes));
  }
  const auto all = hn::MinOfLanes(d, hn::Min(hn::Min(least, least1), hn::Min(least2, least3)));
  const float distance = hn::GetLane(all);
  if (!(distance < std::numeric_limits<float>::infinity())) return {0, distance};
  for (std::size_t j = 0;; j += lanes)
    if (const auto lane = hn::FindFirstTrue(d, hn::Eq(at(j), all)); lane >= 0)
      return {static_cast<std::uint32_t>(j + static_cast<std::size_t>(lane)), distance};
}

// (3.5) after a merge: the mean over both halves, weighted by their normals.
void average_rows(float* into, const float* from, float weight_into, float weight_from,
                  std::size_t stride) {
  const RowTag d;
  const float total = weight_into + weight_from;
  const auto a = hn::Set(d, weight_into / total), b = hn::Set(d, weight_from / total);
  for (std::size_t j = 0; j < stride; j += hn::Lanes(d)) {
    const auto mean =
        hn::Add(hn::Mul(a, hn::LoadU(d, into + j)), hn::Mul(b, hn::LoadU(d, from + j)));
    hn::StoreU(mean, d, into + j);
  }
}

// Nearest-neighbor chains over rows that are brought up to date only when they are read: the later
// changed of two clusters has their distance right, so a stale row copies it from there.
class Merger {
 public:
  Merger(Clustering& c, std::size_t n, float sigma, std::size_t dominant)
      : c_(c), n_(n), sigma_(sigma), dominant_(dominant) {}

  void run() {
    for (std::uint32_t start = 0; start < n_ && !decided_; ++start)
      while (c_.dead[start] == 0 && !decided_) follow_chain(start);
  }

 private:
  float* row(std::uint32_t i) { return c_.distance.data() + i * c_.stride; }

  void follow_chain(std::uint32_t start) {
    c_.chain.assign(1, start);
    while (!c_.chain.empty() && !decided_) {
      const std::uint32_t top = c_.chain.back();
      refresh(top);
      Nearest nearest = nearest_in_row(row(top), c_.dead.data(), c_.stride);
      const std::uint32_t previous = c_.chain.size() > 1 ? c_.chain[c_.chain.size() - 2] : top;
      if (previous != top && row(top)[previous] <= nearest.distance) nearest.cluster = previous;
      if (!(nearest.distance <= sigma_)) {
        c_.dead[top] = std::numeric_limits<float>::infinity();  // final: nothing can reach it
        c_.chain.pop_back();
      } else if (nearest.cluster == previous && previous != top) {
        c_.chain.resize(c_.chain.size() - 2);
        merge(previous, top);
      } else {
        c_.chain.push_back(nearest.cluster);
      }
    }
  }

  void refresh(std::uint32_t i) {
    float* mine = row(i);
    for (std::size_t m = c_.merged.size(); m-- > 0;) {
      const std::uint32_t other = c_.merged[m];
      if (c_.changed[other] <= c_.seen[i]) break;  // merged is in order of time
      mine[other] = row(other)[i];
    }
    c_.seen[i] = now_;
  }

  void merge(std::uint32_t into, std::uint32_t from) {
    refresh(into);  // others may have merged since it was last the top; `from` was read just now
    average_rows(row(into), row(from), static_cast<float>(c_.weight[into]),
                 static_cast<float>(c_.weight[from]), c_.stride);
    row(into)[into] = std::numeric_limits<float>::infinity();
    c_.weight[into] += c_.weight[from];
    decided_ = c_.weight[into] >= dominant_;
    c_.parent[from] = into;
    c_.dead[from] = std::numeric_limits<float>::infinity();
    std::erase_if(c_.merged, [&](std::uint32_t m) { return m == into || m == from; });
    c_.merged.push_back(into);
    c_.changed[into] = c_.seen[into] = ++now_;
  }

  Clustering& c_;
  std::size_t n_;
  float sigma_;
  std::size_t dominant_;
  bool decided_ = false;
  std::uint32_t now_ = 0;
};

void merge_clusters(const GaussMap& map, float sigma, std::size_t dominant, Clustering& c) {
  for (std::size_t i = 0; i < map.size; ++i)
    angles_to_all(map, i, c.stride, c.distance.data() + i * c.stride);
  Merger(c, map.size, sigma, dominant).run();
}

}  // namespace HWY_NAMESPACE
}  // namespace spigolo
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace spigolo {
namespace {

constexpr std::size_t widest_vector = 64;  // floats

void prepare(std::size_t n, Clustering& c) {
  c.stride = (n + widest_vector - 1) / widest_vector * widest_vector;
  if (c.distance.size() < n * c.stride) c.distance.resize(n * c.stride);
  c.dead.assign(c.stride, std::numeric_limits<float>::infinity());
  std::fill_n(c.dead.begin(), n, 0.0f);
  c.parent.resize(n);
  for (std::uint32_t i = 0; i < n; ++i) c.parent[i] = i;
  c.weight.assign(n, 1);
  c.seen.assign(n, 0);
  c.changed.assign(n, 0);
  c.merged.clear();
}

// Clusters numbered by their first normal.
void number_clusters(std::size_t n, Clustering& c) {
  c.cluster.assign(n, 0);
  c.size.clear();
  std::vector<std::uint32_t>& number = c.changed;  // no longer needed: becomes root -> number
  std::fill(number.begin(), number.end(), ~0u);
  for (std::uint32_t i = 0; i < n; ++i) {
    std::uint32_t root = i;
    while (c.parent[root] != root) root = c.parent[root] = c.parent[c.parent[root]];
    if (number[root] == ~0u) {
      number[root] = static_cast<std::uint32_t>(c.size.size());
      c.size.push_back(0);
    }
    c.cluster[i] = number[root];
    ++c.size[number[root]];
  }
}

}  // namespace

HWY_EXPORT(merge_clusters);

void cluster_normals(const GaussMap& map, double sigma, Clustering& result, std::size_t dominant) {
  prepare(map.size, result);
  HWY_DYNAMIC_DISPATCH(merge_clusters)(map, static_cast<float>(sigma), dominant, result);
  number_clusters(map.size, result);
}

}  // namespace spigolo
#endif  // HWY_ONCE
