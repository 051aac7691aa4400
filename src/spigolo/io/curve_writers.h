// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/curve_writers.h - networks of feature curves as DXF, OBJ, PLY, VTP, JSON, CSV
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "spigolo/core/feature_curves.h"
#include "spigolo/io/atomic_file.h"

namespace spigolo {

/// What one unit of the coordinates is. It is written where a format can say it; coordinates stay
/// as they are.
enum class LengthUnit : std::uint8_t { none, millimetre, centimetre, metre, inch, foot };

/// "none", "mm", "cm", "m", "in", "ft"; throws UsageError for anything else.
LengthUnit length_unit(const std::string& name);
const char* unit_name(LengthUnit unit);

enum class CurveFormat : std::uint8_t { dxf, obj, ply, vtp, json, csv };

/// By the ending, in any case of letters. Throws UsageError listing the endings known.
CurveFormat curve_format(const std::filesystem::path& path);

struct CurveFileOptions {
  LengthUnit unit = LengthUnit::none;
  double spacing = 0;  // [units] of the cloud, for JSON; 0: not known
};

/// The caller commits the file. An empty network gives a valid file without curves. The same
/// network gives the same bytes.
void write_curves(AtomicFile& out, CurveFormat format, const FeatureCurves& network,
                  const CurveFileOptions& options = {});

/// AutoCAD 2000 DXF: LINE, CIRCLE, ARC and SPLINE in model space, closed or open POLYLINE for
/// splines that are missing, POINT for corners. Layers EDGE_CONVEX, EDGE_CONCAVE, EDGE_UNKNOWN,
/// BORDER, CORNER.
std::string dxf_text(const FeatureCurves& network, const CurveFileOptions& options);

/// Vertices, one `l` a curve, corners shared.
std::string obj_text(const FeatureCurves& network);

/// VTK PolyData: corners as vertices, curves as lines; cell data curve, convex, border, length;
/// point data angle [degrees].
std::string vtp_text(const FeatureCurves& network);

/// As docs/lines.schema.json says.
std::string curves_json(const FeatureCurves& network, const CurveFileOptions& options);

/// One row a curve, after a row of names.
std::string curves_csv(const FeatureCurves& network);

/// PLY: vertices and `edge` elements (vertex1, vertex2, scalar_curve, scalar_angle).
void write_curves_ply(AtomicFile& out, const FeatureCurves& network);

}  // namespace spigolo
