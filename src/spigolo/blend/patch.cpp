// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/patch.cpp
#include "spigolo/blend/patch.h"

namespace spigolo {
namespace {

// Two good strands around one, and how far it lies from the first to the second.
struct Around {
  std::size_t a = 0, b = 0;
  double share = 0;
};

Around good_around(std::size_t i, const std::vector<char>& good, bool closed) {
  const std::size_t n = good.size();
  const auto steps_to_good = [&](bool forward) {
    for (std::size_t steps = 1; steps < n; ++steps) {
      if (!closed && (forward ? i + steps >= n : steps > i)) break;
      if (good[forward ? (i + steps) % n : (i + n - steps) % n]) return steps;
    }
    return std::size_t{0};
  };
  const std::size_t before = steps_to_good(false), after = steps_to_good(true);
  Around around;
  around.a = before > 0 ? (i + n - before) % n : (i + after) % n;
  around.b = after > 0 ? (i + after) % n : around.a;
  if (before > 0 && after > 0)
    around.share = static_cast<double>(before) / static_cast<double>(before + after);
  return around;
}

void put_beta(const CloudSide& cloud, const Strand& a, const Strand& b, double share, Strand& s) {
  MlsScratch scratch;
  const Vec3 between = a.beta + (b.beta - a.beta) * share;
  const OrientedFoot foot =
      orient_foot(cloud.project(between, scratch), between, a.beta_normal + b.beta_normal);
  s.beta = foot.foot;
  s.beta_normal = foot.found ? foot.normal : a.beta_normal;
}

template <class Put>
std::size_t patch(const std::vector<char>& good, BorderLoop& loop, const Put& put) {
  std::size_t patched = 0;
  for (std::size_t i = 0; i < good.size(); ++i) {
    if (good[i]) continue;
    const Around around = good_around(i, good, loop.closed);
    put(loop.strands[around.a], loop.strands[around.b], around.share, loop.strands[i]);
    ++patched;
  }
  return patched;
}

}  // namespace

std::size_t patch_betas(const CloudSide& cloud, const std::vector<char>& good, BorderLoop& loop) {
  return patch(good, loop, [&](const Strand& a, const Strand& b, double share, Strand& s) {
    put_beta(cloud, a, b, share, s);
  });
}

std::size_t patch_strands(const Isolines& isolines, const CloudSide& cloud,
                          const std::vector<char>& good, BorderLoop& loop) {
  return patch(good, loop, [&](const Strand& a, const Strand& b, double share, Strand& s) {
    put_beta(cloud, a, b, share, s);
    s.alpha_at = a.alpha_at + (b.alpha_at - a.alpha_at) * share;
    const IsoPoint p = isolines.at(s.line.cross, s.alpha_at);
    s.alpha = p.point;
    s.alpha_normal = p.normal;
  });
}

}  // namespace spigolo
