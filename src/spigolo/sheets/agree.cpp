// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/agree.cpp
#include "spigolo/sheets/agree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "spigolo/core/parallel.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 256;
constexpr std::size_t asked = 40;       // neighbors
constexpr double longest = 3;           // [spacings] a crease is straight so far
constexpr double spread = 0.8;          // [spacings] creases this close may be one
constexpr std::size_t least_votes = 5;  // of them, to be believed
constexpr double parallel = 0.85;       // cosine of directions that agree
constexpr double farthest = 2;          // [spacings] of a crease that may still pass the point
constexpr double apart = 1.6;           // [spacings] between creases that are two
constexpr double against = 0.7;         // of a vote: what one for a bend counts

struct Vote {
  Vec3 foot;  // point of the neighbor's crease beside the asking point
  const SheetVerdict* from = nullptr;
};

// The number of votes that agree best, around each in turn the most others; they come to the front,
// all stay in their order. At most 64.
std::size_t put_largest_group_first(std::span<Vote> votes, double spacing) {
  std::array<std::uint64_t, asked + 1> with{};  // the votes that agree with each
  std::size_t best = 0;
  for (std::size_t a = 0; a < votes.size(); ++a) {
    with[a] |= std::uint64_t{1} << a;
    for (std::size_t b = a + 1; b < votes.size(); ++b) {
      if (std::abs(dot(votes[a].from->direction, votes[b].from->direction)) <= parallel ||
          distance(votes[a].foot, votes[b].foot) >= spread * spacing)
        continue;
      with[a] |= std::uint64_t{1} << b;
      with[b] |= std::uint64_t{1} << a;
    }
  }
  for (std::size_t a = 1; a < votes.size(); ++a)
    if (std::popcount(with[a]) > std::popcount(with[best])) best = a;
  std::array<Vote, asked + 1> others;
  std::size_t kept = 0, left = 0;
  for (std::size_t a = 0; a < votes.size(); ++a)
    (with[best] >> a & 1 ? votes[kept++] : others[left++]) = votes[a];
  std::copy_n(others.begin(), left, votes.begin() + static_cast<std::ptrdiff_t>(kept));
  return kept;
}

SheetVerdict mean_of(std::span<const Vote> votes) {
  const double n = static_cast<double>(votes.size());
  std::size_t folded = 0;
  SheetVerdict verdict;
  verdict.kind = PointKind::edge;
  for (const Vote& vote : votes) {
    const Vec3& d = vote.from->direction;
    verdict.crease_point += vote.foot / n;
    verdict.direction += dot(d, votes.front().from->direction) < 0 ? -d : d;
    const std::array<Vec3, 2>&into = vote.from->into, &first = votes.front().from->into;
    const bool crossed = dot(into[0], first[1]) + dot(into[1], first[0]) >
                         dot(into[0], first[0]) + dot(into[1], first[1]);
    for (std::size_t s = 0; s < 2; ++s) verdict.into[s] += into[crossed ? 1 - s : s];
    verdict.deviation += vote.from->deviation / n;
    verdict.strength += vote.from->strength / n;
    folded += vote.from->folded > 0;
  }
  verdict.direction = normalized(verdict.direction);
  for (Vec3& into : verdict.into) into = normalized(into);
  verdict.sheets = 2;
  verdict.folded = 2 * folded > votes.size() ? 1 : 0;
  return verdict;
}

// Of the creases that enough votes agree on, the one nearest to p: both rims of a thin plate and
// all edges of a corner are heard.
SheetVerdict nearest_crease(std::span<Vote> votes, const Vec3& p, double spacing, double least) {
  SheetVerdict nearest;
  double best = farthest * spacing;
  while (votes.size() >= least_votes) {
    const std::size_t n = put_largest_group_first(votes, spacing);
    if (n < least_votes || static_cast<double>(n) < least) break;
    const SheetVerdict mean = mean_of(votes.first(n));
    if (const double away = distance(p, mean.crease_point); away <= best)
      best = away, nearest = mean;
    votes = votes.subspan(n);
    const auto end = std::remove_if(votes.begin(), votes.end(), [&](const Vote& vote) {
      return std::abs(dot(vote.from->direction, mean.direction)) > parallel &&
             distance(vote.foot, mean.crease_point) < apart * spacing;
    });
    votes = votes.first(static_cast<std::size_t>(end - votes.begin()));
  }
  return nearest;
}

SheetVerdict ask(std::span<const Vec3> points, std::span<const std::uint32_t> neighbors,
                 const VerdictRows& proposals, std::uint32_t i, double spacing) {
  const SheetVerdict& own = proposals[i];
  if (own.kind == PointKind::corner || own.kind == PointKind::border) return own;
  std::array<Vote, asked + 1> heard;
  std::size_t count = 0;
  std::size_t bends = 0;
  const auto hear = [&](std::uint32_t j) {
    const SheetVerdict& v = proposals[j];
    bends += v.folded < 0;
    if (v.kind != PointKind::edge) return;
    const double along = dot(points[i] - v.crease_point, v.direction);
    if (std::abs(along) <= longest * spacing)
      heard[count++] = {v.crease_point + v.direction * along, &v};
  };
  hear(i);
  for (const std::uint32_t j : neighbors.first(std::min(asked, neighbors.size()))) hear(j);
  return nearest_crease(std::span(heard).first(count), points[i], spacing,
                        against * static_cast<double>(bends));
}

}  // namespace

VerdictRows agree_on_creases(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
                             const Spacing& spacing, const VerdictRows& proposals, const Job& job) {
  return {points.size(),
          parallel_collect<FoundVerdict>(
              job, points.size(), grain, [&](std::size_t begin, std::size_t end, auto& agreed) {
                for (std::size_t i = begin; i < end; ++i) {
                  const auto place = static_cast<std::uint32_t>(i);
                  const SheetVerdict verdict =
                      ask(points, neighborhoods.of(i), proposals, place, spacing.of_point[i]);
                  if (!verdict.says_nothing()) agreed.emplace_back(place, verdict);
                }
              })};
}

}  // namespace spigolo
