// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/cad/cad_file.h - faces of STEP and IGES files
#pragma once

#include <filesystem>
#include <memory>
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

/// A STEP or IGES file, read once; coordinates in the units of the file. Copies share what was
/// read; all functions may be called from any thread.
class CadFile {
 public:
  /// Throws InputError if the file is missing, damaged or neither STEP nor IGES; UsageError for an
  /// ending other than .step .stp .iges .igs. A file without faces is no error.
  explicit CadFile(const std::filesystem::path& path);

  const std::string& format() const;  // "STEP" or "IGES"
  const std::string& unit() const;    // "mm", "inch", ... ; empty if the file does not say
  std::span<const CadFaceInfo> faces() const;
  std::size_t free_curves() const;  // that bound no face
  std::size_t free_points() const;  // that end no curve
  const Box& bounds() const;        // of everything

  /// Face i as NURBS data, planes, cylinders and so on converted exactly. Throws UsageError if
  /// there is no such face, NoResultError if it has no area or cannot be converted.
  NurbsFace face(std::size_t i) const;

 private:
  struct Content;
  std::shared_ptr<const Content> content_;
};

/// Whether the ending of the name is one of .step .stp .iges .igs.
bool is_cad_file(const std::filesystem::path& path);

}  // namespace spigolo
