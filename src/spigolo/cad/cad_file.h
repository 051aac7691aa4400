// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/cad/cad_file.h - faces of STEP and IGES files
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "spigolo/cad/nurbs_face.h"

namespace spigolo {

/// One face as the file has it.
struct CadFaceInfo {
  std::string type;  // plane cylinder cone sphere torus bezier bspline revolution extrusion offset
                     // other
  double area = 0;   // [square units of the file]
  Interval u, v;     // ranges of its parameters; angles in radians
  bool closed_u = false, closed_v = false;      // the face comes back to where it began
  bool periodic_u = false, periodic_v = false;  // its surface does so by its nature
  bool trimmed = false;                         // less than the rectangle of these ranges
  Box bounds;
};

/// All that is known of a file before one of its faces is asked for.
struct CadSummary {
  std::string format;  // "STEP" or "IGES"
  std::string unit;    // "mm", "inch", ... ; empty if the file does not say
  std::vector<CadFaceInfo> faces;
  std::size_t free_curves = 0;  // that bound no face
  std::size_t free_points = 0;  // that end no curve
  Box bounds;                   // of everything
};

/// A STEP or IGES file, read once; coordinates in the units of the file. Copies share what was
/// read; all functions may be called from any thread.
class CadFile {
 public:
  /// Reads it in this process. Throws InputError if the file is missing, damaged or neither STEP
  /// nor IGES; UsageError for an ending other than .step .stp .iges .igs. A file without faces is
  /// no error. OpenCASCADE crashes or hangs on some damaged files: read what you do not trust by
  /// read_cad_file_guarded() of cad_guard.h.
  explicit CadFile(const std::filesystem::path& path);
  /// Read elsewhere. convert: face i as NURBS data; asked only for faces that have an area, from
  /// any thread.
  CadFile(CadSummary summary, std::function<NurbsFace(std::size_t)> convert);

  const CadSummary& summary() const { return summary_; }
  const std::string& format() const { return summary_.format; }
  const std::string& unit() const { return summary_.unit; }
  std::span<const CadFaceInfo> faces() const { return summary_.faces; }
  std::size_t free_curves() const { return summary_.free_curves; }
  std::size_t free_points() const { return summary_.free_points; }
  const Box& bounds() const { return summary_.bounds; }

  /// Face i as NURBS data, planes, cylinders and so on converted exactly. Throws UsageError if
  /// there is no such face, NoResultError if it has no area or cannot be converted.
  NurbsFace face(std::size_t i) const;

 private:
  CadSummary summary_;
  std::function<NurbsFace(std::size_t)> convert_;
};

/// Whether the ending of the name is one of .step .stp .iges .igs.
bool is_cad_file(const std::filesystem::path& path);

}  // namespace spigolo
