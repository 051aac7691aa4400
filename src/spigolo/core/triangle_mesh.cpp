// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/core/triangle_mesh.cpp
#include "spigolo/core/triangle_mesh.h"

#include "spigolo/core/error.h"

namespace spigolo {

void validate(const TriangleMesh& mesh) {
  validate(mesh.vertices);
  const std::size_t n = mesh.vertices.size();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = mesh.triangles[t];
    if (a >= n || b >= n || c >= n || a == b || b == c || c == a)
      throw Error("triangle mesh: triangle " + std::to_string(t) +
                  " does not name three different vertices that exist");
  }
}

}  // namespace spigolo
