// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo detect: what its file and its JSON promise, and what must not change the labels
#include <algorithm>
#include <numeric>

#include "apps/program.h"
#include "spigolo/io/cloud_file.h"
#include "support/clouds.h"

namespace spigolo::test {
namespace {

class Detect : public ProgramTest {
 protected:
  /// Labels of the cloud, by point.
  std::vector<double> kinds(const PointCloud& cloud, const std::string& name) const {
    const Outcome run =
        run_program({"detect", cloud_file(name + "_in.ply", cloud), "-o", path(name + ".ply")});
    EXPECT_EQ(run.status, 0) << run.err;
    return values_of(read_cloud(path(name + ".ply")), "scalar_kind");
  }
};

TEST_F(Detect, writesThePropertiesOfTheContractInOrderAndType) {
  PointCloud cube = small_cube();
  cube.set("scalar_kind", ScalarType::uint8, std::vector<double>(cube.size(), 7));
  cube.set("nx", ScalarType::float32, std::vector<double>(cube.size(), 0.5));
  cube.set("red", ScalarType::uint8, std::vector<double>(cube.size(), 1));
  cube.set("intensity", ScalarType::uint16, std::vector<double>(cube.size(), 40000));
  kinds(cube, "out");
  const std::string bytes = content_of(path("out.ply"));
  const std::string wanted =
      "property double x\nproperty double y\nproperty double z\nproperty uchar red\n"
      "property uchar green\nproperty uchar blue\nproperty float quality\n"
      "property float scalar_kind\nproperty float scalar_angle\nproperty float scalar_convex\n"
      "property float scalar_curve\nproperty double edge_x\nproperty double edge_y\n"
      "property double edge_z\nproperty float scalar_sheets\nproperty float direction_x\n"
      "property float direction_y\nproperty float direction_z\nproperty float nx\nproperty ushort "
      "intensity\nend_header\n";
  EXPECT_EQ(bytes.rfind("ply\nformat binary_little_endian 1.0\n", 0), 0u);
  EXPECT_NE(bytes.find("element vertex 10088\n" + wanted), std::string::npos)
      << bytes.substr(0, bytes.find("end_header"));
  const PointCloud out = read_cloud(path("out.ply"));
  EXPECT_EQ(out.points, cube.points);
  EXPECT_EQ(values_of(out, "intensity"), values_of(cube, "intensity"));
}

TEST_F(Detect, valuesKeepTheirRanges) {
  kinds(small_cube(), "out");
  const PointCloud out = read_cloud(path("out.ply"));
  const auto kind = values_of(out, "scalar_kind"), angle = values_of(out, "scalar_angle"),
             quality = values_of(out, "quality"), x = values_of(out, "edge_x");
  std::size_t features = 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const bool feature = kind[i] > 0;
    features += feature;
    EXPECT_EQ(quality[i] > 0, feature);
    EXPECT_LE(quality[i], 1);
    EXPECT_EQ(std::isnan(x[i]), !feature);
    EXPECT_TRUE(feature || angle[i] == 0);
    EXPECT_LE(angle[i], 180);
  }
  EXPECT_NEAR(static_cast<double>(features), 488, 25) << "points on the edges of the cube";
}

TEST_F(Detect, jsonHasTheKeysOfTheContract) {
  const std::string in = cloud_file("in.ply", small_cube());
  const Outcome run = run_program(
      {"detect", in, "-o", path("out.ply"), "--method", "gauss-map", "--threads", "2", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const Json json = run.json();
  for (const char* key : {"points", "spacing", "noise", "counts", "method", "parameters", "seconds",
                          "threads", "version", "warnings", "duplicates", "non_finite"})
    EXPECT_TRUE(json.contains(key)) << key;
  EXPECT_EQ(json["points"], 10088);
  EXPECT_EQ(json["method"], "gauss-map");
  EXPECT_EQ(json["threads"], 2);
  EXPECT_TRUE(json["warnings"].empty());
  for (const char* key : {"read", "index", "detect", "write", "total"})
    EXPECT_GE(json["seconds"][key], 0.0) << key;
  std::size_t sum = 0;
  for (const char* key : {"surface", "edge", "corner", "tip", "border"})
    sum += json["counts"][key].get<std::size_t>();
  EXPECT_EQ(sum, 10088u);
}

TEST_F(Detect, threadsDoNotChangeAByte) {
  const std::string in = cloud_file("in.ply", small_cube());
  std::string one;
  for (const char* threads : {"1", "2", "3", "8"}) {
    ASSERT_EQ(run_program({"detect", in, "-o", path("out.ply"), "--threads", threads}).status, 0);
    if (one.empty()) one = content_of(path("out.ply"));
    EXPECT_TRUE(content_of(path("out.ply")) == one) << threads;
  }
}

TEST_F(Detect, orderDoesNotChangeAVerdict) {
  const PointCloud cube = small_cube();
  std::vector<std::size_t> order(cube.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  order = shuffled(order, 5);
  PointCloud mixed;
  for (const std::size_t i : order) mixed.points.push_back(cube.points[i]);
  const auto straight = kinds(cube, "straight"), shuffle = kinds(mixed, "mixed");
  for (std::size_t i = 0; i < order.size(); ++i) ASSERT_EQ(shuffle[i], straight[order[i]]);
}

TEST_F(Detect, duplicatesShareTheLabelAndChangeNoOther) {
  const PointCloud cube = small_cube();
  PointCloud repeated = cube;
  const std::size_t n = cube.size();
  for (std::size_t i = 0; i < n; i += 3) repeated.points.push_back(cube.points[i]);
  const auto once = kinds(cube, "once"), twice = kinds(repeated, "twice");
  EXPECT_TRUE(std::equal(once.begin(), once.end(), twice.begin()));
  for (std::size_t i = 0; i < n; i += 3) ASSERT_EQ(twice[n + i / 3], once[i]);
}

TEST_F(Detect, pointsThatAreNotFiniteStayAndAreReported) {
  const PointCloud cube = small_cube();
  PointCloud holed = cube;
  const std::vector<std::size_t> places = {0, 17, 5000, 10000};
  for (const std::size_t at : places) {
    const Vec3 bad{not_a_number, at % 2 ? infinity : 0.0, -infinity};
    holed.points.insert(holed.points.begin() + static_cast<std::ptrdiff_t>(at), bad);
  }
  const std::string in = cloud_file("in.ply", holed);
  const Outcome run = run_program({"detect", in, "-o", path("out.ply"), "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.json()["non_finite"], 4);
  EXPECT_NE(run.json()["warnings"].dump().find("NaN or infinite"), std::string::npos);
  const PointCloud out = read_cloud(path("out.ply"));
  auto labels = values_of(out, "scalar_kind");
  ASSERT_EQ(labels.size(), holed.size());
  for (auto at = places.rbegin(); at != places.rend(); ++at) {
    EXPECT_EQ(labels[*at], 0);
    EXPECT_FALSE(is_finite(out.points[*at]));
    labels.erase(labels.begin() + static_cast<std::ptrdiff_t>(*at));
  }
  EXPECT_EQ(labels, kinds(cube, "whole"));
}

TEST_F(Detect, readsAndWritesPipes) {
  const PointCloud cube = small_cube();
  const std::string text = content_of(cloud_file("in.xyz", cube));
  const Outcome run = run_program({"detect", "-", "-o", "-"}, text);
  ASSERT_EQ(run.status, 0) << run.err;
  const PointCloud out = read_cloud(file("piped.ply", run.out));
  EXPECT_EQ(out.points, cube.points);
  EXPECT_EQ(values_of(out, "scalar_kind"), kinds(cube, "direct"));
  EXPECT_NE(run.err.find("10 088 points"), std::string::npos)
      << "the summary gives way: " << run.err;
  EXPECT_EQ(run_program({"detect", "-", "-o", "-", "--quiet"}, run.out).err, "");
}

TEST_F(Detect, mayReplaceItsInput) {
  const PointCloud cube = small_cube();
  const std::string in = cloud_file("in.ply", cube);
  ASSERT_EQ(run_program({"detect", in, "-o", in}).status, 0);
  EXPECT_EQ(read_cloud(in).points, cube.points);
  EXPECT_EQ(listing(), std::vector<std::string>{"in.ply"});
}

}  // namespace
}  // namespace spigolo::test
