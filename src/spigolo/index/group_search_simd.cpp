// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/group_search_simd.cpp - compiled once per instruction set, chosen at run time
#include "spigolo/index/group_search.h"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spigolo/index/group_search_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace spigolo {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void measure(const GroupCandidates& c, std::size_t query, float* squared_distance) {
  const hn::ScalableTag<float> d;
  const auto qx = hn::Set(d, c.x[query]), qy = hn::Set(d, c.y[query]), qz = hn::Set(d, c.z[query]);
  for (std::size_t i = 0; i < GroupCandidates::padded(c.count); i += hn::Lanes(d)) {
    const auto x = hn::Sub(hn::LoadU(d, &c.x[i]), qx), y = hn::Sub(hn::LoadU(d, &c.y[i]), qy),
               z = hn::Sub(hn::LoadU(d, &c.z[i]), qz);
    const auto sum = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
    hn::StoreU(sum, d, squared_distance + i);
  }
}

std::size_t count_within(const float* squared_distance, std::size_t n, float threshold) {
  const hn::ScalableTag<float> d;
  const auto limit = hn::Set(d, threshold);
  std::size_t count = 0;
  for (std::size_t i = 0; i < n; i += hn::Lanes(d))
    count += hn::CountTrue(d, hn::Le(hn::LoadU(d, squared_distance + i), limit));
  return count;
}

std::size_t collect_within(const float* squared_distance, std::size_t n, float threshold,
                           std::uint32_t* places) {
  const hn::ScalableTag<float> d;
  const hn::RebindToUnsigned<decltype(d)> du;
  const auto limit = hn::Set(d, threshold);
  std::size_t count = 0;
  for (std::size_t i = 0; i < n; i += hn::Lanes(d)) {
    const auto within = hn::Le(hn::LoadU(d, squared_distance + i), limit);
    const auto place = hn::Iota(du, static_cast<std::uint32_t>(i));
    count += hn::CompressStore(place, hn::RebindMask(du, within), du, places + count);
  }
  return count;
}

// A threshold that holds at least `wanted` distances and not many more. Near it the count grows
// like the area, in proportion to the squared distance, which gives the next guess.
float find_threshold(const float* squared_distance, std::size_t n, std::size_t wanted,
                     float guess) {
  constexpr int max_steps = 40;
  const std::size_t enough = wanted + 2 + wanted / 4, aim = (wanted + enough) / 2;
  float low = 0, high = 13;  // no two points of the unit cube's frame are farther apart
  float threshold = std::clamp(guess, 1e-12f, high);
  for (int step = 0; step < max_steps; ++step) {
    const std::size_t count = count_within(squared_distance, n, threshold);
    if (count >= wanted && count <= enough) return threshold;
    (count < wanted ? low : high) = threshold;
    const float ratio =
        static_cast<float>(aim) / static_cast<float>(std::max<std::size_t>(count, 1));
    threshold *= std::clamp(ratio, 0.3f, 4.0f);
    if (threshold <= low || threshold >= high || step > 6) threshold = (low + high) / 2;
  }
  return high;
}

std::size_t select(const GroupCandidates& c, std::size_t query, std::size_t wanted,
                   float& threshold, GroupScratch& scratch) {
  const std::size_t padded = GroupCandidates::padded(c.count);
  if (scratch.squared_distance.size() < padded) {
    scratch.squared_distance.resize(padded);
    scratch.survivors.resize(padded + GroupCandidates::group_lanes);
  }
  float* squared_distance = scratch.squared_distance.data();
  measure(c, query, squared_distance);
  threshold = find_threshold(squared_distance, padded, std::min(wanted, c.count), threshold);
  // Each distance is off by at most 2.1e-7 absolute (two rounded ends) and 3e-7 relative.
  const float root = std::sqrt(threshold) + 4.3e-7f;
  const float safe = std::min(root * root * (1 + 2e-6f), 13.0f);
  return collect_within(squared_distance, padded, safe, scratch.survivors.data());
}

// The place of a distance in the sorted list is the number of smaller ones (of equal ones, those
// before it): no branch to mispredict. A vector of them at a time is held against each.
void rank(const double* distance, std::size_t n, std::size_t wanted, std::uint32_t* out) {
  const hn::ScalableTag<double> d;
  const hn::RebindToSigned<decltype(d)> di;
  const std::size_t lanes = hn::Lanes(d);
  HWY_ALIGN std::int64_t place[hn::MaxLanes(di)];
  for (std::size_t begin = 0; begin < n; begin += lanes) {
    const std::size_t here = std::min(lanes, n - begin);
    const auto mine = hn::MaskedLoad(hn::FirstN(d, here), d, distance + begin);
    auto smaller = hn::Zero(di);
    const auto count = [&](auto mask) HWY_ATTR {
      smaller = hn::Sub(smaller, hn::VecFromMask(di, hn::RebindMask(di, mask)));
    };
    std::size_t j = 0;
    for (; j < begin; ++j) count(hn::Le(hn::Set(d, distance[j]), mine));
    for (; j < begin + here; ++j) {
      const auto other = hn::Set(d, distance[j]);
      const auto behind = hn::Not(hn::FirstN(d, j - begin + 1));
      count(hn::Or(hn::Lt(other, mine), hn::And(hn::Eq(other, mine), behind)));
    }
    for (; j < n; ++j) count(hn::Lt(hn::Set(d, distance[j]), mine));
    hn::Store(smaller, di, place);
    for (std::size_t l = 0; l < here; ++l)
      if (static_cast<std::size_t>(place[l]) < wanted)
        out[place[l]] = static_cast<std::uint32_t>(begin + l);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace spigolo
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace spigolo {

HWY_EXPORT(select);
HWY_EXPORT(rank);

void GroupCandidates::reserve(std::size_t n) {
  if (padded(n) <= x.size()) return;
  for (std::vector<float>* axis : {&x, &y, &z}) axis->resize(padded(n));
  index.resize(padded(n));
}

std::size_t select_candidates(const GroupCandidates& candidates, std::size_t query,
                              std::size_t wanted, float& threshold, GroupScratch& scratch) {
  return HWY_DYNAMIC_DISPATCH(select)(candidates, query, wanted, threshold, scratch);
}

void rank_ascending(const double* distance, std::size_t n, std::size_t wanted, std::uint32_t* out) {
  HWY_DYNAMIC_DISPATCH(rank)(distance, n, wanted, out);
}

}  // namespace spigolo
#endif  // HWY_ONCE
