// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/view.cpp
#include "spigolo/render/view.h"

#include <array>
#include <charconv>
#include <string>

#include "spigolo/core/error.h"

namespace spigolo {
namespace {

struct NamedView {
  std::string_view name;
  double azimuth, elevation;  // [degree]
};

constexpr std::array<NamedView, 7> named_views = {{{"iso", 45, 35.264389682754654},
                                                   {"front", 0, 0},
                                                   {"back", 180, 0},
                                                   {"left", -90, 0},
                                                   {"right", 90, 0},
                                                   {"top", 0, 90},
                                                   {"bottom", 0, -90}}};

std::optional<double> number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

}  // namespace

Vec3 view_direction(double azimuth, double elevation) {
  const double c = std::cos(elevation);
  return {-std::sin(azimuth) * c, std::cos(azimuth) * c, -std::sin(elevation)};
}

std::optional<Vec3> parse_view_direction(std::string_view text) {
  if (text == "auto") return {};
  for (const NamedView& v : named_views)
    if (v.name == text) return view_direction(radians(v.azimuth), radians(v.elevation));
  const std::size_t comma = text.find(',');
  if (comma != std::string_view::npos) {
    const auto azimuth = number(text.substr(0, comma)), elevation = number(text.substr(comma + 1));
    if (azimuth && elevation && std::abs(*elevation) <= 90)
      return view_direction(radians(*azimuth), radians(*elevation));
  }
  throw UsageError("view '" + std::string(text) +
                   "' is not auto, iso, front, back, left, right, top, bottom or AZ,EL in degrees");
}

}  // namespace spigolo
