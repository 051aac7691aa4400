// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/chain_end.h - where a chain would go on beyond its end
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "spigolo/trace/chains.h"
#include "spigolo/trace/local_fit.h"

namespace spigolo {

inline constexpr int no_junction = -1;

/// One end of an open chain with the curve that goes on there. Lengths in spacings.
struct ChainEnd {
  std::size_t chain = 0;
  int side = 0;      // 0: at places.front(), 1: at places.back()
  LocalCurve model;  // place: the end; tangent: outward
  int junction = no_junction;
};

/// Both ends of every open chain, chain by chain.
std::vector<ChainEnd> find_ends(std::span<const Chain> chains, double scatter);

/// Where along its model (u, negative: back on the chain) an end passes a place, and how far off.
struct Passing {
  double u = 0, distance = 0;
};
Passing passing(const ChainEnd& end, const Vec3& place);

/// How far off a place an end may pass and still be said to meet there.
double meeting_tolerance(double u, double scatter);

/// The place where two ends come closest, with both u; nothing if they run side by side.
struct Meeting {
  Vec3 place;
  double u = 0, v = 0, gap = 0;
};
std::optional<Meeting> meeting(const ChainEnd& a, const ChainEnd& b);

/// The point nearest to the tangents of ends where they pass `near`; stays at `near` as far as they
/// leave it open.
Vec3 common_point(std::span<const ChainEnd> ends, std::span<const std::size_t> chosen,
                  const Vec3& near);

}  // namespace spigolo
