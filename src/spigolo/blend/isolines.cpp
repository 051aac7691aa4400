// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/isolines.cpp
#include "spigolo/blend/isolines.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "spigolo/core/error.h"

namespace spigolo {
namespace {

constexpr std::size_t fewest_lines = 8, most_lines = 200000;
constexpr int arc_samples = 512;  // chords that a line's length is measured with
constexpr std::array<double, 5> measured_at = {0, 0.25, 0.5, 0.75, 1};
constexpr double shortest = 1e-9;  // share of the range that counts as a line

}  // namespace

Isolines::Isolines(const NurbsFace& face, const BlendStart& start) : face_(face), start_(start) {
  const bool along_u = start.along == Parameter::u;
  along_ = along_u ? face.u : face.v;
  cross_ = along_u ? face.v : face.u;
  closed_ = along_u ? face.closed_v : face.closed_u;
  if (!line(cross_.at(0.5)) && !line(cross_.at(0.25)) && !line(cross_.at(0.75)))
    throw NoResultError("the start " + start.name + " lies nowhere on the face");
}

double Isolines::wrapped(double cross) const {
  if (!closed_ || (cross >= cross_.begin && cross <= cross_.end)) return cross;
  return cross - cross_.length() * std::floor((cross - cross_.begin) / cross_.length());
}

std::optional<Isoline> Isolines::line(double cross) const {
  const Parameter fixed = start_.along == Parameter::u ? Parameter::v : Parameter::u;
  const std::vector<Interval> parts = inside(face_, fixed, wrapped(cross));
  if (parts.empty()) return std::nullopt;
  const bool up = start_.direction > 0;
  Interval part = up ? parts.front() : parts.back();
  if (!start_.border) {
    const double value = along_.at(start_.share);
    const auto holds = [&](const Interval& i) { return value >= i.begin && value <= i.end; };
    const auto found = std::find_if(parts.begin(), parts.end(), holds);
    if (found == parts.end()) return std::nullopt;
    part = up ? Interval{value, found->end} : Interval{found->begin, value};
  }
  if (!(part.length() > shortest * along_.length())) return std::nullopt;
  return up ? Isoline{cross, part.begin, part.end} : Isoline{cross, part.end, part.begin};
}

IsoPoint Isolines::at(double cross, double along) const {
  const double c = wrapped(cross);
  const bool along_u = start_.along == Parameter::u;
  const double u = along_u ? along : c, v = along_u ? c : along;
  const NurbsPoint s = evaluate(face_.surface, u, v);
  Vec3 normal = spigolo::normalized(spigolo::cross(s.du, s.dv));
  if (normal == Vec3{}) normal = normal_at(face_.surface, u, v);
  const Vec3 onward = (along_u ? s.du : s.dv) * start_.direction;
  return {s.point, onward, along_u ? s.dv : s.du, normal};
}

bool Isolines::on_face(double cross, double along) const {
  if (face_.trims.empty()) return true;
  const Parameter fixed = start_.along == Parameter::u ? Parameter::v : Parameter::u;
  for (const Interval& part : inside(face_, fixed, wrapped(cross)))
    if (along >= part.begin && along <= part.end) return true;
  return false;
}

std::vector<double> Isolines::seeds(double spacing) const {
  // The longest of some curves across the lines decides how many there are.
  std::vector<double> arc, longest;
  for (const double share : measured_at) {
    arc.assign(1, 0);
    Vec3 last = at(cross_.begin, along_.at(share)).point;
    for (int i = 1; i <= arc_samples; ++i) {
      const Vec3 p = at(cross_.at(double(i) / arc_samples), along_.at(share)).point;
      arc.push_back(arc.back() + distance(p, last));
      last = p;
    }
    if (longest.empty() || arc.back() > longest.back()) longest = arc;
  }
  const double wanted = std::ceil(longest.back() / spacing);
  const auto count =
      static_cast<std::size_t>(std::clamp(wanted, double{fewest_lines}, double{most_lines}));
  std::vector<double> seeds;
  std::size_t segment = 1;
  for (std::size_t i = 0; i < count + (closed_ ? 0 : 1); ++i) {
    const double length = longest.back() * static_cast<double>(i) / static_cast<double>(count);
    while (segment + 1 < longest.size() && longest[segment] < length) ++segment;
    const double step = longest[segment] - longest[segment - 1];
    const double part = step > 0 ? std::clamp((length - longest[segment - 1]) / step, 0.0, 1.0) : 0;
    seeds.push_back(cross_.at((static_cast<double>(segment - 1) + part) / arc_samples));
  }
  return seeds;
}

}  // namespace spigolo
