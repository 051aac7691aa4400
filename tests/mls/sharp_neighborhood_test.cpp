// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include "spigolo/mls/sharp_neighborhood.h"

#include <gtest/gtest.h>

#include "spigolo/core/error.h"
#include "spigolo/core/random.h"
#include "spigolo/synth/synth.h"
#include "support/clouds.h"

namespace spigolo {
namespace {

std::vector<PointKind> true_kinds(const SynthCloud& s) {
  std::vector<PointKind> kinds;
  for (const double k : s.cloud.find("truth_kind")->values)
    kinds.push_back(static_cast<PointKind>(static_cast<int>(k)));
  return kinds;
}

struct Prepared {
  SynthCloud synth;
  MlsCloud cloud;
  FeatureLineOptions options;
  FeatureMap features;

  explicit Prepared(SynthCloud&& s)
      : synth(std::move(s)),
        cloud(synth.cloud.points),
        options{settle({}, cloud.noise())},
        features(map_features(cloud, ordered_kinds(cloud.ordered(), true_kinds(synth)),
                              options.mls.k)) {}

  SurfacePoint sharp(const Vec3& query) const {
    FeatureLineScratch scratch;
    return project_feature_line(cloud, features, query, options, scratch);
  }
  SurfacePoint plain(const Vec3& query) const {
    MlsScratch scratch;
    return project_plain(cloud, query, options.mls, scratch);
  }
};

SynthCloud wedge(double angle) {
  SynthOptions options;
  options.shape = "wedge";
  options.angle = radians(angle);
  options.points = 4000;
  return make_cloud(options);
}

// rms distance to the surface of projected places within two spacings of the edge.
double near_edge_rms(const Prepared& p, bool sharp) {
  Random random(95);
  double squares = 0;
  int count = 0;
  for (std::size_t i = 0; i < p.synth.cloud.size(); ++i) {
    const Vec3 q = p.synth.cloud.points[i] + random.in_ball() * (0.3 * p.synth.spacing);
    const double to_edge = edge_distance(p.synth.shape, q) / p.synth.spacing;
    if (to_edge > 2 || to_edge < 0.4) continue;  // nearer by, (4.5) compares what is mostly chance
    if (border_distance(p.synth.shape, q) < 4 * p.synth.spacing) continue;
    const SurfacePoint s = sharp ? p.sharp(q) : p.plain(q);
    const double d = surface_distance(p.synth.shape, s.position) / p.synth.spacing;
    squares += d * d, ++count;
  }
  EXPECT_GT(count, 50);
  return std::sqrt(squares / count);
}

TEST(SharpNeighborhood, EdgesStaySharperThanByThePlainProjection) {
  for (const double angle : {60.0, 90.0, 120.0}) {
    SCOPED_TRACE(angle);
    const Prepared p(wedge(angle));
    EXPECT_LT(near_edge_rms(p, true), near_edge_rms(p, false));
  }
}

TEST(SharpNeighborhood, SamplesOnAStraightEdgeStayThere) {
  const Prepared p(wedge(90));
  const auto& truth = p.synth.cloud.find("truth_feature")->values;
  int creases = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Vec3& q = p.synth.cloud.points[i];
    if (truth[i] == 0 || border_distance(p.synth.shape, q) < 3 * p.synth.spacing) continue;
    const SurfacePoint s = p.sharp(q);
    EXPECT_EQ(s.status, SurfaceStatus::crease);
    EXPECT_LT(distance(s.position, q), 0.1 * p.synth.spacing);
    creases += s.status == SurfaceStatus::crease;
  }
  EXPECT_GT(creases, 20);
}

TEST(SharpNeighborhood, NormalsBesideTheEdgeAreThoseOfOneSheet) {
  const Prepared p(wedge(90));
  for (std::size_t i = 0; i < p.synth.cloud.size(); ++i) {
    const Vec3& q = p.synth.cloud.points[i];
    const double d = edge_distance(p.synth.shape, q) / p.synth.spacing;
    if (!(d > 0.5 && d < 1.5)) continue;
    if (border_distance(p.synth.shape, q) < 4 * p.synth.spacing) continue;
    const SurfacePoint s = p.sharp(q);
    // Along its normal, a point of a flat sheet does not leave the sheet's plane.
    const double up = surface_distance(p.synth.shape, s.position + s.normal * p.synth.spacing);
    EXPECT_GT(up, 0.95 * p.synth.spacing);
  }
}

TEST(SharpNeighborhood, WithoutFeaturesItIsThePlainProjection) {
  SynthOptions options;
  options.shape = "torus";
  options.points = 2000;
  const Prepared p(make_cloud(options));
  for (std::size_t i = 0; i < p.synth.cloud.size(); i += 17)
    EXPECT_EQ(p.sharp(p.synth.cloud.points[i]).position, p.plain(p.synth.cloud.points[i]).position);
}

TEST(SharpNeighborhood, AnyQueryGivesNumbers) {
  SynthOptions options;
  options.shape = "box";
  options.sampling = Sampling::random;
  options.points = 3000;
  options.noise = 0.2;
  const Prepared p(make_cloud(options));
  const double radius = p.synth.shape.radius;
  Random random(96);
  for (int i = 0; i < 2000; ++i) {
    const SurfacePoint s = p.sharp(random.in_ball() * (1.5 * radius));
    EXPECT_TRUE(is_finite(s.position) && is_finite(s.normal));
    EXPECT_NEAR(norm(s.normal), on_surface(s.status) ? 1 : 0, 1e-9);
  }
  EXPECT_EQ(p.sharp({1e9, 0, 0}).status, SurfaceStatus::too_far);
}

TEST(SharpNeighborhood, LabelsOfAnotherCloudAreRefused) {
  const MlsCloud cloud(test::random_square(100, 3));
  const std::vector<PointKind> fewer(99);
  EXPECT_THROW(map_features(cloud, fewer, 20), UsageError);
  EXPECT_THROW(ordered_kinds(cloud.ordered(), fewer), UsageError);
}

}  // namespace
}  // namespace spigolo
