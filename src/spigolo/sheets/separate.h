// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/separate.h - which sheets pass by a place, and which point lies on which
#pragma once

#include <array>
#include <span>
#include <vector>

#include "spigolo/sheets/seeds.h"
#include "spigolo/sheets/sheet_model.h"
#include "spigolo/sheets/sheet_region.h"

namespace spigolo {

/// Share of the weight that draws curvature to zero in all fits of that noise [spacings].
double fit_ridge(double noise);

/// Leaves the nearer half of the points and narrows the weights; false, and nothing is done, where
/// too few would be left.
bool halve(SheetRegion& region);

/// Fills label and sheets of a region whose points are known. Keeps its memory between regions: one
/// for each thread. The model must outlive it.
class SheetSeparator {
 public:
  /// noise: [spacings] of points about their sheet; 0: as the model has it.
  explicit SheetSeparator(const SheetModel& model, double noise = 0);

  /// Seeks the sheets among the own sheets of the region's points. join: with noise, two that one
  /// quadric explains about as well become one. Tells whether any did.
  bool separate(SheetRegion& region, bool join = true);
  /// Starts from sheets that were found elsewhere: each point to the nearest one, fitted again,
  /// some rounds of it. join: as above.
  void start_from(const LocalSheets& sheets, SheetRegion& region, int rounds, bool join = false);
  /// All points on one sheet.
  void take_one(SheetRegion& region);

  /// How badly the region's sheets explain its points: squared residuals in standard deviations,
  /// cut off, and a price for each coefficient. Smaller is better. stride: looks at each stride-th.
  double score(SheetRegion& region, std::size_t stride = 1);
  /// With noise: too much for one quadric a sheet.
  bool fits_badly(const LocalSheets& sheets) const;
  /// Labels the points by the region's sheets as they are.
  void label(SheetRegion& region);

 private:
  bool settle(int rounds, bool join);
  void assign();
  struct Membership {
    int sheet = -1;   // whose valid part is nearest
    double cost = 0;  // [squared spacings]
  };
  void measure(std::span<const Vec3> points);
  Membership membership(std::size_t t, std::size_t n) const;
  bool is_above_surface(std::size_t s, std::size_t t, std::size_t n) const;
  double badness(std::size_t t, std::size_t n) const;
  void note_cosines();
  void end_at_bends();
  void fit();
  Sheet fit_labelled(std::size_t s, std::size_t also);
  bool merge();
  void note_sides();

  const SheetModel& model_;
  SheetSeeder seeder_;
  double unit_;  // [spacings] standard deviation of a point that lies on a sheet
  static constexpr double rare = 0.04, rare_at_places = 0.1;
  double rare_;  // share of a noisy sheet's points that may have strayed over a crease
  SheetRegion* r_ = nullptr;
  std::vector<Vec3> looked_at_;
  std::vector<double> weights_, heights_;
  std::array<std::array<double, LocalSheets::most>, LocalSheets::most> cosine_{};  // of normals
};

}  // namespace spigolo
