// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/gauss_map/clustering.h - agglomerative clustering of the Gauss map (thesis §3.4.3)
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/gauss_map/gauss_map.h"

namespace spigolo {

/// Scratch memory of one thread and the result of the last clustering.
struct Clustering {
  std::vector<std::uint32_t> cluster;  // per normal: the number of its cluster, 0-based
  std::vector<std::uint32_t> size;     // per cluster: its normals

  // What the merging works with; row i of `distance` is the mean distance of cluster i to each
  // other cluster, valid as of time `seen[i]`.
  std::size_t stride = 0;
  std::vector<float> distance, dead;
  std::vector<std::uint32_t> parent, weight, seen, changed, chain, merged;
};

/// Merges the normals of `map` by mean linkage (3.5) of the axial distance (3.4) until the closest
/// two clusters are more than sigma [rad] apart. Exact: the cut of the dendrogram at sigma. Mean
/// linkage is reducible (a merge brings no cluster closer to a third than its nearer half was), so
/// nearest-neighbor chains find the same tree as always merging the closest pair (Murtagh 1983),
/// and a cluster whose nearest neighbor is beyond sigma is final and leaves the search. Ties are
/// decided by the order of the normals.
/// dominant: ends early once a cluster has this many normals (it is part of the exact result; the
/// others are left as they stand then), for callers who need to know no more.
void cluster_normals(const GaussMap& map, double sigma, Clustering& result,
                     std::size_t dominant = ~std::size_t{0});

}  // namespace spigolo
