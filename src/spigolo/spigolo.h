// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/spigolo.h - the front door: everything a program needs to find the sharp features of a
// raw point cloud. Plain data in and out; lengths in the units of the input, angles in radians.
#pragma once

#include "spigolo/cad/cad_file.h"      // faces of STEP and IGES files
#include "spigolo/cad/cad_guard.h"     // the same, read by a process that may crash
#include "spigolo/core/error.h"        // what can be thrown
#include "spigolo/core/features.h"     // the verdict on every point
#include "spigolo/core/job.h"          // threads, progress, cancelling
#include "spigolo/core/point_cloud.h"  // points with named scalars
#include "spigolo/core/triangle_mesh.h"
#include "spigolo/detect/detect.h"        // detect()
#include "spigolo/index/summary.h"        // summarize(): counts, spacing, noise
#include "spigolo/io/cloud_file.h"        // read_cloud(), write_cloud(), write_mesh()
#include "spigolo/io/curve_writers.h"     // write_curves(): DXF and others
#include "spigolo/measure/distance.h"     // compare()
#include "spigolo/pipeline/blend.h"       // blend(), blend_sharp()
#include "spigolo/pipeline/curve_step.h"  // step_text(): curves as STEP
#include "spigolo/pipeline/lines.h"       // find_lines()
#include "spigolo/pipeline/mesh.h"        // mesh_cloud()
#include "spigolo/pipeline/smooth.h"      // smooth()
