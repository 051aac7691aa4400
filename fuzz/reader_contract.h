// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// fuzz/reader_contract.h - what every reader promises for any bytes at all
#pragma once

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <span>

#include "spigolo/core/error.h"
#include "spigolo/io/cloud_file.h"

namespace spigolo {

inline constexpr std::size_t memory_growth = 64;           // bytes of a cloud per byte of input
inline constexpr std::size_t compressed_growth = 88 * 24;  // a compressed PCD grows 88 times first
inline constexpr std::size_t memory_floor = std::size_t{1} << 20;

inline std::size_t memory_of(const PointCloud& cloud) {
  std::size_t bytes = cloud.points.capacity() * sizeof(Vec3);
  for (const Attribute& a : cloud.attributes)
    bytes += sizeof a + a.name.capacity() + a.values.capacity() * sizeof(double);
  return bytes;
}

/// Reads the bytes as a cloud and, if wanted, as a mesh: each is valid and of a size in proportion
/// to the input, or InputError. Aborts otherwise.
inline void check_reader(std::span<const std::byte> bytes, FileFormat format, bool as_mesh) {
  const InputBytes input{"input", bytes};
  const std::size_t growth = format == FileFormat::pcd ? compressed_growth : memory_growth;
  const std::size_t allowed = growth * bytes.size() + memory_floor;
  const auto check = [&](const TriangleMesh& mesh) {
    validate(mesh);
    const std::size_t used =
        memory_of(mesh.vertices) + mesh.triangles.capacity() * sizeof mesh.triangles[0];
    if (used <= allowed) return;
    std::fprintf(stderr, "%zu bytes of input took %zu bytes\n", bytes.size(), used);
    std::abort();
  };
  try {
    check({read_cloud(input, format), {}});
  } catch (const InputError&) {
  }
  try {
    if (as_mesh) check(read_mesh(input, format));
  } catch (const InputError&) {
  }
}

}  // namespace spigolo
