// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/separate_sides.cpp - on which sides of the others the data of each sheet lie
#include <algorithm>
#include <cmath>

#include "spigolo/sheets/separate.h"

namespace spigolo {
namespace {

constexpr double exact_noise = 0.02;  // [spacings] with less, fits are as exact as the data
// [spacings] A quadric is a little off far from its center, so a sample this close to a sheet does
// not say which side of it is surface: one that lies exactly on a crease may seem to be beyond it.
constexpr double exact_side = 0.05;
constexpr double little_bend = 0.85, undecided = 0.1;  // cosine of normals; of a half

}  // namespace

// Whether the foot of measured point t of n on sheet s is on its valid part. The point itself may
// be beyond its end by noise, and would then tell two sheets on top of each other apart.
bool SheetSeparator::is_above_surface(std::size_t s, std::size_t t, std::size_t n) const {
  const LocalSheets& sheets = r_->sheets;
  std::uint32_t above = 0, open = 0;
  for (std::size_t c = 0; c < sheets.count; ++c) {
    const double h = heights_[c * n + t] - heights_[s * n + t] * cosine_[s][c];
    if (h > 0) above |= 1U << c;
    if (std::abs(h) <= sheets.tolerance) open |= 1U << c;
  }
  return sheets.has_data(s, above, open);
}

void SheetSeparator::note_cosines() {
  std::array<Vec3, LocalSheets::most> normal;
  for (std::size_t s = 0; s < r_->sheets.count; ++s)
    normal[s] = normal_at(r_->sheets.sheet[s], r_->center);
  for (std::size_t s = 0; s < r_->sheets.count; ++s)
    for (std::size_t c = 0; c < r_->sheets.count; ++c) cosine_[s][c] = dot(normal[s], normal[c]);
}

// Over a crease with little bend noise carries many points, so there a sheet ends where the fewer
// of its points are.
void SheetSeparator::end_at_bends() {
  note_cosines();
  LocalSheets& sheets = r_->sheets;
  for (std::size_t s = 0; s < sheets.count; ++s) {
    for (std::size_t c = 0; c < sheets.count; ++c) {
      const auto above = static_cast<double>(sheets.share_above[s][c]);
      if (c == s || std::abs(cosine_[s][c]) < little_bend || std::abs(above - 0.5) < undecided)
        continue;
      std::uint64_t kept = 0;
      for (std::uint32_t pattern = 0; pattern < 64; ++pattern)
        if ((pattern >> c & 1U) == (above > 0.5 ? 1U : 0U)) kept |= std::uint64_t{1} << pattern;
      if (sheets.data_sides[s] & kept) sheets.data_sides[s] &= kept;
    }
  }
}

void SheetSeparator::note_sides() {
  std::array<std::array<std::uint16_t, 64>, LocalSheets::most> seen{};
  std::array<std::size_t, LocalSheets::most> total{};
  std::array<std::array<float, LocalSheets::most>, LocalSheets::most> sided{};
  const bool exact = model_.tolerances.noise < exact_noise;
  const double beside = exact ? std::max(exact_side, r_->sheets.tolerance) : r_->sheets.tolerance;
  r_->sheets.share_above = {};
  measure(r_->points);
  for (std::size_t t = 0; t < r_->points.size(); ++t) {
    if (r_->label[t] < 0) continue;
    const std::size_t s = static_cast<std::uint8_t>(r_->label[t]);
    std::uint32_t above = 0;
    bool clear = true;
    for (std::size_t c = 0; c < r_->sheets.count; ++c) {
      if (c == s) continue;
      const double h = heights_[c * r_->points.size() + t];
      const bool on_side = std::abs(h) > beside;
      clear &= on_side;
      if (h > 0) above |= 1U << c;
      if (!on_side) continue;
      sided[s][c] += 1;
      r_->sheets.share_above[s][c] += h > 0 ? 1.0F : 0.0F;
    }
    if (!clear) continue;
    ++seen[s][above];
    ++total[s];
  }
  for (std::size_t s = 0; s < r_->sheets.count; ++s)
    for (std::size_t c = 0; c < r_->sheets.count; ++c)
      r_->sheets.share_above[s][c] =
          sided[s][c] > 0 ? r_->sheets.share_above[s][c] / sided[s][c] : 0.5F;
  const double share = exact ? 0 : rare_;
  for (std::size_t s = 0; s < r_->sheets.count; ++s) {
    r_->sheets.data_sides[s] = total[s] == 0 ? ~std::uint64_t{0} : 0;
    for (std::uint32_t pattern = 0; pattern < 64; ++pattern)
      if (seen[s][pattern] > share * static_cast<double>(total[s]))
        r_->sheets.data_sides[s] |= std::uint64_t{1} << pattern;
  }
  if (!exact && rare_ > rare) end_at_bends();
}

}  // namespace spigolo
