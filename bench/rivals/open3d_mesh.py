#!/usr/bin/python3
# Copyright 2026 The spigolo authors
# SPDX-License-Identifier: Apache-2.0
#
# bench/rivals/open3d_mesh.py - Open3D's meshes: Poisson, ball pivoting
#
# open3d_mesh.py version
# open3d_mesh.py poisson|ball-pivoting IN.xyz OUT.off SPACING DEPTH     (IN has oriented normals)
import sys

import numpy
import open3d


def main(arguments):
    if arguments == ["version"]:
        print(open3d.__version__)
        return
    mode, source, target, spacing, depth = arguments
    rows = numpy.loadtxt(source)
    cloud = open3d.geometry.PointCloud()
    cloud.points = open3d.utility.Vector3dVector(rows[:, :3])
    cloud.normals = open3d.utility.Vector3dVector(rows[:, 3:6])
    if mode == "poisson":
        mesh, _ = open3d.geometry.TriangleMesh.create_from_point_cloud_poisson(
            cloud, depth=int(depth), n_threads=1)
    else:
        radii = [float(spacing) * r for r in (0.75, 1.0, 1.5, 2.5)]
        mesh = open3d.geometry.TriangleMesh.create_from_point_cloud_ball_pivoting(
            cloud, open3d.utility.DoubleVector(radii))
    open3d.io.write_triangle_mesh(target, mesh)


main(sys.argv[1:])
