// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/cloud_side.cpp
#include "spigolo/blend/cloud_side.h"

#include <cmath>
#include <utility>

namespace spigolo {
namespace {

constexpr std::size_t neighbors_kept = 16;  // of each sample

}  // namespace

CloudSide::CloudSide(std::span<const Vec3> points, const Job& job)
    : CloudSide(prepare_cloud(points, neighbors_kept, job)) {}

CloudSide::CloudSide(PreparedCloud&& prepared)
    : neighborhoods_(std::move(prepared.neighborhoods)),
      cloud_(std::move(prepared)),
      options_(settle({}, cloud_.noise())) {}

double CloudSide::sample_distance(const Vec3& p, MlsScratch& scratch) const {
  tree().nearest(p, 1, scratch.found);
  return std::sqrt(scratch.found.front().squared_distance);
}

SurfacePoint CloudSide::project(const Vec3& p, MlsScratch& scratch) const {
  const Surroundings around = look_around(cloud_, p, options_, scratch);
  if (around.status != SurfaceStatus::sheet) return {p, {}, {}, around.status};
  scratch.neighbors.clear();
  for (const Neighbor& n : scratch.found) scratch.neighbors.push_back(points()[n.index]);
  return project_levin(p, scratch.neighbors, options_.smoothing * around.spacing, scratch);
}

}  // namespace spigolo
