// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/own_sheet.h - the sheet that one point lies on, whatever else is near it
#pragma once

#include <span>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/index/neighborhoods.h"
#include "spigolo/index/spacing.h"
#include "spigolo/sheets/sheet.h"

namespace spigolo {

/// What the noise of the cloud means for everything that asks whether a point is on a sheet.
struct SheetTolerances {
  double noise = 0;        // [spacings] standard deviation across the surface
  std::size_t k = 20;      // neighbors a sheet is fitted to; grows with the noise
  std::size_t asked = 16;  // neighbors whose sheets may pass a point
  bool on_lines = false;   // scan lines: points crowd along them

  /// Noise too small to matter: each crease stands for itself.
  bool exact() const { return noise < 0.03; }
  double smooth() const;    // [spacings] a fit to all neighbors that deviates less is one sheet
  double plane() const;     // [spacings] points this close to a plane may share a sheet with it
  double on_sheet() const;  // [spacings] points this close to a fitted sheet lie on it
};

/// k is 20 without noise, up to 96 with much of it; more on scan lines (Spacing::on_lines), since
/// the 20 nearest lie on three of them.
SheetTolerances sheet_tolerances(double noise, double on_lines = 0);

/// The sheet through points[0], from its neighborhood (itself first). If one quadric fits all, that
/// one; else the plane through it and two neighbors that the most of them agree with, grown to the
/// quadric of all points that lie on it. `scratch` keeps its memory between calls.
Sheet find_own_sheet(std::span<const Vec3> points, double spacing,
                     const SheetTolerances& tolerances, std::vector<char>& scratch);

/// The second half of that: the sheet through points[0] where no one quadric fits them all.
Sheet find_part_sheet(std::span<const Vec3> points, double spacing,
                      const SheetTolerances& tolerances, std::vector<char>& scratch);

/// find_own_sheet for every point, with the first tolerances.k of its neighbors.
std::vector<Sheet> find_own_sheets(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
                                   const Spacing& spacing, const SheetTolerances& tolerances,
                                   const Job& job = {});

}  // namespace spigolo
