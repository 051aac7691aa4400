// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/neighborhoods.h - the k nearest neighbors of every point at once
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/index/kd_tree.h"

namespace spigolo {

/// Row i holds the k nearest neighbors of point i (canonical order), itself left out, nearest
/// first, ties by the canonical order. A shorter k is a prefix of each row.
struct Neighborhoods {
  std::size_t k = 0;
  std::vector<std::uint32_t> index;  // size() * k

  std::size_t size() const { return k == 0 ? 0 : index.size() / k; }
  std::span<const std::uint32_t> of(std::size_t i) const { return {index.data() + i * k, k}; }
};

/// k is cut to the number of other points. The result is that of brute force, to the last tie.
Neighborhoods find_neighborhoods(const KdTree& tree, std::size_t k, const Job& job = {});

/// Throws Error unless every row names k different points, without i itself, nearest first.
void validate(const Neighborhoods& neighborhoods, std::span<const Vec3> points);

}  // namespace spigolo
