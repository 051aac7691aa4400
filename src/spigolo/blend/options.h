// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/options.h - what a user may choose of a blend (thesis §5.4)
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "spigolo/cad/nurbs_face.h"

namespace spigolo {

/// Where the sampling of the face starts (thesis §5.4.2.1) and which way it goes, along isolines.
struct BlendStart {
  Parameter along = Parameter::v;  // the parameter that runs
  double share = 0;                // of its range, in [0, 1]
  int direction = 1;               // 1 to larger values, -1 to smaller ones
  bool border = true;              // the end of the face there, trimmed or not; else an isoline
  std::string name = "v0";         // as the user wrote it
};

/// "u0" "u1" "v0" "v1" name a border; "u=0.4+" "v=0.5-" an isoline by its share of the range and
/// the way to go. Throws UsageError.
BlendStart parse_start(const std::string& text);

enum class BlendMethod : std::uint8_t {
  tangent,  // cubic strips tangent to both sides
  linear    // the thesis's collar
};

struct BlendOptions {
  BlendMethod method = BlendMethod::tangent;
  std::vector<BlendStart>
      starts;  // empty: the border that lies outside the cloud, if only one does
  // All lengths in spacings of the cloud; 0: chosen.
  double radius = 0;         // of the ball that rolls along both sides; 0: 3, more with noise
  double height = 0;         // how far the collar reaches along the face; the thesis's t
  double width = 0;          // along the cloud; the thesis's w
  std::optional<Vec3> keep;  // direction to the side of the cloud that stays
  std::uint64_t seed = 1;
};

/// Throws UsageError for a value out of range or a contradiction.
void check_options(const BlendOptions& options);

}  // namespace spigolo
