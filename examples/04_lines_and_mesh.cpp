// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// examples/04_lines_and_mesh.cpp - feature curves as DXF and a sharp mesh as STL, from one cloud
//
// usage: example_04_lines_and_mesh CLOUD CURVES.dxf MESH.stl
#include <spigolo/spigolo.h>

#include <cstdio>

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: %s CLOUD CURVES.dxf MESH.stl\n", argv[0]);
    return 2;
  }
  try {
    const spigolo::PointCloud cloud = spigolo::read_cloud(argv[1]);

    const spigolo::Lines lines = spigolo::find_lines(cloud.points);
    spigolo::AtomicFile dxf(argv[2]);  // there when all of it is written, or not at all
    spigolo::write_curves(dxf, spigolo::CurveFormat::dxf, lines.network);
    dxf.commit();

    spigolo::MeshOptions options;
    options.network = &lines.network;  // found already
    options.features = &lines.detection.features;
    const spigolo::MeshedCloud meshed = spigolo::mesh_cloud(cloud.points, options);
    spigolo::write_mesh(argv[3], meshed.sharp.mesh);

    std::printf("%zu curves, %zu corners, %zu triangles, %s\n", lines.network.curves.size(),
                lines.network.corners.size(), meshed.sharp.check.triangles,
                meshed.sharp.check.closed() ? "closed" : "open");
    return 0;
  } catch (const spigolo::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
