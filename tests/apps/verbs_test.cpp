// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// info, convert, synth, render and compare, end to end
#include <cmath>

#include "apps/program.h"
#include "spigolo/io/cloud_file.h"

namespace spigolo::test {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// A unit tetrahedron; its volume is 1/6 and its faces look outside.
TriangleMesh tetrahedron() {
  return {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}},
          {{{0, 2, 1}}, {{0, 1, 3}}, {{0, 3, 2}}, {{1, 2, 3}}}};
}

class Verbs : public ProgramTest {
 protected:
  std::string mesh_file(const std::string& name) const {
    write_mesh(path(name), tetrahedron());
    return path(name);
  }
};

TEST_F(Verbs, infoTellsWhatIsThere) {
  PointCloud cloud = small_cube();
  cloud.points.push_back(cloud.points.front());
  cloud.set("nx", ScalarType::float32, std::vector<double>(cloud.size(), 1));
  const Outcome run = run_program({"info", cloud_file("in.ply", cloud), "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json json = run.json();
  EXPECT_EQ(json["points"], 10089);
  EXPECT_EQ(json["distinct"], 10088);
  EXPECT_EQ(json["duplicates"], 1);
  EXPECT_EQ(json["non_finite"], 0);
  EXPECT_GT(json["spacing"], 0.0);
  EXPECT_EQ(json["attributes"], Json::parse(R"([{"name": "nx", "type": "float32"}])"));
  const Box box = bounding_box(cloud.points);
  EXPECT_EQ(json["bounds"]["min"], Json({box.min.x, box.min.y, box.min.z}));
  EXPECT_EQ(json["bounds"]["max"], Json({box.max.x, box.max.y, box.max.z}));
  EXPECT_TRUE(contains(run_program({"info", path("in.ply")}).out, "10 089"));
}

TEST_F(Verbs, infoCountsFaces) {
  const Outcome run = run_program({"info", mesh_file("in.stl"), "--json"});
  EXPECT_EQ(run.json()["triangles"], 4);
  EXPECT_EQ(run.json()["points"], 4);
}

TEST_F(Verbs, convertKeepsFacesWhereBothFormatsHaveThem) {
  const std::string in = mesh_file("in.ply");
  for (const char* name : {"out.obj", "out.off", "out.stl", "out.ply"}) {
    ASSERT_EQ(run_program({"convert", in, "-o", path(name)}).status, 0) << name;
    const TriangleMesh mesh = read_mesh(path(name));
    EXPECT_EQ(mesh.triangles.size(), 4u) << name;
    EXPECT_EQ(mesh.vertices.size(), 4u) << name;
  }
  const Outcome lost = run_program({"convert", in, "-o", path("out.xyz")});
  EXPECT_EQ(lost.status, 0);
  EXPECT_TRUE(contains(lost.err, "4 triangles are left out")) << lost.err;
}

TEST_F(Verbs, convertKeepsDoublesAndAttributes) {
  PointCloud cloud = small_cube();
  cloud.points[5] = {1.0 / 3, 1e-300, -2e17};
  cloud.set("weight", ScalarType::float64, std::vector<double>(cloud.size(), 0.1));
  const std::string in = cloud_file("in.ply", cloud);
  for (const char* name : {"out.csv", "out.xyz"}) {
    ASSERT_EQ(run_program({"convert", in, "-o", path(name)}).status, 0);
    const PointCloud back = read_cloud(path(name));
    EXPECT_EQ(back.points, cloud.points) << name;
    EXPECT_EQ(values_of(back, "weight"), values_of(cloud, "weight")) << name;
  }
  ASSERT_EQ(run_program({"convert", in, "-o", path("a.ply"), "--ascii"}).status, 0);
  EXPECT_EQ(content_of(path("a.ply")).rfind("ply\nformat ascii 1.0\n", 0), 0u);
  EXPECT_EQ(read_cloud(path("a.ply")).points, cloud.points);
  EXPECT_EQ(run_program({"convert", in, "-o", path("out.stl")}).status, 2) << "no faces for STL";
  EXPECT_FALSE(contains(content_of(path("out.stl")), "facet"));
}

TEST_F(Verbs, convertPipes) {
  const Outcome ply = run_program({"convert", "-", "-o", "-", "--format", "ply"}, "1 2 3\n4 5 6\n");
  ASSERT_EQ(ply.status, 0) << ply.err;
  EXPECT_EQ(ply.out.rfind("ply\n", 0), 0u);
  const Outcome xyz = run_program({"convert", "-", "-o", "-"}, ply.out);
  EXPECT_EQ(xyz.out, "1 2 3\n4 5 6\n");
}

TEST_F(Verbs, synthMakesTheCountsOfTheThesis) {
  const Outcome run = run_program({"synth", "cube", "-o", path("cube.ply"), "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.json()["points"], 10088);
  EXPECT_EQ(run.json()["features"], 488);
  const PointCloud cube = read_cloud(path("cube.ply"));
  EXPECT_EQ(cube.find("truth_feature")->type, ScalarType::uint8);
  EXPECT_EQ(cube.find("truth_edge_distance")->type, ScalarType::float64);
}

TEST_F(Verbs, synthDependsOnTheSeedAlone) {
  const auto bytes = [&](const char* seed, const char* threads) {
    EXPECT_EQ(
        run_program({"synth", "wedge", "--angle", "120", "--noise", "0.1", "--sampling", "random",
                     "--points", "500", "--seed", seed, "--threads", threads, "-o", path("w.ply")})
            .status,
        0);
    EXPECT_EQ(read_cloud(path("w.ply")).size(), 500u);
    return content_of(path("w.ply"));
  };
  const std::string first = bytes("1", "1");
  EXPECT_TRUE(first == bytes("1", "3"));
  EXPECT_FALSE(first == bytes("2", "1"));
}

TEST_F(Verbs, synthListsItsShapesAndSuggests) {
  const Outcome list = run_program({"synth", "--list"});
  EXPECT_EQ(list.status, 0);
  for (const char* shape : {"cube", "planes", "hole", "hole17k", "wedge"})
    EXPECT_TRUE(contains("\n" + list.out, std::string("\n").append(shape).append(" "))) << shape;
  const Outcome typo = run_program({"synth", "cubo", "-o", path("a.ply")});
  EXPECT_EQ(typo.status, 2);
  EXPECT_TRUE(contains(typo.err, "did you mean 'cube'?")) << typo.err;
  EXPECT_EQ(run_program({"synth", "wedge", "--angle", "400", "-o", path("a.ply")}).status, 2);
  EXPECT_EQ(run_program({"synth", "cube"}).status, 2) << "no -o";
}

// Width and height in the header of a PNG file.
std::pair<int, int> png_size(const std::string& bytes) {
  EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = at; i < at + 4; ++i)
      value = value * 256 + static_cast<std::uint8_t>(bytes[i]);
    return value;
  };
  return {number(16), number(20)};
}

TEST_F(Verbs, renderDrawsCloudsMeshesAndPanels) {
  const std::string cube = cloud_file("cube.ply", small_cube()), mesh = mesh_file("mesh.stl");
  ASSERT_EQ(run_program({"detect", cube, "-o", path("f.ply")}).status, 0);
  const Outcome run = run_program({"render", path("f.ply"), mesh, "-o", path("pic.png"), "--size",
                                   "320x160", "--view", "iso", "--title", "both"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(png_size(content_of(path("pic.png"))), std::pair(320, 160));
  for (const char* color : {"kind", "quality", "none", "rgb"})
    EXPECT_EQ(run_program({"render", path("f.ply"), "-o", path("c.png"), "--size", "64x64",
                           "--color", color})
                  .status,
              0)
        << color;
  ASSERT_EQ(run_program({"render", mesh, "-o", path("few.png"), "--colors", "16"}).status, 0);
  ASSERT_EQ(run_program({"render", mesh, "-o", path("all.png")}).status, 0);
  EXPECT_LT(2 * content_of(path("few.png")).size(), content_of(path("all.png")).size());
}

TEST_F(Verbs, renderRefusesWhatItCannotDraw) {
  const std::string mesh = mesh_file("mesh.ply");
  const std::vector<std::vector<std::string>> wrong = {
      {"--size", "10x"},     {"--size", "9x9"},        {"--view", "sideways"},
      {"--color", "weight"}, {"--target", "1,2"},      {"--range", "low,high"},
      {"--zoom", "0"},       {"--supersampling", "9"}, {"--colors", "1"},
      {"--colors", "257"}};
  for (const auto& option : wrong) {
    const Outcome run = run_program({"render", mesh, "-o", path("pic.png"), option[0], option[1]});
    EXPECT_EQ(run.status, 2) << option[0] << " " << option[1] << ": " << run.err;
  }
  EXPECT_EQ(listing(), std::vector<std::string>{"mesh.ply"});
}

TEST_F(Verbs, compareMeasuresAShiftBothWays) {
  PointCloud a = small_cube(), b = a;
  for (Vec3& p : b.points) p.z += 1e-3;  // far less than the spacing
  const Outcome run = run_program({"compare", cloud_file("a.ply", a), cloud_file("b.ply", b),
                                   "--json", "-o", path("d.ply"), "--tolerance", "2e-3"});
  ASSERT_EQ(run.status, 0) << run.err;
  for (const char* way : {"a_to_b", "b_to_a"})
    for (const char* key : {"mean", "rms", "p95", "max"})
      EXPECT_NEAR(run.json()[way][key].get<double>(), 1e-3, 1e-12) << way << " " << key;
  EXPECT_TRUE(run.json()["a_to_b"].contains("signed_mean"));
  EXPECT_GT(run.json()["spacing"], 0.0);
  EXPECT_EQ(run.json()["inside"], 1.0);
  EXPECT_NEAR(values_of(read_cloud(path("d.ply")), "scalar_deviation")[0], 1e-3, 1e-9);
}

TEST_F(Verbs, compareLeavesOutLabelsSoThatRenderDrawsTheDeviation) {
  PointCloud a;
  a.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  a.set("scalar_kind", ScalarType::float32, {0, 1, 0, 1});
  a.set("scalar_angle", ScalarType::float32, {0, 90, 0, 90});
  const std::string cloud = cloud_file("a.ply", a);
  ASSERT_EQ(run_program({"compare", cloud, cloud, "-o", path("d.ply")}).status, 0);
  const PointCloud out = read_cloud(path("d.ply"));
  EXPECT_EQ(out.find("scalar_kind"), nullptr);
  EXPECT_NE(out.find("scalar_angle"), nullptr);
  EXPECT_NE(out.find("scalar_deviation"), nullptr);
}

TEST_F(Verbs, compareToAMeshHasASign) {
  const std::string mesh = mesh_file("mesh.ply");
  const PointCloud points{{{0.2, 0.2, -0.5}, {0.2, 0.2, 0.1}}, {}};  // below it, inside it
  const Outcome run =
      run_program({"compare", cloud_file("a.xyz", points), mesh, "--json", "-o", path("d.ply")});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto deviation = values_of(read_cloud(path("d.ply")), "scalar_deviation");
  EXPECT_NEAR(deviation[0], 0.5, 1e-7);
  EXPECT_NEAR(deviation[1], -0.1, 1e-7);
  EXPECT_NEAR(run.json()["a_to_b"]["signed_mean"].get<double>(), 0.2, 1e-7);
}

TEST_F(Verbs, compareReadsLinesOfPlyAndObj) {
  // A straight edge of length 3 along x, against points 0.25 above it and one far behind its end.
  const std::string ply = file("lines.ply",
                               "ply\nformat ascii 1.0\nelement vertex 2\nproperty double x\n"
                               "property double y\nproperty double z\nelement edge 1\n"
                               "property int vertex1\nproperty int vertex2\nend_header\n"
                               "0 0 0\n3 0 0\n0 1\n");
  const std::string obj = file("lines.obj", "v 0 0 0\nv 1.5 0 0\nv 3 0 0\nl 1 2 3\n");
  const PointCloud points{{{0.5, 0, 0.25}, {2.5, 0, 0.25}, {7, 0, 0}}, {}};
  const std::string cloud = cloud_file("points.ply", points);
  for (const std::string& lines : {ply, obj}) {
    const Outcome run = run_program({"compare", cloud, lines, "--json", "-o", path("d.ply")});
    ASSERT_EQ(run.status, 0) << run.err;
    const auto deviation = values_of(read_cloud(path("d.ply")), "scalar_deviation");
    EXPECT_NEAR(deviation[0], 0.25, 1e-7);
    EXPECT_NEAR(deviation[2], 4, 1e-7);
    // The middle of the line is farthest from the points, its ends are not.
    EXPECT_NEAR(run.json()["b_to_a"]["max"].get<double>(), std::hypot(1, 0.25), 1e-3);
    EXPECT_EQ(run.json()["a_to_b"]["count"], 3);
  }
  const Outcome both = run_program({"compare", ply, obj, "--json", "-o", path("d.ply")});
  ASSERT_EQ(both.status, 0) << both.err;
  EXPECT_NEAR(both.json()["a_to_b"]["max"].get<double>(), 0, 1e-12);
  EXPECT_GT(read_cloud(path("d.ply")).size(), 1000u);
  EXPECT_EQ(run_program({"compare", cloud, file("bad.obj", "v 0 0 0\nl 1 9\n")}).status, 3);
}

TEST_F(Verbs, compareMeasuresBetweenTheVerticesOfLargeFaces) {
  // One triangle of height 1 over a dense square: its inside is as far away as its corners.
  const std::string mesh = file("mesh.obj", "v 0 0 0\nv 8 0 0\nv 0 8 0\nf 1 2 3\n");
  const PointCloud corners{{{0, 0, 1}, {8, 0, 1}, {0, 8, 1}}, {}};
  const Outcome run = run_program({"compare", mesh, cloud_file("c.ply", corners), "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_GT(run.json()["a_to_b"]["max"].get<double>(), 5.5);  // the middle of the longest side
}

TEST_F(Verbs, compareFailsWhereTooFewAreInside) {
  PointCloud a = small_cube(), b = a;
  for (std::size_t i = 0; i < a.size() / 2; ++i) a.points[i].z += 1e-3;
  const std::vector<std::string> run = {"compare",
                                        cloud_file("a.ply", a),
                                        cloud_file("b.ply", b),
                                        "--tolerance",
                                        "1e-4",
                                        "--json",
                                        "-o",
                                        path("d.ply"),
                                        "--require"};
  const auto with = [&](const char* share) {
    auto arguments = run;
    arguments.emplace_back(share);
    return run_program(arguments);
  };
  const Outcome failed = with("0.6");
  EXPECT_EQ(failed.status, 4);
  EXPECT_EQ(failed.json()["inside"], 0.5);
  EXPECT_EQ(listing(), (std::vector<std::string>{"a.ply", "b.ply"}));
  EXPECT_EQ(with("0.5").status, 0);
  EXPECT_EQ(with("1.5").status, 2);
  EXPECT_EQ(run_program({"compare", path("a.ply"), path("b.ply"), "--require", "0.5"}).status, 2);
}

}  // namespace
}  // namespace spigolo::test
