// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/cad/nurbs_face.cpp
#include "spigolo/cad/nurbs_face.h"

#include <algorithm>

#include "spigolo/core/error.h"

namespace spigolo {
namespace {

// An isoline on the very border runs along a trimming curve; one this share of the range inside
// does not.
constexpr double off_the_border = 1e-9;
// Borders of a closed face agree within this share of the size of its control net.
constexpr double seam_tolerance = 1e-6;
constexpr int seam_samples = 16;

double coordinate(const ParamPoint& p, Parameter which) {
  return which == Parameter::u ? p.u : p.v;
}

bool borders_agree(const NurbsFace& face, Parameter across) {
  const double size = norm(bounding_box(face.surface.poles).size());
  for (int i = 0; i <= seam_samples; ++i) {
    const double share = double(i) / seam_samples;
    const bool along_v = across == Parameter::u;
    const Vec3 a = along_v ? point_at(face.surface, face.u.begin, face.v.at(share))
                           : point_at(face.surface, face.u.at(share), face.v.begin);
    const Vec3 b = along_v ? point_at(face.surface, face.u.end, face.v.at(share))
                           : point_at(face.surface, face.u.at(share), face.v.end);
    if (distance(a, b) > seam_tolerance * size) return false;
  }
  return true;
}

// A border that is one point (the tip of a cone) agrees with everything: no seam.
bool has_extent(const NurbsFace& face, Parameter along) {
  const double size = norm(bounding_box(face.surface.poles).size());
  const Vec3 a = point_at(face.surface, face.u.begin, face.v.begin);
  double extent = 0;
  for (int i = 1; i < seam_samples; ++i) {
    const double share = double(i) / seam_samples;
    const Vec3 p = along == Parameter::u ? point_at(face.surface, face.u.at(share), face.v.at(0.5))
                                         : point_at(face.surface, face.u.at(0.5), face.v.at(share));
    extent = std::max(extent, distance(a, p));
  }
  return extent > seam_tolerance * size;
}

}  // namespace

void validate(const NurbsFace& face) {
  validate(face.surface);
  if (!(face.u.length() > 0 && face.v.length() > 0)) throw Error("face: its range is empty");
}

Vec3 outward_normal(const NurbsFace& face, double u, double v) {
  const Vec3 n = normal_at(face.surface, u, v);
  return face.reversed ? -n : n;
}

std::vector<Interval> inside(const NurbsFace& face, Parameter fixed, double value) {
  const Interval& across = fixed == Parameter::u ? face.u : face.v;
  const Interval& along = fixed == Parameter::u ? face.v : face.u;
  if (face.trims.empty()) return {along};
  const Parameter other = fixed == Parameter::u ? Parameter::v : Parameter::u;
  value = std::clamp(value, across.at(off_the_border), across.at(1 - off_the_border));
  std::vector<double> crossings;
  for (const TrimCurve& curve : face.trims)
    for (std::size_t i = 1; i < curve.size(); ++i) {
      const double a = coordinate(curve[i - 1], fixed), b = coordinate(curve[i], fixed);
      if ((a <= value) == (b <= value)) continue;
      const double share = (value - a) / (b - a);
      const double from = coordinate(curve[i - 1], other), to = coordinate(curve[i], other);
      crossings.push_back(from + (to - from) * share);
    }
  std::sort(crossings.begin(), crossings.end());
  std::vector<Interval> intervals;  // even-odd rule
  for (std::size_t i = 1; i < crossings.size(); i += 2)
    intervals.push_back({crossings[i - 1], crossings[i]});
  return intervals;
}

void find_seams(NurbsFace& face) {
  face.closed_u = borders_agree(face, Parameter::u) && has_extent(face, Parameter::u);
  face.closed_v = borders_agree(face, Parameter::v) && has_extent(face, Parameter::v);
}

}  // namespace spigolo
