// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/palette.h - the colours of every picture and of every coloured file
#pragma once

#include <array>
#include <cstdint>

#include "spigolo/core/features.h"

namespace spigolo {

/// sRGB, 8 bits a channel.
struct Color {
  std::uint8_t r = 0, g = 0, b = 0;
  constexpr bool operator==(const Color&) const = default;
};

/// By kind: told apart by lightness and by the blue channel too, so that red-green blind readers
/// and grey printers keep them apart.
inline constexpr std::array<Color, point_kinds> kind_colors = {{
    {224, 227, 232},  // surface: neutral light grey
    {220, 24, 36},    // edge: strong red
    {16, 72, 200},    // corner: deep blue
    {226, 52, 214},   // tip: bright magenta
    {0, 158, 115},    // border: bluish green
}};

constexpr Color kind_color(PointKind kind) { return kind_colors[static_cast<std::size_t>(kind)]; }

inline constexpr Color ink = {38, 44, 54};            // text, scale bar, frames
inline constexpr Color pale_ink = {120, 128, 140};    // second-rank text
inline constexpr Color mesh_color = {204, 213, 224};  // triangles without colours of their own
inline constexpr Color background_top = {255, 255, 255};
inline constexpr Color background_bottom = {226, 231, 238};

/// The axes of the tripod: x, y, z.
inline constexpr std::array<Color, 3> axis_colors = {
    {{206, 60, 60}, {40, 150, 90}, {50, 100, 210}}};

/// diverging: blue - white - red around the middle, for signed deviations.
/// sequential: dark violet - teal - yellow, lightness rising evenly, for magnitudes.
enum class ColorMap : std::uint8_t { diverging, sequential };

/// t in [0, 1], clamped; NaN gives a middle grey.
Color map_color(ColorMap map, double t);

/// A well told apart colour for the i-th of many curves or files; repeats after ten.
Color curve_color(std::size_t i);

}  // namespace spigolo
