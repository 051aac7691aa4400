// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// trace: networks of shapes whose curves are known, and what must not change them
#include "spigolo/trace/trace.h"

#include <map>

#include "spigolo/core/error.h"
#include "spigolo/core/random.h"
#include "support/clouds.h"
#include "trace/support.h"

namespace spigolo::test {
namespace {

struct Known {
  const char* shape;
  Sampling sampling;
  std::size_t curves, corners, lines, circles;
};

class KnownShape : public ::testing::TestWithParam<Known> {};

TEST_P(KnownShape, hasItsCurvesItsCornersAndItsLength) {
  const Known& known = GetParam();
  const Traced t = trace_shape(known.shape, known.sampling);
  const FeatureCurves& network = t.network();
  EXPECT_EQ(curves_of_kind(network, CurveKind::edge).size(), known.curves);
  EXPECT_EQ(network.corners.size(), known.corners);
  EXPECT_EQ(count_shape(network, CurveShape::line), known.lines);
  EXPECT_EQ(count_shape(network, CurveShape::circle), known.circles);
  EXPECT_NEAR(total_length(network), true_length(t.synth.shape), 1e-3 * true_length(t.synth.shape));
  EXPECT_LT(farthest_off(network, t.synth.shape), 0.1 * t.detection.spacing);
  std::map<int, int> wanted, found;
  for (const Corner& corner : t.synth.shape.corners) ++wanted[corner.valence];
  for (const FeatureCorner& corner : network.corners) ++found[corner.valence];
  EXPECT_EQ(found, wanted);
}

INSTANTIATE_TEST_SUITE_P(Shapes, KnownShape,
                         ::testing::Values(Known{"hole17k", Sampling::lattice, 14, 8, 12, 2},
                                           Known{"box", Sampling::lattice, 12, 8, 12, 0},
                                           Known{"box", Sampling::blue, 12, 8, 12, 0},
                                           Known{"l-prism", Sampling::lattice, 18, 12, 18, 0},
                                           Known{"l-prism", Sampling::blue, 18, 12, 18, 0},
                                           Known{"steps", Sampling::blue, 24, 16, 24, 0},
                                           Known{"slot", Sampling::blue, 24, 16, 23, 0},
                                           Known{"star", Sampling::blue, 30, 20, 30, 0},
                                           Known{"pyramid", Sampling::blue, 8, 5, 8, 0},
                                           Known{"boxhole", Sampling::blue, 14, 8, 12, 2},
                                           Known{"l-prism", Sampling::random, 18, 12, 18, 0},
                                           Known{"box", Sampling::random, 12, 8, 12, 0},
                                           Known{"star", Sampling::random, 30, 20, 30, 0},
                                           Known{"pyramid", Sampling::random, 8, 5, 8, 0},
                                           Known{"hole17k", Sampling::random, 14, 8, 12, 2},
                                           Known{"steps", Sampling::random, 24, 16, 24, 0},
                                           Known{"boxhole", Sampling::random, 14, 8, 12, 2},
                                           Known{"cylinder", Sampling::random, 2, 0, 0, 2},
                                           Known{"cone", Sampling::random, 1, 0, 0, 1},
                                           Known{"cylinder", Sampling::blue, 2, 0, 0, 2},
                                           Known{"cone", Sampling::blue, 1, 0, 0, 1},
                                           Known{"lens", Sampling::blue, 1, 0, 0, 1}),
                         [](const auto& one) {
                           std::string name = one.param.shape;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name + (one.param.sampling == Sampling::lattice  ? "_lattice"
                                          : one.param.sampling == Sampling::random ? "_random"
                                                                                   : "_blue");
                         });

TEST(Trace, theRimOfAHoleIsItsCircle) {
  const Traced t = trace_shape("hole17k", Sampling::lattice);
  const Curve& rim = t.synth.shape.creases.back().curve;
  const double hole_radius = distance(rim.at(0), rim.at(0.5)) / 2;
  for (const FeatureCurve& curve : t.network().curves) {
    if (curve.shape != CurveShape::circle) continue;
    EXPECT_TRUE(curve.closed);
    EXPECT_NEAR(curve.radius, hole_radius, 1e-3 * hole_radius);
    EXPECT_NEAR(std::abs(curve.axis.z), 1, 1e-6);
  }
}

TEST(Trace, crossingCylindersMeetInClosedCurvesWithoutCorners) {
  const Traced t = trace_shape("cylinders", Sampling::blue);
  EXPECT_EQ(t.network().corners.size(), 0u);
  EXPECT_EQ(t.network().curves.size(), 6u);
  for (const FeatureCurve& curve : t.network().curves) EXPECT_TRUE(curve.closed);
  EXPECT_EQ(count_shape(t.network(), CurveShape::circle), 4u);
}

// Standard deviation .25 of the distance between samples.
TEST(Trace, noiseMovesTheCurvesLessThanThePoints) {
  for (const char* shape : {"box", "boxhole"}) {
    const Traced t = trace_shape(shape, Sampling::blue, 0, 0.25);
    const FeatureCurves& network = t.network();
    EXPECT_EQ(network.corners.size(), 8u) << shape;
    EXPECT_EQ(network.curves.size(), t.synth.shape.creases.size()) << shape;
    double sum = 0;
    std::size_t count = 0;
    for (const FeatureCurve& curve : network.curves)
      for (const Vec3& p : curve.points) sum += edge_distance(t.synth.shape, p), ++count;
    EXPECT_LT(sum / static_cast<double>(count), 0.4 * 0.25 * t.synth.spacing) << shape;
  }
}

// Ends stray there before they run past their corner, or stop beside it.
TEST(Trace, noiseLeavesThreeEdgesToEachCornerOfABox) {
  for (const Sampling sampling : {Sampling::lattice, Sampling::blue, Sampling::random}) {
    const Traced t = trace_shape("box", sampling, 0, 0.25);
    EXPECT_EQ(t.network().curves.size(), 12u);
    ASSERT_EQ(t.network().corners.size(), 8u);
    for (const FeatureCorner& corner : t.network().corners) EXPECT_EQ(corner.valence, 3);
  }
}

TEST(Trace, smoothShapesHaveNoCurves) {
  for (const char* shape : {"sphere", "torus", "fillet-box"})
    EXPECT_TRUE(trace_shape(shape, Sampling::blue).network().curves.empty()) << shape;
}

// An open patch has borders and no edges.
TEST(Trace, bordersAreCurvesOfTheirOwnKind) {
  const Traced t = trace_shape("dome", Sampling::blue);
  EXPECT_TRUE(curves_of_kind(t.network(), CurveKind::edge).empty());
  const auto borders = curves_of_kind(t.network(), CurveKind::border);
  ASSERT_EQ(borders.size(), 1u);
  EXPECT_TRUE(borders[0].closed);
  double most = 0;
  for (const Vec3& p : borders[0].points) most = std::max(most, border_distance(t.synth.shape, p));
  EXPECT_LT(most, 1.5 * t.detection.spacing);
}

TEST(Trace, aCloudOfPureNoiseIsNoHairball) {
  Random random(5);
  std::vector<Vec3> points(5000);
  for (Vec3& p : points) p = random.in_ball();
  Detection seen;
  const TracedFeatures traced = trace_cloud(points, &seen);
  EXPECT_LT(total_length(traced.network), 0.05 * 5000 * seen.spacing);
}

TEST(Trace, noFeaturesAreAnEmptyNetwork) {
  const std::vector<Vec3> points = square_lattice(10);
  Features features;
  features.assign_surface(points.size());
  TraceOptions options;
  options.spacing = 1;
  const TracedFeatures traced = trace_features(points, features, options);
  EXPECT_TRUE(traced.network.curves.empty());
  EXPECT_TRUE(traced.network.corners.empty());
  EXPECT_EQ(traced.curve_of_point, std::vector<std::int32_t>(100, -1));
}

TEST(Trace, labelsOfPlacesThatAreNoneAreLeftOut) {
  std::vector<Vec3> points = square_lattice(10);
  Features features;
  features.assign_surface(points.size());
  for (std::size_t i = 0; i < 10; ++i) {
    features.kind[i] = PointKind::edge;
    features.strength[i] = 1;
    features.crease_point[i] = points[i];
  }
  points[3].x = not_a_number;
  points[5].z = infinity;
  TraceOptions options;
  options.spacing = 1;
  const TracedFeatures traced = trace_features(points, features, options);
  validate(traced.network);
  EXPECT_EQ(traced.curve_of_point.size(), points.size());
}

TEST(Trace, refusesWhatDoesNotFit) {
  const std::vector<Vec3> points = square_lattice(10);
  Features features;
  features.assign_surface(99);
  TraceOptions options;
  options.spacing = 1;
  EXPECT_THROW(trace_features(points, features, options), UsageError);
  features.assign_surface(100);
  options.spacing = 0;
  EXPECT_THROW(trace_features(points, features, options), UsageError);
  options.spacing = 1;
  options.tolerance = 0;
  EXPECT_THROW(trace_features(points, features, options), UsageError);
}

struct Summary {
  std::size_t curves, corners, lines;
  double length;
};
Summary summary_of(const FeatureCurves& network) {
  return {network.curves.size(), network.corners.size(), count_shape(network, CurveShape::line),
          total_length(network)};
}

TEST(Trace, movingTurningScalingAndReorderingChangeNothing) {
  SynthOptions options;
  options.shape = "boxhole";
  options.points = 6000;
  const std::vector<Vec3> points = make_cloud(options).cloud.points;
  const Summary plain = summary_of(trace_cloud(points).network);
  EXPECT_EQ(plain.curves, 14u);
  std::vector<Vec3> other = shuffled(points, 3);
  const Vec3 x = normalized(Vec3{1, 2, 3}), y = normalized(cross(x, Vec3{0, 0, 1}));
  for (Vec3& p : other) p = (x * p.x + y * p.y + cross(x, y) * p.z) * 100.0 + Vec3{5e3, -2e3, 1e3};
  const Summary moved = summary_of(trace_cloud(other).network);
  EXPECT_EQ(moved.curves, plain.curves);
  EXPECT_EQ(moved.corners, plain.corners);
  EXPECT_EQ(moved.lines, plain.lines);
  EXPECT_NEAR(moved.length / 100, plain.length, 1e-4 * plain.length);
}

TEST(Trace, theOrderOfTheInputAndTheThreadsChangeNoBit) {
  SynthOptions options;
  options.shape = "star";
  options.points = 5000;
  const std::vector<Vec3> points = make_cloud(options).cloud.points;
  const Detection detection = detect(points);
  TraceOptions trace;
  trace.spacing = detection.spacing;
  trace.noise = detection.noise;
  Job one;
  one.threads = 1;
  const FeatureCurves a = trace_features(points, detection.features, trace).network;
  const FeatureCurves b = trace_features(points, detection.features, trace, one).network;
  ASSERT_EQ(a.curves.size(), b.curves.size());
  for (std::size_t c = 0; c < a.curves.size(); ++c)
    EXPECT_EQ(a.curves[c].points, b.curves[c].points);
  const FeatureCurves s = trace_cloud(shuffled(points, 9)).network;
  ASSERT_EQ(a.curves.size(), s.curves.size());
  for (std::size_t c = 0; c < a.curves.size(); ++c)
    EXPECT_EQ(a.curves[c].points, s.curves[c].points);
}

TEST(Trace, pointsLearnTheirCurve) {
  const Traced t = trace_shape("box", Sampling::blue);
  std::size_t features = 0, named = 0;
  for (std::size_t i = 0; i < t.detection.features.size(); ++i) {
    if (t.detection.features.kind[i] != PointKind::edge) continue;
    ++features;
    const std::int32_t curve = t.traced.curve_of_point[i];
    if (curve < 0) continue;
    ++named;
    ASSERT_LT(static_cast<std::size_t>(curve), t.network().curves.size());
  }
  EXPECT_GT(static_cast<double>(named), 0.98 * static_cast<double>(features));
}

// A straight edge whose samples leave out `gap` spacings in the middle; with or without a sheet
// that goes on beside it.
FeatureCurves edge_with_gap(double gap, bool sheet = true) {
  constexpr std::size_t marks = 40;
  std::vector<Vec3> points;
  for (int i = 0; i < 40; ++i) points.push_back({i < 20 ? i : i - 1 + gap, 0, 0});
  for (double x = 0.5; x < 38 + gap && sheet; ++x)
    for (const double y : {-1.0, 1.0}) points.push_back({x, y, 0});
  Features features;
  features.assign_surface(points.size());
  for (std::size_t i = 0; i < marks; ++i) {
    features.kind[i] = PointKind::edge;
    features.angle[i] = features.strength[i] = 1;
    features.crease_point[i] = points[i];
    features.direction[i] = {1, 0, 0};
  }
  TraceOptions options;
  options.spacing = 1;
  return trace_features(points, features, options).network;
}

TEST(Trace, wideGapsAreBridgedAndMarked) {
  const FeatureCurves narrow = edge_with_gap(3), wide = edge_with_gap(8), far = edge_with_gap(40);
  ASSERT_EQ(narrow.curves.size(), 1u);
  EXPECT_FALSE(narrow.curves[0].bridged);
  ASSERT_EQ(wide.curves.size(), 1u);
  EXPECT_TRUE(wide.curves[0].bridged);
  EXPECT_NEAR(wide.curves[0].length(), 46, 1e-6);
  EXPECT_LT(wide.curves[0].confidence, 0.95);
  EXPECT_EQ(far.curves.size(), 2u);
  EXPECT_EQ(edge_with_gap(8, false).curves.size(), 2u);  // there may be nothing
}

// Labels that never came from a detector: many short straight edges far apart.
TEST(Trace, thousandsOfShortCurvesTakeNoTime) {
  constexpr std::size_t curves = 10000, samples = 8;
  std::vector<Vec3> points;
  for (std::size_t c = 0; c < curves; ++c) {
    const auto column = static_cast<double>(c % 100), row = static_cast<double>(c / 100);
    for (std::size_t i = 0; i < samples; ++i)
      points.push_back({20 * column + static_cast<double>(i), 20 * row, 0});
  }
  Features features;
  features.assign_surface(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    features.kind[i] = PointKind::edge;
    features.angle[i] = 1;
    features.strength[i] = 1;
    features.crease_point[i] = points[i];
    features.direction[i] = {1, 0, 0};
  }
  TraceOptions options;
  options.spacing = 1;
  const TracedFeatures traced = trace_features(points, features, options);
  EXPECT_EQ(traced.network.curves.size(), curves);
  EXPECT_NEAR(total_length(traced.network), 7.0 * curves, 1);
}

}  // namespace
}  // namespace spigolo::test
