// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/isolines.h - the parameter lines of a face that leave one start (thesis §5.4.2.1)
#pragma once

#include <optional>
#include <vector>

#include "spigolo/blend/options.h"

namespace spigolo {

/// A place on the face, seen from an isoline that leaves the start.
struct IsoPoint {
  Vec3 point;
  Vec3 onward;  // derivative by the line's own parameter: away from the start
  Vec3 across;  // derivative by the number of the line
  Vec3 normal;  // unit; the same side all over the face
};

/// One line: `cross` is the parameter that stays, the other runs from `begin` to `end`, which may
/// descend.
struct Isoline {
  double cross = 0, begin = 0, end = 0;
};

class Isolines {
 public:
  /// The face must outlive this. Throws NoResultError if the start lies nowhere on the face.
  Isolines(const NurbsFace& face, const BlendStart& start);

  /// Comes back to its first line after the last one.
  bool closed() const { return closed_; }
  /// Range of `cross`.
  const Interval& range() const { return cross_; }
  const BlendStart& start() const { return start_; }

  /// The line with that value, if any of it lies on the face at the start.
  std::optional<Isoline> line(double cross) const;
  /// Lines at equal distances of arc length, where the start and some lines like it are longest:
  /// closed: spread evenly round; else from border to border. At most `spacing` apart, at least 8.
  std::vector<double> seeds(double spacing) const;

  IsoPoint at(double cross, double along) const;
  /// Whether that place lies on the face, inside its trimming curves.
  bool on_face(double cross, double along) const;

 private:
  double wrapped(double cross) const;

  const NurbsFace& face_;
  BlendStart start_;
  Interval along_, cross_;
  bool closed_ = false;
};

}  // namespace spigolo
