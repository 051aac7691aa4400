// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// STEP and IGES: what is written is read back; what is damaged is refused
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

#include "spigolo/cad/cad_file.h"
#include "spigolo/cad/nurbs_shapes.h"
#include "spigolo/cad/spline_rows.h"
#include "spigolo/cad/step_writer.h"
#include "spigolo/core/error.h"
#include "spigolo/core/parallel.h"
#include "spigolo/core/random.h"

namespace spigolo {
namespace {

const Vec3 ex{1, 0, 0}, ey{0, 1, 0}, ez{0, 0, 1};

class Cad : public ::testing::Test {
 protected:
  Cad()
      : folder_(std::filesystem::temp_directory_path() /
                ("spigolo_cad_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~Cad() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  CadFile step(const StepContent& content, const std::string& unit = "mm") const {
    return CadFile(file("part.step", step_text(content, unit)));
  }
  CadFile iges(const StepContent& content) const {
    return CadFile(file("part.igs", iges_text(content)));
  }
  std::filesystem::path folder_;
};

StepContent one_face(NurbsSurface surface) { return {{}, {}, {{std::move(surface), {}}}}; }

double largest_difference(const NurbsSurface& a, const NurbsSurface& b) {
  double largest = 0;
  for (int i = 0; i <= 20; ++i)
    for (int j = 0; j <= 20; ++j) {
      const auto at = [&](const NurbsSurface& s) {
        const double u0 = first_parameter(s.knots_u, s.degree_u),
                     u1 = last_parameter(s.knots_u, s.degree_u),
                     v0 = first_parameter(s.knots_v, s.degree_v),
                     v1 = last_parameter(s.knots_v, s.degree_v);
        return point_at(s, u0 + (u1 - u0) * i / 20, v0 + (v1 - v0) * j / 20);
      };
      largest = std::max(largest, distance(at(a), at(b)));
    }
  return largest;
}

TEST_F(Cad, tubesAndSheetsComeBackThroughStepAndIges) {
  const auto wave = [](double x, double y) { return Vec3{x, y, std::sin(x) * std::cos(0.7 * y)}; };
  for (const NurbsSurface& s :
       {nurbs_tube({{1, 2, 3}, normalized(Vec3{1, 2, 3})}, 2, 5),
        nurbs_u_tube({{0, 0, 0}, ez}, ex, 1, 4, 5), nurbs_sheet(6, 4, 9, wave)}) {
    for (const CadFile& read : {step(one_face(s)), iges(one_face(s))}) {
      ASSERT_EQ(read.faces().size(), 1u);
      EXPECT_FALSE(read.faces()[0].trimmed);
      EXPECT_EQ(read.unit(), "mm");
      const NurbsFace face = read.face(0);
      validate(face);
      EXPECT_EQ(face.closed_u, s.period_u > 0);
      EXPECT_FALSE(face.closed_v);
      EXPECT_LT(largest_difference(face.surface, s), read.format() == "STEP" ? 1e-10 : 1e-7);
    }
  }
}

TEST_F(Cad, unitsOfTheFileAreKept) {
  const NurbsSurface tube = nurbs_tube({{0, 0, 0}, ez}, 2, 5);
  for (const char* unit : {"mm", "cm", "m", "inch"}) {
    const CadFile read = step(one_face(tube), unit);
    EXPECT_EQ(read.unit(), unit);
    EXPECT_NEAR(read.faces()[0].area, 20 * pi, 1e-4) << unit;
  }
  EXPECT_THROW(step_text(one_face(tube), "yard"), UsageError);
}

TEST_F(Cad, sameBytesEveryTimeAndNoDate) {
  const StepContent content = {
      {CadLine{{0, 0, 0}, {1, 2, 3}}}, {{4, 5, 6}}, {{nurbs_tube({{0, 0, 0}, ez}, 2, 5), {}}}};
  const std::string first = step_text(content);
  EXPECT_EQ(first, step_text(content));
  EXPECT_EQ(iges_text(content), iges_text(content));
  EXPECT_NE(first.find("1970-01-01T00:00:00"), std::string::npos);
}

TEST_F(Cad, curvesAndPointsAreThere) {
  StepContent content;
  content.curves = {CadLine{{0, 0, 0}, {1, 2, 3}}, CadArc{{0, 0, 0}, ex, ey, 2, 0, 2 * pi},
                    CadArc{{5, 0, 0}, ex, ez, 1, 0.5, 2.0},
                    spline_through(std::vector<Vec3>{{0, 0, 0}, {1, 1, 0}, {2, 0, 1}}, false)};
  content.points = {{7, 8, 9}, {1, 1, 1}};
  const CadFile read = step(content);
  EXPECT_EQ(read.faces().size(), 0u);
  EXPECT_EQ(read.free_curves(), 4u);
  EXPECT_EQ(read.free_points(), 2u);
  EXPECT_NEAR(read.bounds().max.x, 7, 1e-9);
  EXPECT_NEAR(read.bounds().min.x, -2, 1e-6);
  const std::string text = step_text(content);
  for (const char* word : {"CIRCLE", "LINE", "B_SPLINE_CURVE_WITH_KNOTS", "CARTESIAN_POINT"})
    EXPECT_NE(text.find(word), std::string::npos) << word;
  EXPECT_THROW(step_text(StepContent{}), NoResultError);
  EXPECT_THROW(step_text({{CadLine{{1, 1, 1}, {1, 1, 1}}}}), Error);
}

TEST_F(Cad, analyticCylinderIsConvertedExactly) {
  StepContent content;
  content.faces = {{CadCylinder{{1, 1, 1}, ez, ex, 3, 4}, {}}};
  for (const CadFile& read : {step(content), iges(content)}) {
    ASSERT_EQ(read.faces().size(), 1u);
    const CadFaceInfo& info = read.faces()[0];
    if (read.format() == "STEP") {
      EXPECT_EQ(info.type, "cylinder");
    }
    EXPECT_NEAR(info.area, 24 * pi, 1e-5);
    EXPECT_FALSE(info.trimmed);
    const NurbsFace face = read.face(0);
    EXPECT_TRUE(face.closed_u || face.closed_v);
    Random random(3);
    for (int i = 0; i < 200; ++i) {
      const double u = face.u.at(random.uniform()), v = face.v.at(random.uniform());
      const Vec3 p = point_at(face.surface, u, v) - Vec3{1, 1, 1};
      EXPECT_NEAR(std::hypot(p.x, p.y), 3, 1e-9);
      EXPECT_GT(p.z, -1e-9);
      EXPECT_LT(p.z, 4 + 1e-9);
      EXPECT_GT(dot(outward_normal(face, u, v), {p.x, p.y, 0}), 0);
    }
  }
}

TEST_F(Cad, trimmedFaceKnowsItsInside) {
  StepContent content;
  const auto flat = [](double x, double y) { return Vec3{x, y, 0}; };
  content.faces = {{nurbs_sheet(10, 10, 4, flat),
                    {{{0.1, 0.1}, {0.9, 0.1}, {0.9, 0.8}, {0.1, 0.8}},
                     {{0.4, 0.4}, {0.4, 0.6}, {0.6, 0.6}, {0.6, 0.4}}}}};
  for (const CadFile& read : {step(content), iges(content)}) {
    const CadFaceInfo& info = read.faces()[0];
    EXPECT_TRUE(info.trimmed);
    EXPECT_NEAR(info.area, 56 - 4, 1e-6);
    const NurbsFace face = read.face(0);
    const auto& range = face.u;
    EXPECT_EQ(inside(face, Parameter::u, range.at(0.05)).size(), 1u);
    const auto split = inside(face, Parameter::u, range.at(0.5));
    ASSERT_EQ(split.size(), 2u);
    EXPECT_NEAR(point_at(face.surface, range.at(0.5), split[0].end).y, 4, 1e-6);
    EXPECT_NEAR(point_at(face.surface, range.at(0.5), split[1].begin).y, 6, 1e-6);
    EXPECT_NEAR(point_at(face.surface, range.begin, split[1].end).y, 8, 1e-6);
  }
}

// By sums over the NURBS data inside its trimming curves.
double area_of(const NurbsFace& face) {
  constexpr int lines = 200, steps = 40;
  double area = 0;
  for (int i = 0; i < lines; ++i) {
    const double u = face.u.at((i + 0.5) / lines);
    for (const Interval& part : inside(face, Parameter::u, u))
      for (int j = 0; j < steps; ++j) {
        const NurbsPoint p = evaluate(face.surface, u, part.at((j + 0.5) / steps));
        area += norm(cross(p.du, p.dv)) * face.u.length() / lines * part.length() / steps;
      }
  }
  return area;
}

// Parts that come with OpenCASCADE in Debian (package occt-misc): every kind of surface, trimmed in
// every way. One face of the bearing is a sliver ten times as long as wide.
TEST_F(Cad, areasOfRealPartsSurviveTheConversion) {
  const std::filesystem::path data = "/usr/share/opencascade/data";
  std::size_t faces = 0;
  for (const char* name :
       {"step/screw.step", "step/linkrods.step", "iges/hammer.iges", "iges/bearing.iges"}) {
    if (!std::filesystem::exists(data / name)) continue;
    const CadFile part(data / name);
    for (std::size_t i = 0; i < part.faces().size(); ++i, ++faces)
      EXPECT_NEAR(area_of(part.face(i)) / part.faces()[i].area, 1, 0.025) << name << " " << i;
  }
  StepContent own;  // what there is without the package
  own.faces = {{CadCylinder{{1, 1, 1}, ez, ex, 3, 4}, {}},
               {nurbs_u_tube({{0, 0, 0}, ez}, ex, 1, 4, 5), {}}};
  const CadFile file = step(own);
  for (std::size_t i = 0; i < file.faces().size(); ++i, ++faces)
    EXPECT_NEAR(area_of(file.face(i)) / file.faces()[i].area, 1, 1e-3) << i;
  EXPECT_GE(faces, 2u);
}

TEST_F(Cad, facesWithoutAreaAreRefused) {
  const auto line = [](double x, double) { return Vec3{x, 0, 0}; };
  const CadFile read = step(one_face(nurbs_sheet(10, 10, 4, line)));
  for (std::size_t i = 0; i < read.faces().size(); ++i) {
    EXPECT_EQ(read.faces()[i].area, 0);
    EXPECT_THROW(read.face(i), NoResultError);
  }
}

TEST_F(Cad, damagedFilesAreRefusedAndFilesWithoutFacesAreNot) {
  const std::string good = step_text(one_face(nurbs_tube({{0, 0, 0}, ez}, 2, 5)));
  EXPECT_THROW(CadFile(file("cut.step", good.substr(0, good.size() / 2))), InputError);
  // What names entities that are not there parses, but crashes OpenCASCADE if it is used.
  std::string dangling = good;
  dangling.insert(dangling.find('#', dangling.find("VERTEX_POINT(''")) + 1, "999");
  EXPECT_THROW(CadFile(file("dangling.step", dangling)), InputError);
  EXPECT_THROW(CadFile(file("other.step", "solid cube\n")), InputError);
  EXPECT_THROW(CadFile(file("empty.step", "")), InputError);
  EXPECT_THROW(CadFile(file("other.igs", good)), InputError);
  EXPECT_THROW(CadFile(folder_ / "none.step"), InputError);
  EXPECT_THROW(CadFile(file("part.obj", good)), UsageError);
  const CadFile bare = step({{CadLine{{0, 0, 0}, {1, 2, 3}}}});
  EXPECT_TRUE(bare.faces().empty());
  EXPECT_THROW(bare.face(0), UsageError);
}

TEST_F(Cad, threadsSeeTheSameSurface) {
  const NurbsFace face = step(one_face(nurbs_u_tube({{0, 0, 0}, ez}, ex, 1, 4, 5))).face(0);
  std::vector<Vec3> one(5000), four(5000);
  const auto fill = [&](std::vector<Vec3>& out, int threads) {
    Job job;
    job.threads = threads;
    parallel_for(job, "", out.size(), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const double share = static_cast<double>(i) / 5000;
        out[i] = point_at(face.surface, face.u.at(share), face.v.at(1 - share));
      }
    });
  };
  fill(one, 1);
  fill(four, 4);
  EXPECT_EQ(one, four);
}

}  // namespace
}  // namespace spigolo
