// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mls/mls_cloud.cpp
#include "spigolo/mls/mls_cloud.h"

#include <utility>

namespace spigolo {
namespace {

constexpr std::size_t spacing_k = 16;  // neighbors that spacing and noise are read off

}  // namespace

MlsCloud::MlsCloud(std::span<const Vec3> points, const Job& job)
    : MlsCloud(prepare_cloud(points, spacing_k, job)) {}

MlsCloud::MlsCloud(PreparedCloud&& prepared)
    : cloud_(std::move(prepared.cloud)),
      tree_(cloud_),
      spacing_(std::move(prepared.spacing)),
      noise_(prepared.noise) {}

double MlsCloud::spacing_at(std::span<const Neighbor> samples) const {
  double sum = 0;
  for (const Neighbor& n : samples) sum += spacing_.of_point[n.index];
  return samples.empty() ? spacing_.of_cloud : sum / static_cast<double>(samples.size());
}

}  // namespace spigolo
