// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/curve_distance.cpp
#include "spigolo/blend/curve_distance.h"

#include <algorithm>

namespace spigolo {

CurveDistance::CurveDistance(std::span<const Vec3> points, bool closed)
    : points_(points.begin(), points.end()),
      closed_(closed),
      ordered_(order_cloud(points)),
      point_of_(ordered_.size()),
      tree_(ordered_) {
  for (std::size_t i = points_.size(); i-- > 0;)
    point_of_[ordered_.rank[i]] = static_cast<std::uint32_t>(i);
  for (std::size_t i = 0; i + (closed ? 0 : 1) < points_.size(); ++i)
    length_ += distance(points_[i], points_[(i + 1) % points_.size()]);
}

void CurveDistance::try_segment(std::size_t i, const Vec3& p, CurvePlace& best) const {
  const Vec3 &a = points_[i], &b = points_[(i + 1) % points_.size()];
  const Vec3 way = b - a;
  const double length = squared_norm(way);
  const double share = length > 0 ? std::clamp(dot(p - a, way) / length, 0.0, 1.0) : 0;
  const double d = distance(p, a + way * share);
  if (d < best.distance) best = {d, i, share};
}

CurvePlace CurveDistance::nearest(const Vec3& p, std::vector<Neighbor>& scratch) const {
  tree_.nearest(p - ordered_.origin, 1, scratch);
  const std::size_t n = points_.size(), i = point_of_[scratch.front().index];
  CurvePlace best;
  if (closed_ || i > 0) try_segment((i + n - 1) % n, p, best);
  if (closed_ || i + 1 < n) try_segment(i, p, best);
  return best;
}

double CurveDistance::interpolate(std::span<const double> values, const CurvePlace& place) const {
  const double a = values[place.index], b = values[(place.index + 1) % values.size()];
  return a + (b - a) * place.share;
}

}  // namespace spigolo
