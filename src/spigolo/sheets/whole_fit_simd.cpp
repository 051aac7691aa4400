// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/whole_fit_simd.cpp - compiled once per instruction set, chosen at run time
#include "spigolo/sheets/whole_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spigolo/sheets/whole_fit_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "spigolo/sheets/lanes-inl.h"

namespace spigolo {
Sheet fit_alone(const WholeFits& fits, std::size_t i, std::vector<Vec3>& around);
}

HWY_BEFORE_NAMESPACE();
namespace spigolo {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Neighborhoods of as many points as there are lanes: offsets from the point, and those in
// spacings, row t for neighbor t of every lane.
struct Batch {
  std::vector<double> offset, scaled;  // three rows of lanes a neighbor
  std::array<double, max_lanes> spacing{};
  std::size_t size = 0;  // neighbors, the point itself first

  void load(const WholeFits& fits, std::size_t begin, std::size_t end, std::size_t lanes) {
    size = fits.k + 1;
    offset.resize(3 * lanes * size);
    scaled.resize(3 * lanes * size);
    for (std::size_t l = 0; l < lanes; ++l) {
      const std::size_t i = std::min(begin + l, end - 1);
      const Vec3 origin = fits.points[i];
      const auto row = fits.neighborhoods.of(i);
      spacing[l] = fits.spacing.of_point[i];
      double* to = offset.data() + l;
      to[0] = to[lanes] = to[2 * lanes] = 0;
      for (std::size_t t = 0; t < fits.k; ++t) {
        const Vec3 d = fits.points[row[t]] - origin;
        to += 3 * lanes;
        to[0] = d.x, to[lanes] = d.y, to[2 * lanes] = d.z;
      }
    }
  }
};

Lanes3 row(const std::vector<double>& rows, std::size_t t) {
  const LaneTag d;
  const double* at = rows.data() + 3 * t * hn::Lanes(d);
  return {hn::LoadU(d, at), hn::LoadU(d, at + hn::Lanes(d)), hn::LoadU(d, at + 2 * hn::Lanes(d))};
}

// Frame with n across the direction of least spread; scales the offsets on the way.
Frame fit_frames(Batch& batch) {
  const LaneTag d;
  const auto spacing = hn::LoadU(d, batch.spacing.data());
  Lanes3 mean = zero3();
  for (std::size_t t = 0; t < batch.size; ++t) mean = add(mean, row(batch.offset, t));
  mean = divide(mean, hn::Set(d, static_cast<double>(batch.size)));
  LaneScatter scatter = {hn::Zero(d), hn::Zero(d), hn::Zero(d),
                         hn::Zero(d), hn::Zero(d), hn::Zero(d)};
  for (std::size_t t = 0; t < batch.size; ++t) {
    const Lanes3 offset = row(batch.offset, t);
    scatter.add_outer(divide(subtract(offset, mean), spacing));
    const Lanes3 scaled = divide(offset, spacing);
    double* at = batch.scaled.data() + 3 * t * hn::Lanes(d);
    hn::StoreU(scaled.x, d, at);
    hn::StoreU(scaled.y, d, at + hn::Lanes(d));
    hn::StoreU(scaled.z, d, at + 2 * hn::Lanes(d));
  }
  return frame_across(scatter);
}

Coefficients fit_quadrics(const Batch& batch, Frame& frame) {
  NormalEquations equations;
  for (std::size_t t = 0; t < batch.size; ++t) {
    const Lanes3 p = row(batch.scaled, t);
    equations.add(dot(p, frame.u), dot(p, frame.v), dot(p, frame.n));
  }
  return equations.solve(frame.sound);
}

LaneVec deviations(const Batch& batch, const Frame& frame, const Coefficients& a) {
  const LaneTag d;
  auto squares = hn::Zero(d);
  for (std::size_t t = 0; t < batch.size; ++t) {
    const Lanes3 p = row(batch.scaled, t);
    const auto h = height(a, dot(p, frame.u), dot(p, frame.v), dot(p, frame.n));
    squares = hn::Add(squares, hn::Mul(h, h));
  }
  const double freedom = static_cast<double>(batch.size) - 6;
  return hn::Sqrt(hn::Div(squares, hn::Set(d, freedom)));
}

void store(const Lanes3& v, Sheet* out, std::size_t n, Vec3 Sheet::*member) {
  const LaneTag d;
  HWY_ALIGN double x[max_lanes] = {}, y[max_lanes] = {}, z[max_lanes] = {};
  hn::Store(v.x, d, x);
  hn::Store(v.y, d, y);
  hn::Store(v.z, d, z);
  for (std::size_t l = 0; l < n; ++l) out[l].*member = {x[l], y[l], z[l]};
}

void fit_batch(const WholeFits& fits, std::size_t begin, std::size_t end, Batch& batch,
               Sheet* out) {
  const LaneTag d;
  const std::size_t lanes = hn::Lanes(d), n = std::min(lanes, end - begin);
  batch.load(fits, begin, end, lanes);
  Frame frame = fit_frames(batch);
  const Coefficients a = fit_quadrics(batch, frame);
  HWY_ALIGN double value[max_lanes] = {};
  for (std::size_t l = 0; l < n; ++l) {
    out[l].origin = fits.points[begin + l];
    out[l].spacing = batch.spacing[l];
    out[l].support = static_cast<int>(batch.size);
  }
  store(frame.u, out, n, &Sheet::u);
  store(frame.v, out, n, &Sheet::v);
  store(frame.n, out, n, &Sheet::n);
  for (std::size_t c = 0; c < 6; ++c) {
    hn::Store(a[c], d, value);
    for (std::size_t l = 0; l < n; ++l) out[l].a[c] = value[l];
  }
  hn::Store(deviations(batch, frame, a), d, value);
  for (std::size_t l = 0; l < n; ++l) out[l].deviation = value[l];
  // What a lane cannot do, a plane or an axis that is not unique, is done alone.
  if (hn::AllTrue(d, frame.sound)) return;
  hn::Store(hn::IfThenElse(frame.sound, hn::Set(d, 1.0), hn::Zero(d)), d, value);
  std::vector<Vec3> around;
  for (std::size_t l = 0; l < n; ++l)
    if (value[l] == 0) out[l] = fit_alone(fits, begin + l, around);
}

void fit_range(const WholeFits& fits, std::size_t begin, std::size_t end, Sheet* out) {
  const std::size_t lanes = hn::Lanes(LaneTag());
  Batch batch;
  for (std::size_t i = begin; i < end; i += lanes, out += lanes)
    fit_batch(fits, i, end, batch, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace spigolo
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace spigolo {

HWY_EXPORT(fit_range);

Sheet fit_alone(const WholeFits& fits, std::size_t i, std::vector<Vec3>& around) {
  around.assign(1, fits.points[i]);
  for (const std::uint32_t j : fits.neighborhoods.of(i).first(fits.k))
    around.push_back(fits.points[j]);
  return fit_sheet(around, {}, fits.spacing.of_point[i], SheetOrder::quadric);
}

void fit_whole_sheets(const WholeFits& fits, std::size_t begin, std::size_t end, Sheet* out) {
  if (begin >= end) return;
  if (fits.k + 1 >= static_cast<std::size_t>(quadric_points)) {
    HWY_DYNAMIC_DISPATCH(fit_range)(fits, begin, end, out);
    return;
  }
  std::vector<Vec3> around;
  for (std::size_t i = begin; i < end; ++i) out[i - begin] = fit_alone(fits, i, around);
}

}  // namespace spigolo
#endif  // HWY_ONCE
