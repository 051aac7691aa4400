// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mls/sharp.h - projection onto the local sheet model: smooth inside the sheets, exactly
// sharp where they cross. The successor of thesis §4.3; needs no feature line and no orientation.
#pragma once

#include <optional>
#include <span>

#include "spigolo/core/job.h"
#include "spigolo/mls/levin.h"
#include "spigolo/mls/surface_point.h"
#include "spigolo/sheets/sheet_probe.h"

namespace spigolo {

/// A cloud, its sheet model and the way to look at it. Built once; all queries are const and may
/// run on many threads, each with a probe of its own. May be moved, not copied.
class SharpSurface {
 public:
  /// options: 0 where a value is to follow from the noise. Throws NoResultError for fewer than nine
  /// different places or points that all lie on one line, UsageError for an option out of range.
  explicit SharpSurface(std::span<const Vec3> points, const MlsOptions& options = {},
                        const Job& job = {});
  /// Takes over a model that is there already.
  explicit SharpSurface(SheetModel&& model, const MlsOptions& options = {}, const Job& job = {});

  SharpSurface(SharpSurface&&) = default;
  SharpSurface& operator=(SharpSurface&&) = default;

  const SheetModel& model() const { return model_; }
  const Vec3& origin() const { return model_.prepared.cloud.origin; }
  const MlsOptions& options() const { return options_; }  // settled
  SheetProbe probe() const { return {model_, tree_, {options_.smoothing, options_.k}}; }

 private:
  SheetModel model_;
  KdTree tree_;  // views the model's points, whose memory moves along
  MlsOptions options_;
};

/// The surface point nearest to a query in input coordinates: foot on a sheet, or the point of a
/// crease or corner where the sheets end. Projecting it again leaves it within 0.02 spacings.
SurfacePoint project_sharp(const SharpSurface& surface, const Vec3& query, SheetProbe& probe);

/// The place of a crease nearest to a query in input coordinates: point, tangent, the two sheets'
/// normals, the angle, the corner that ends it if one is near. Nothing where no crease is within
/// three spacings.
std::optional<CreasePlace> find_crease_near(const SharpSurface& surface, const Vec3& query,
                                            SheetProbe& probe);

}  // namespace spigolo
