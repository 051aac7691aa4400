// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/border.h - where the collar begins on the face (alpha) and ends on the cloud (beta)
#pragma once

#include <string>

#include "spigolo/blend/cloud_side.h"
#include "spigolo/blend/curve_distance.h"
#include "spigolo/blend/strand.h"
#include "spigolo/core/error.h"

namespace spigolo {

/// The intersection curve X of a loop with its lengths, as the next stages ask for it.
struct CollarCurve {
  CurveDistance curve;
  std::vector<double> height, width;  // at each strand

  explicit CollarCurve(const BorderLoop& loop);
};

/// alpha_i: on isoline i, going back from X, the first place whose distance to the curve X is the
/// height there (thesis §5.4.2.2, but with the distance to X, not to the samples).
void find_alphas(const Isolines& isolines, const CollarCurve& collar, BorderLoop& loop,
                 const Job& job);

/// The cloud ends before the collar does.
class NoRoomOnCloud : public NoResultError {
 public:
  explicit NoRoomOnCloud(std::size_t lines)
      : NoResultError("the collar is wider than the cloud it runs on: " + std::to_string(lines) +
                      " of its lines leave the cloud; take a smaller radius or width") {}
};

struct BetaReport {
  std::size_t patched = 0;  // betas put between their neighbors: the way there was blocked
};

/// beta_i: on the MLS surface of the cloud, from X_i straight away from the face, the first place
/// whose distance to the curve X is the width there (thesis §5.4.2.3). Throws NoRoomOnCloud if the
/// cloud ends before.
BetaReport find_betas(const CloudSide& cloud, const CollarCurve& collar, BorderLoop& loop,
                      const Job& job);

}  // namespace spigolo
