// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/palette.cpp
#include "spigolo/render/palette.h"

#include <cmath>
#include <span>

namespace spigolo {
namespace {

constexpr std::array<Color, 7> diverging_stops = {{{20, 60, 150},
                                                   {64, 128, 206},
                                                   {158, 202, 236},
                                                   {246, 246, 246},
                                                   {250, 184, 154},
                                                   {222, 88, 72},
                                                   {150, 14, 36}}};
constexpr std::array<Color, 6> sequential_stops = {
    {{60, 20, 90}, {58, 76, 140}, {34, 126, 142}, {44, 174, 120}, {142, 214, 70}, {250, 232, 50}}};

constexpr std::array<Color, 10> curve_stops = {{{220, 24, 36},
                                                {16, 100, 210},
                                                {0, 158, 115},
                                                {236, 140, 0},
                                                {140, 60, 190},
                                                {0, 160, 210},
                                                {150, 90, 40},
                                                {226, 80, 170},
                                                {110, 130, 0},
                                                {70, 80, 100}}};

std::uint8_t mix(std::uint8_t a, std::uint8_t b, double t) {
  return static_cast<std::uint8_t>(std::lround(a + (b - a) * t));
}

Color interpolate(std::span<const Color> stops, double t) {
  const double at = t * static_cast<double>(stops.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  const double f = at - static_cast<double>(i);
  const Color &a = stops[i], &b = stops[i + 1];
  return {mix(a.r, b.r, f), mix(a.g, b.g, f), mix(a.b, b.b, f)};
}

}  // namespace

Color map_color(ColorMap map, double t) {
  if (std::isnan(t)) return {150, 150, 150};
  t = std::clamp(t, 0.0, 1.0);
  return map == ColorMap::diverging ? interpolate(diverging_stops, t)
                                    : interpolate(sequential_stops, t);
}

Color curve_color(std::size_t i) { return curve_stops[i % curve_stops.size()]; }

}  // namespace spigolo
