// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/meeting.cpp
#include "spigolo/sheets/meeting.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "spigolo/core/parallel.h"
#include "spigolo/core/symmetric3.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 1024;
constexpr std::size_t asked = 16;        // neighbors whose creases may run in
constexpr double other_direction = 0.9;  // cosine; creases more alike are one
constexpr double look = 5;               // [spacings] the sheets are sought
constexpr double touch = 3.5;            // [spacings] a sheet comes this close to its corner
constexpr double good = 0.03;            // [spacings] residual of a sheet that is trusted
constexpr double exact_fit = 1e-4, worse_fit = 20;  // [spacings], times the middle one
constexpr double same_angle = radians(12);          // quadrics of one face, drawn out to the corner
constexpr double common = 0.2;                      // [spacings] of a sheet from the common point
constexpr double corner_reach = 0.9;                // [spacings] of the point from it
constexpr double least_spread = 0.02;  // smallest eigenvalue of the normals' scatter, share
constexpr std::size_t least_members = 3, least_near = 2, most_sheets = 12, least_new = 4;

// The own sheets of some points that are one face of the surface.
struct Face {
  const Sheet* sheet;  // the one of them that fits best
  Vec3 normal;         // drawn out to the place looked from
  std::vector<std::uint32_t> members;
};

bool runs_in(const SheetVerdict& v) { return v.kind == PointKind::edge; }

// Creases of three directions among the neighbors.
bool is_crossroads(const SheetCloud& cloud, const VerdictRows& verdicts, std::size_t i) {
  std::array<Vec3, 3> directions;
  std::size_t n = 0;
  const auto row = cloud.neighborhoods.of(i);
  for (const std::uint32_t j : row.first(std::min(asked, row.size()))) {
    if (!runs_in(verdicts[j])) continue;
    const Vec3& d = verdicts[j].direction;
    if (std::any_of(directions.begin(), directions.begin() + static_cast<std::ptrdiff_t>(n),
                    [&](const Vec3& e) { return std::abs(dot(d, e)) > other_direction; }))
      continue;
    directions[n++] = d;
    if (n == directions.size()) return true;
  }
  return false;
}

bool same_face(const Face& a, const Face& b, const Vec3& from) {
  return std::abs(dot(a.normal, b.normal)) >= std::cos(same_angle) &&
         std::abs(std::abs(height(*a.sheet, from)) - std::abs(height(*b.sheet, from))) <=
             2 * common;
}

void add_to_faces(std::vector<Face>& faces, Face face, const Vec3& from) {
  for (Face& known : faces) {
    if (!same_face(known, face, from)) continue;
    known.members.insert(known.members.end(), face.members.begin(), face.members.end());
    if (face.sheet->deviation < known.sheet->deviation)
      known.sheet = face.sheet, known.normal = face.normal;
    return;
  }
  faces.push_back(std::move(face));
}

// A face that a bad fit began may have become the same as another one.
std::vector<Face> merged(std::vector<Face> faces, const Vec3& from) {
  std::vector<Face> distinct;
  for (Face& face : faces) add_to_faces(distinct, std::move(face), from);
  return distinct;
}

// Sheets bent over a crease: beside faces that fit to the last bit, they fit badly.
void drop_bent(std::vector<Face>& faces) {
  if (faces.empty()) return;
  std::vector<double> fits;
  for (const Face& face : faces) fits.push_back(std::max(face.sheet->deviation, exact_fit));
  const auto middle = fits.begin() + static_cast<std::ptrdiff_t>(fits.size() / 2);
  std::nth_element(fits.begin(), middle, fits.end());
  std::erase_if(faces, [&](const Face& f) { return f.sheet->deviation > worse_fit * *middle; });
}

std::vector<Face> find_faces(const SheetCloud& cloud, std::uint32_t i) {
  std::vector<Face> faces;
  const Vec3& p = cloud.points[i];
  const double s = cloud.spacing.of_point[i];
  for (const std::uint32_t j : second_ring(cloud, i)) {
    const Sheet& sheet = cloud.sheets[j];
    if (sheet.fitted() && sheet.support >= quadric_points && sheet.deviation <= good &&
        distance(cloud.points[j], p) <= look * s)
      add_to_faces(faces, {&sheet, normal_at(sheet, p), {j}}, p);
  }
  faces = merged(std::move(faces), p);
  std::erase_if(faces, [](const Face& f) { return f.members.size() < least_members; });
  drop_bent(faces);
  return faces;
}

// Where the faces' tangent planes meet, by least squares; nothing if they leave that open.
std::optional<Vec3> common_point(std::span<const Face> faces, const Vec3& from) {
  Symmetric3 m;
  Vec3 b;
  for (const Face& face : faces) {
    m.add(face.normal);
    b -= face.normal * (height(*face.sheet, from) * face.sheet->spacing *
                        (dot(normal_at(*face.sheet, from), face.normal) < 0 ? -1.0 : 1.0));
  }
  if (faces.size() < 3 || smallest_axis(m).value < least_spread * static_cast<double>(faces.size()))
    return std::nullopt;
  const Vec3 c0{m.xx, m.xy, m.xz}, c1{m.xy, m.yy, m.yz}, c2{m.xz, m.yz, m.zz};
  const double determinant = dot(c0, cross(c1, c2));
  return from + Vec3{dot(b, cross(c1, c2)) / determinant, dot(c0, cross(b, c2)) / determinant,
                     dot(c0, cross(c1, b)) / determinant};
}

// Whether the face passes x, and has points near it.
bool meets(const SheetCloud& cloud, const Face& face, const Vec3& x) {
  const double s = face.sheet->spacing;
  return std::abs(height(*face.sheet, x)) <= common &&
         static_cast<std::size_t>(
             std::count_if(face.members.begin(), face.members.end(), [&](std::uint32_t j) {
               return distance(cloud.points[j], x) <= touch * s;
             })) >= least_near;
}

std::vector<Face>::iterator farthest_face(std::vector<Face>& faces, const Vec3& x) {
  return std::max_element(faces.begin(), faces.end(), [&](const Face& a, const Face& b) {
    return std::abs(height(*a.sheet, x)) < std::abs(height(*b.sheet, x));
  });
}

std::optional<SheetVerdict> look_around(const SheetCloud& cloud, const SheetVerdict& verdict,
                                        std::uint32_t i) {
  const Vec3& p = cloud.points[i];
  const double s = cloud.spacing.of_point[i];
  std::vector<Face> faces = find_faces(cloud, i);
  if (faces.size() > most_sheets) return std::nullopt;
  const std::size_t least = verdict.kind == PointKind::corner ? 3 : least_new;
  // Faces that only pass by draw the first common point away; they go one by one.
  auto x = common_point(faces, p);
  while (x && faces.size() > least) {
    const auto worst = farthest_face(faces, *x);
    if (std::abs(height(*worst->sheet, *x)) <= common) break;
    faces.erase(worst);
    x = common_point(faces, p);
  }
  if (!x || distance(*x, p) > corner_reach * s) return std::nullopt;
  const auto n = static_cast<std::size_t>(std::count_if(
      faces.begin(), faces.end(), [&](const Face& face) { return meets(cloud, face, *x); }));
  if (n < least) return std::nullopt;
  SheetVerdict found = verdict;
  found.kind = PointKind::corner;
  found.crease_point = *x;
  found.direction = {};
  found.sheets = static_cast<std::uint8_t>(n);
  return found;
}

}  // namespace

void count_meeting_sheets(const SheetCloud& cloud, VerdictRows& verdicts, const Job& job) {
  verdicts.set(parallel_collect<FoundVerdict>(
      job, cloud.size(), grain, [&](std::size_t begin, std::size_t end, auto& here) {
        for (std::size_t i = begin; i < end; ++i) {
          const bool known = verdicts[i].kind == PointKind::corner;
          if (!known && (cloud.sheets[i].whole || verdicts[i].kind == PointKind::tip ||
                         !is_crossroads(cloud, verdicts, i)))
            continue;
          if (auto verdict = look_around(cloud, verdicts[i], static_cast<std::uint32_t>(i)))
            here.emplace_back(static_cast<std::uint32_t>(i), *verdict);
        }
      }));
}

}  // namespace spigolo
