// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/strand.h - one isoline of the blend: where it meets the cloud, where the collar
// ends
#pragma once

#include <vector>

#include "spigolo/blend/isolines.h"

namespace spigolo {

/// Filled stage by stage. All vectors are unit, all points relative to the cloud's origin.
struct Strand {
  Isoline line;

  // The intersection of the face with the MLS surface of the cloud: X.
  bool crosses = false;
  double at = 0;        // parameter along the line
  Vec3 x, face_normal;  // point, and normal of the face there
  Vec3 cloud_normal;    // of the cloud, to the side the line comes from
  Vec3 toward_face;     // in the face, across X, back to the start
  Vec3 toward_cloud;    // in the cloud, across X, to the side that stays
  double angle = pi;    // [rad] of the free space between these two

  // The ball that touches both sides, and how far from X the collar reaches along the face and
  // along the cloud. In the units of the points.
  double radius = 0;  // 0: height and width are given
  double height = 0, width = 0;

  // Its borders: alpha on the face, beta on the cloud.
  double alpha_at = 0;  // parameter along the line
  Vec3 alpha, alpha_normal;
  Vec3 beta, beta_normal;
  // From there into the collar, in the tangent planes: how its cubic begins and ends.
  Vec3 alpha_handle, beta_handle;
};

/// The strands of one start, in the order of their lines.
struct BorderLoop {
  std::vector<Strand> strands;
  bool closed = false;
  int side = 1;         // the cloud stays where the face's normal points (1) or against it (-1)
  double widening = 0;  // of the ball beside acute corners
};

}  // namespace spigolo
