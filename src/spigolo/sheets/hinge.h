// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/hinge.h - with noise: is a neighborhood one smooth sheet, folded, or bent?
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/core/geometry.h"
#include "spigolo/sheets/fold_sums.h"

namespace spigolo {

/// What explains the points of a neighborhood, as heights over their plane.
enum class Fold : std::uint8_t {
  none,     // one quadric does
  edge,     // a quadric folded along a line does better than chance allows
  bend,     // a rounded fold does better than a sharp one
  unclear,  // nothing of that fits
};

struct Hinge {
  Fold fold = Fold::none;
  // Of an edge; as of Crease and RoofTest::Roof.
  Vec3 point;      // of the fold, nearest to the first point
  Vec3 direction;  // unit, along the fold
  std::array<Vec3, 2> into{};
  double deviation = 0;  // [rad] from flat
};

/// Likelihood tests with the noise known: a quadric over the plane of the points against the same
/// quadric folded along a line, a sharp fold against rounded ones. All points count, so the wider
/// the neighborhood the smaller the fold that stands out: by the fourth power of its radius. Meant
/// for folds of up to about 100 degrees from flat, whose points have one height over their plane.
/// Keeps its memory between calls: one for each thread.
class HingeTest {
 public:
  explicit HingeTest(double noise) : noise_(noise) {}  // [spacings], above 0

  /// points: a round neighborhood, the place asked about first; with fewer than 16 none.
  Hinge find(std::span<const Vec3> points, double spacing);

 private:
  static constexpr std::size_t terms = 6;
  using Terms = std::array<double, terms>;

  struct Line {
    double angle = 0, offset = 0;  // of its normal in the plane; [spacings] from the first point
    double gain = 0;               // of squared residuals
  };
  struct Gain {
    double squares = 0, slope = 0;  // gained, and height per unit of the fold
    Terms shared{};                 // of the fold with the basis
  };

  void set_frame(std::span<const Vec3> points, double spacing);
  bool set_basis();
  void fill_bins();
  Line coarse(double roundness);
  static Gain gain_of(const FoldRow& sums);
  Gain gain_of(const Line& line, double roundness);
  Line refined(Line line, double roundness);
  static double angle_of(std::size_t a);
  Hinge place(const Line& line, const Gain& fold, const Vec3& origin, double spacing) const;

  double noise_;
  std::size_t n_ = 0;
  double radius_ = 0, rest_squares_ = 0;
  Vec3 u_, v_, normal_;
  // The points in that frame, in spacings; columns of the orthonormal basis; what it leaves of w.
  std::vector<double> x_, y_, w_, basis_, rest_;
  std::array<Terms, terms> upper_{};  // quadric terms = basis times this
  Terms fitted_{};                    // of w in the basis
  std::vector<FoldRow> rows_;         // 1, rest, basis of each point
  static constexpr std::size_t angles = 8, bins = 48;
  std::array<std::array<FoldRow, bins>, angles> binned_{};  // by distance along each angle
  double bin_width_ = 1;
  std::vector<std::uint32_t> bin_;
  std::vector<double> heights_;  // of folds
};

}  // namespace spigolo
