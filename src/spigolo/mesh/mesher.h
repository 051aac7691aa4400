// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/mesher.h - points, normals and creases become a sharp, watertight triangle mesh
#pragma once

#include <string>
#include <vector>

#include "spigolo/core/feature_curves.h"
#include "spigolo/core/job.h"
#include "spigolo/core/triangle_mesh.h"
#include "spigolo/mesh/check.h"
#include "spigolo/mesh/samples.h"

namespace spigolo {

struct MesherOptions {
  double edge_length = 1;      // [spacings] aimed at; at least .3
  double chord_error = 0.006;  // [spacings] edges are shorter where they would leave a curved
                               // surface by more; 0: edges of one length everywhere
  double largest_hole = 8;     // [edge lengths, or edges along the hole if they are longer] across;
                               // wider openings are borders of the scan
  bool close = false;          // close wider ones too, of up to 2000 edges around
};

struct SharpMesh {
  TriangleMesh mesh;                // outside is counterclockwise; vertices on creases first
  std::vector<VertexPair> creases;  // segments that were to be edges, as vertices of the mesh
  std::vector<std::int32_t> curve;  // per segment, its curve in the network
  MeshCheck check;
  std::size_t holes_filled = 0;   // border loops closed; of those ...
  std::size_t caps_smooth = 0;    // ... by caps that continue the sheets around
  std::size_t caps_taut = 0;      // ... by films with an edge along the border
  std::size_t holes_left = 0;     // left open, since a cap would run into the mesh or ...
  std::size_t holes_long = 0;     // ... since more than 2000 edges go around
  std::size_t handles_cut = 0;    // tunnels and strands three edges around
  std::size_t faults_taken = 0;   // triangles taken away because the mesh failed its check there
  std::size_t parts = 0;          // surfaces meshed apart, since one manifold could not hold them
  std::size_t uncovered = 0;      // points of the cloud farther than two edges from the mesh
  double length_share = 1;        // of the edge length asked for that the mesh was made with
  std::size_t unused_points = 0;  // samples that are no vertex of the mesh
  double seconds_samples = 0, seconds_tetrahedra = 0, seconds_label = 0, seconds_total = 0;
};

/// Throws UsageError for an option out of range.
void check_options(const MesherOptions& options);

/// surface: about a spacing apart. network: the creases; where some are missing the mesh rounds
/// them. A torn mesh of a surface that is known at its points only (without `continued`: noise, or
/// the thesis's projections) is made again with edges .9, .8 and 1.2 times as long; the first that
/// closes is taken. Throws UsageError for options out of range, NoResultError if there is nothing
/// to mesh, Cancelled.
SharpMesh build_mesh(const SurfacePoints& surface, const FeatureCurves& network,
                     const MesherOptions& options = {}, const Job& job = {});

}  // namespace spigolo
