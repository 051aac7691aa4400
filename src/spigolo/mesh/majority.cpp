// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/majority.cpp - coarser and coarser, in pairs; then back, and at each step parts turn
// round if most of their neighbors say so
#include "spigolo/mesh/majority.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "spigolo/core/parity_sets.h"
#include "spigolo/mesh/edges.h"

namespace spigolo {
namespace {

constexpr int most_sweeps = 10;
constexpr float least_gain = 1e-4F;

struct Vote {
  std::uint32_t a, b;  // parts, a < b
  float sum;           // for the same sign; against it where negative
};

// Parts at one step of the coarsening, and where each one goes at the next.
struct Level {
  std::size_t parts = 0;
  std::vector<Vote> votes;
  std::vector<std::uint32_t> above;
  std::vector<std::uint8_t> turned;  // against the part above
};

void add_up(std::vector<Vote>& votes) {
  std::stable_sort(votes.begin(), votes.end(),
                   [](const Vote& x, const Vote& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
  std::size_t n = 0;
  for (const Vote& vote : votes)
    if (n > 0 && votes[n - 1].a == vote.a && votes[n - 1].b == vote.b)
      votes[n - 1].sum += vote.sum;
    else
      votes[n++] = vote;
  votes.resize(n);
}

Level first_level(const std::vector<Claim>& claims, std::size_t samples) {
  Level level;
  level.parts = samples;
  level.votes.reserve(claims.size());
  for (const Claim& claim : claims) {
    const float sure = 1 - claim.doubt, weight = sure * sure;
    level.votes.push_back(
        {std::min(claim.a, claim.b), std::max(claim.a, claim.b), claim.differ ? -weight : weight});
  }
  add_up(level.votes);
  return level;
}

// Pairs of parts, the surest first; a part whose neighbors are all taken joins the pair of the one
// it is surest of. Small steps: what was joined wrongly can still be turned on the way back.
ParitySets pair_up(const Level& level) {
  const auto& votes = level.votes;
  std::vector<std::uint32_t> order(votes.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return std::abs(votes[i].sum) > std::abs(votes[j].sum);
  });
  ParitySets sets(level.parts);
  std::vector<char> taken(level.parts, 0);
  for (const bool both : {true, false})
    for (const std::uint32_t i : order) {
      const auto& [a, b, sum] = votes[i];
      if (both ? taken[a] || taken[b] : taken[a] && taken[b]) continue;
      sets.join(a, b, static_cast<std::uint8_t>(sum < 0));
      taken[a] = taken[b] = 1;
    }
  return sets;
}

Level coarsen(Level& level) {
  ParitySets sets = pair_up(level);
  Level next;
  level.above.resize(level.parts);
  level.turned.resize(level.parts);
  for (std::uint32_t i = 0; i < level.parts; ++i) {  // roots come before those they stand for
    const auto [root, parity] = sets.find(i);
    level.above[i] = root == i ? static_cast<std::uint32_t>(next.parts++) : level.above[root];
    level.turned[i] = parity;
  }
  for (const Vote& vote : level.votes) {
    const std::uint32_t a = level.above[vote.a], b = level.above[vote.b];
    const bool against = level.turned[vote.a] != level.turned[vote.b];
    if (a != b)
      next.votes.push_back({std::min(a, b), std::max(a, b), against ? -vote.sum : vote.sum});
  }
  add_up(next.votes);
  return next;
}

// Votes of each part, one row a part.
struct Rows {
  std::vector<std::uint32_t> begin, vote;
};

Rows rows_of(const Level& level) {
  Rows rows;
  rows.begin.assign(level.parts + 1, 0);
  for (const Vote& v : level.votes) ++rows.begin[v.a], ++rows.begin[v.b];
  std::uint32_t sum = 0;
  for (std::uint32_t& b : rows.begin) b = sum += b;
  rows.vote.resize(sum);
  for (auto i = static_cast<std::uint32_t>(level.votes.size()); i-- > 0;) {
    rows.vote[--rows.begin[level.votes[i].a]] = i;
    rows.vote[--rows.begin[level.votes[i].b]] = i;
  }
  return rows;
}

// Parts that most of their neighbors contradict turn round.
void polish(const Level& level, std::vector<std::uint8_t>& sign) {
  const Rows rows = rows_of(level);
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    bool changed = false;
    for (std::size_t part = 0; part < level.parts; ++part) {
      float agreement = 0;
      for (std::uint32_t k = rows.begin[part]; k < rows.begin[part + 1]; ++k) {
        const Vote& v = level.votes[rows.vote[k]];
        agreement += sign[v.a] == sign[v.b] ? v.sum : -v.sum;
      }
      if (agreement >= -least_gain) continue;
      sign[part] ^= 1;
      changed = true;
    }
    if (!changed) break;
  }
}

}  // namespace

std::vector<std::uint8_t> settle_by_majority(const std::vector<Claim>& claims,
                                             std::size_t samples) {
  std::vector<Level> levels = {first_level(claims, samples)};
  while (!levels.back().votes.empty()) {
    Level next = coarsen(levels.back());
    levels.push_back(std::move(next));
  }
  std::vector<std::uint8_t> sign(levels.back().parts, 0);
  for (std::size_t k = levels.size() - 1; k-- > 0;) {
    std::vector<std::uint8_t> below(levels[k].parts);
    for (std::size_t i = 0; i < below.size(); ++i)
      below[i] = sign[levels[k].above[i]] ^ levels[k].turned[i];
    polish(levels[k], below);
    sign = std::move(below);
  }
  return sign;
}

}  // namespace spigolo
