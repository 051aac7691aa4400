// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/sheet_probe.h - looks at the sheet model of a cloud at any place
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/index/kd_tree.h"
#include "spigolo/sheets/local_sheets.h"
#include "spigolo/sheets/sheet_model.h"

namespace spigolo {

/// How far a look reaches; both grow with the noise.
struct ProbeReach {
  double smoothing = 1.3;  // [spacings] h of the weight exp(-d^2/h^2) around the place
  std::size_t k = 32;      // points looked at, the nearest ones
};

ProbeReach probe_reach(double noise);

/// Points within three h or so of a place: what a look with that smoothing needs.
std::size_t points_for(double smoothing);

/// Keeps its memory between looks: one for each thread. The model and the tree must outlive it.
class SheetProbe {
 public:
  SheetProbe(const SheetModel& model, const KdTree& tree, const ProbeReach& reach);

  /// The sheets near `center` (relative to the cloud's origin), fitted with weights around it.
  /// Valid until the next look. count is 0 where there is no data to fit anything to.
  const LocalSheets& look(const Vec3& center);

  std::span<const Neighbor> neighbors() const { return found_; }  // of the last look
  double spacing() const { return spacing_; }                     // at the last place

 private:
  void gather(const Vec3& center, std::size_t k);
  void fit_single(const Vec3& center, double smoothing);
  void fit_several(const Vec3& center, double smoothing);
  void seed();
  void assign();
  void fit(const Vec3& center, double smoothing);
  Sheet fit_labelled(std::size_t s, std::size_t also, const Vec3& center, double smoothing);
  bool merge(const Vec3& center, double smoothing);
  void note_sides();
  bool too_wide() const;

  const SheetModel& model_;
  const KdTree& tree_;
  ProbeReach reach_;
  LocalSheets sheets_;
  double spacing_ = 1;
  std::vector<Neighbor> found_;
  std::vector<Vec3> points_;
  std::vector<std::int8_t> label_;  // sheet of each point, -1: none
  std::vector<double> weights_;
};

}  // namespace spigolo
