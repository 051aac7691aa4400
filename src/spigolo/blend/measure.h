// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/measure.h - how good a collar is: its borders, its smoothness, its density
#pragma once

#include <functional>
#include <span>

#include "spigolo/blend/cloud_side.h"
#include "spigolo/blend/strand.h"

namespace spigolo {

struct MeanMax {
  double mean = 0, max = 0;

  void add(double value) {
    sum_ += value;
    ++count_;
    mean = sum_ / static_cast<double>(count_);
    max = value > max ? value : max;
  }

 private:
  double sum_ = 0;
  std::size_t count_ = 0;
};

struct CollarQuality {
  MeanMax face_error;   // [rad] of the MLS normal of all at the alphas, from that of the face
  MeanMax cloud_error;  // [rad] at the betas, from the normal of the cloud's own MLS surface
  MeanMax turn;         // [rad] of the MLS normal over one spacing, at most along each profile
  double ripple = 0;  // [spacings] rms of the MLS surface's waves along the collar, shorter than 8
  double gap = 0;     // [spacings] from a place of the collar to the nearest point, at most
  double nearest_cv = 0, nearest_min = 0;  // spread and least, in spacings, of the distance of
                                           // collar points to their nearest point
};

/// The collar as a surface: row in [0, strands], share in [0, 1] from alpha to beta.
using CollarPlace = std::function<Vec3(double row, double share)>;

/// points: all of the blend near the collar, those of the collar itself first. Relative to the
/// cloud's origin. cloud: of before the blend; its options are used for all.
CollarQuality measure_collar(std::span<const Vec3> points, std::size_t collar_points,
                             const BorderLoop& loop, const CollarPlace& place,
                             const CloudSide& cloud, const Job& job);

}  // namespace spigolo
