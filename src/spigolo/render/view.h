// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/view.h - from where and how near a scene is seen
#pragma once

#include <optional>
#include <string_view>

#include "spigolo/core/geometry.h"

namespace spigolo {

/// z is up. Whatever the zoom, the eye stays outside the scene: close-ups look through a longer
/// lens.
struct View {
  std::optional<Vec3> direction;  // from the eye into the scene; none: the one that shows most
  Vec3 up = {0, 0, 1};            // if it lies along the direction, +y or +x is taken
  bool perspective = true;
  double zoom = 1;             // 2 shows half the width; > 0
  std::optional<Vec3> target;  // in the middle of the picture; none: the whole scene is fitted
  double radius = 0;           // [model unit] what must fit round the target; 0: the scene's
};

/// The direction of "iso", "front" (looking along +y), "back", "left" (along +x), "right", "top",
/// "bottom" or "az,el" in degrees: azimuth of the eye from -y towards +x, elevation above the xy
/// plane. None for "auto". Throws UsageError for anything else.
std::optional<Vec3> parse_view_direction(std::string_view text);

/// Into the scene, from an eye at this azimuth and elevation [rad].
Vec3 view_direction(double azimuth, double elevation);

}  // namespace spigolo
