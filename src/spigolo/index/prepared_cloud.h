// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/prepared_cloud.h - what every method starts from: order, neighbors, spacing, noise
#pragma once

#include <span>
#include <string>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/index/kd_tree.h"
#include "spigolo/index/neighborhoods.h"
#include "spigolo/index/order.h"
#include "spigolo/index/spacing.h"

namespace spigolo {

struct PreparedCloud {
  OrderedCloud cloud;
  Neighborhoods neighborhoods;
  Spacing spacing;
  double noise = 0;  // [spacings]
};

/// Throws NoResultError for fewer than nine different places or points that all lie on one line.
PreparedCloud prepare_cloud(std::span<const Vec3> points, std::size_t k, const Job& job = {});

/// Searches again if the rows hold fewer than k neighbors and there are more.
void widen_neighborhoods(PreparedCloud& prepared, std::size_t k, const Job& job = {});

/// The number of neighbors there are, at most `wanted`; a note in `warnings` if that is less.
std::size_t neighbors_at_hand(const PreparedCloud& prepared, std::size_t wanted,
                              std::vector<std::string>& warnings);

}  // namespace spigolo
