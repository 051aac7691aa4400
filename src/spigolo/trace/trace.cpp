// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/trace.cpp - one layer of edges, one of borders, in the units of the input
#include "spigolo/trace/trace.h"

#include <algorithm>
#include <cmath>

#include "spigolo/core/error.h"
#include "spigolo/trace/layers.h"
#include "spigolo/trace/place_grid.h"

namespace spigolo {
namespace {

constexpr double border_scatter = 0.3;  // [spacings] border samples lie off the border that far
constexpr double exact_scatter = 0.03;  // [spacings] with less, samples lie on the crease

ShapeTolerances tolerances_for(const TraceOptions& options, double scatter) {
  ShapeTolerances t;
  t.shape = 0.03 + 1.6 * scatter;
  t.spline = options.tolerance == automatic_tolerance ? 0.01 + 0.3 * scatter
                                                      : options.tolerance / options.spacing;
  t.window = 3 + 18 * scatter;
  return t;
}

// The nearest curve within reach of each feature point's place on the crease.
std::vector<std::int32_t> curves_of_points(const Features& features, const FeatureCurves& network,
                                           const CreaseSamples& samples, double reach) {
  std::vector<Vec3> places;
  std::vector<std::int32_t> owner;
  for (std::size_t c = 0; c < network.curves.size(); ++c)
    for (const Vec3& p : network.curves[c].points) {
      places.push_back(p);
      owner.push_back(static_cast<std::int32_t>(c));
    }
  const PlaceGrid grid(places, reach);
  std::vector<std::int32_t> curve_of(features.size(), -1);
  for (std::size_t i = 0; i < features.size(); ++i) {
    if (!is_finite(features.crease_point[i])) continue;
    const std::uint32_t near = grid.nearest(samples.inside(features.crease_point[i]), reach);
    if (near != PlaceGrid::no_place) curve_of[i] = owner[near];
  }
  return curve_of;
}

void to_input_units(const CreaseSamples& samples, FeatureCurves& network) {
  for (FeatureCorner& corner : network.corners) corner.position = samples.outside(corner.position);
  for (FeatureCurve& curve : network.curves) {
    for (Vec3& p : curve.points) p = samples.outside(p);
    for (Vec3& p : curve.spline.poles) p = samples.outside(p);
    for (double& k : curve.spline.knots) k *= samples.unit;
    curve.center = samples.outside(curve.center);
    curve.radius *= samples.unit;
    curve.residual *= samples.unit;
  }
}

void check(std::span<const Vec3> points, const Features& features, const TraceOptions& o) {
  if (points.size() != features.size()) throw UsageError("points and features differ in number");
  if (!(o.spacing > 0)) throw UsageError("the spacing must be above 0");
  if (!(o.noise >= 0 && o.scatter >= 0)) throw UsageError("noise and scatter are 0 or more");
  if (o.tolerance != automatic_tolerance && !(o.tolerance > 0))
    throw UsageError("the tolerance must be above 0");
}

}  // namespace

TracedFeatures trace_features(std::span<const Vec3> points, const Features& features,
                              const TraceOptions& options, const Job& job) {
  check(points, features, options);
  TracedFeatures result;
  const double scatter = std::max(options.noise, options.scatter);
  const CreaseSamples samples = gather_samples(points, features, options.spacing, scatter, job);
  const ShapeTolerances tolerances = tolerances_for(options, scatter);
  if (!samples.marks.empty()) {
    const Survey survey(points, samples, options.noise, job);
    const Layer edges{CurveKind::edge, samples.edges, scatter, tolerances};
    if (!samples.edges.empty()) trace_edges(edges, survey, samples.corners, job, result.network);
    if (scatter < exact_scatter) trace_rims(edges, samples.marks, survey, job, result.network);
  }
  const double wide = std::max(scatter, border_scatter);
  trace_borders({CurveKind::border, samples.borders, wide, tolerances_for(options, wide)}, job,
                result.network);
  result.curve_of_point = curves_of_points(features, result.network, samples, 2 + 2 * scatter);
  to_input_units(samples, result.network);
  result.tolerance = tolerances.spline * options.spacing;
  return result;
}

}  // namespace spigolo
