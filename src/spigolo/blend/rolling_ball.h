// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/rolling_ball.h - where a ball that rolls along face and cloud touches both
#pragma once

#include "spigolo/blend/border.h"

namespace spigolo {

/// For every strand the ball of its radius: alpha on its isoline and beta on the cloud, so that the
/// ball touches the face at alpha and the MLS surface at beta. Sets alpha, beta, their normals,
/// handles, height and width. A ball that finds no such place, or whose beta runs against the order
/// of the strands (a corner narrower than the ball), is put between its neighbors. Throws
/// NoRoomOnCloud if the cloud ends before beta, NoResultError if the face ends before alpha, or if
/// half of the balls find no place.
BetaReport roll_ball(const Isolines& isolines, const CloudSide& cloud, BorderLoop& loop,
                     const Job& job);

}  // namespace spigolo
