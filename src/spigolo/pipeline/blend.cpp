// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/pipeline/blend.cpp
#include "spigolo/pipeline/blend.h"

#include "spigolo/detect/detect.h"
#include "spigolo/index/kd_tree.h"
#include "spigolo/pipeline/smooth.h"

namespace spigolo {
namespace {

constexpr double near_collar = 3;  // [spacings] within this, a neighborhood holds collar points

void make_surface(Features& f, std::size_t i) {
  f.kind[i] = PointKind::surface;
  f.angle[i] = 0;
  f.strength[i] = 0;
  f.convex[i] = 0;
  f.curve[i] = -1;
  f.crease_point[i] = {not_a_number, not_a_number, not_a_number};
  f.direction[i] = {};
  f.sheets[i] = 1;
}

void copy_label(const Features& from, std::size_t i, Features& to, std::size_t j) {
  to.kind[j] = from.kind[i];
  to.angle[j] = from.angle[i];
  to.strength[j] = from.strength[i];
  to.convex[j] = from.convex[i];
  to.curve[j] = -1;  // curves are counted anew in the blend
  to.crease_point[j] = from.crease_point[i];
  to.direction[j] = from.direction[i];
  to.sheets[j] = from.sheets[i];
}

// Which points lie near a collar, the collar itself too.
std::vector<char> beside_collar(const Blend& result) {
  std::vector<Vec3> collar;
  for (std::size_t i = 0; i < result.points.size(); ++i)
    if (result.source[i] == BlendSource::collar) collar.push_back(result.points[i]);
  std::vector<char> beside(result.points.size(), 0);
  if (collar.empty()) return beside;
  const OrderedCloud ordered = order_cloud(collar);
  const KdTree tree(ordered);
  std::vector<Neighbor> found;
  const double reach = near_collar * result.spacing;
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    tree.nearest(result.points[i] - ordered.origin, 1, found);
    beside[i] = found.front().squared_distance <= reach * reach;
  }
  return beside;
}

// Labels of the blend, near the collar those of the cloud alone.
Features merged_labels(const Features& alone, const Blend& result, const Job& job) {
  Features features = detect(result.points, {}, job).features;
  const std::vector<char> beside = beside_collar(result);
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    if (!beside[i]) continue;
    if (result.source[i] == BlendSource::cloud)
      copy_label(alone, result.cloud_index[i], features, i);
    else
      make_surface(features, i);
  }
  return features;
}

}  // namespace

Features label_blend(std::span<const Vec3> cloud, const Blend& result, const Job& job) {
  return merged_labels(detect(cloud, {}, job).features, result, job);
}

// Face and collar are where they should be; the samples of the cloud come onto the sharp surface of
// the cloud alone, to which the collar is no false side.
SharpBlend blend_sharp(std::span<const Vec3> cloud, const NurbsFace& face,
                       const BlendOptions& options, const Job& job) {
  SharpBlend out;
  out.blend = blend(cloud, face, options, job);
  const Features alone = detect(cloud, {}, job).features;
  out.features = merged_labels(alone, out.blend, job);
  SmoothOptions smoothing;
  smoothing.features = &alone;
  const Smoothed smoothed = smooth(cloud, smoothing, job);
  for (std::size_t i = 0; i < out.blend.cloud_index.size(); ++i) {
    const std::uint32_t from = out.blend.cloud_index[i];
    if (!on_surface(smoothed.status[from])) continue;
    const Vec3& n = smoothed.normal[from];
    out.blend.points[i] = smoothed.position[from];
    out.blend.normals[i] = dot(n, out.blend.normals[i]) < 0 ? -n : n;
  }
  return out;
}

}  // namespace spigolo
