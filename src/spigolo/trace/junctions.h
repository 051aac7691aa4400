// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/junctions.h - where chains meet: gaps closed, corners found, chains cut at corners
#pragma once

#include <array>
#include <span>
#include <vector>

#include "spigolo/trace/chain_end.h"

namespace spigolo {

/// Chains between junctions: a curve network whose geometry is still that of the samples.
/// Lengths in spacings.
struct RawCurve {
  Chain chain;                                               // its places without the junctions
  std::array<int, 2> junction = {no_junction, no_junction};  // behind places.front() and .back()
  bool cut = false;                                          // a piece of a chain cut at a junction
};

struct RawNetwork {
  std::vector<RawCurve> curves;
  std::vector<Vec3> junctions;
};

/// Ends that run to a common place within a few spacings get its junction; the places are returned.
/// hints: where detection saw three sheets meet. sure: only where three ends meet, or two at a
/// hint.
std::vector<Vec3> find_junctions(std::vector<ChainEnd>& ends, std::span<const Vec3> hints,
                                 double scatter, bool sure);

/// Joins ends that face each other across a gap, but for those with a junction.
std::vector<Chain> bridge_gaps(std::vector<Chain> chains, std::span<const ChainEnd> ends,
                               double scatter);

/// Cuts chains where another one's end runs onto their side, or where they pass a junction; such
/// ends get a junction at the cut. One curve for each piece.
RawNetwork cut_chains(std::vector<Chain> chains, std::vector<ChainEnd> ends,
                      std::vector<Vec3> junctions, double scatter);

/// Leaves out spurs - short curves that end freely -, joins what they had cut, and numbers the
/// junctions that are left. least: [spacings] curves with two free ends are longer.
RawNetwork prune(RawNetwork network, double least);
inline double least_curve(double scatter) { return 4 + 6 * scatter; }

/// All of it: from chains to a network.
RawNetwork join_chains(std::vector<Chain> chains, std::span<const Vec3> hints, double scatter);

}  // namespace spigolo
