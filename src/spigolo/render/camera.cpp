// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/camera.cpp
#include "spigolo/render/camera.h"

#include "spigolo/core/parallel.h"

namespace spigolo {
namespace {

constexpr double eye_distance =
    4.5;  // in scene radii: a mild perspective that keeps angles readable
constexpr std::size_t grain = 65536;

// The box of f(p) over all finite points. Minimum and maximum do not depend on the order.
template <class F>
Box box_of(std::span<const std::span<const Vec3>> positions, const Job& job, const F& f) {
  Box box;
  for (const auto& points : positions) {
    std::vector<Box> parts((points.size() + grain - 1) / grain);
    parallel_for(job, "", points.size(), grain, [&](std::size_t begin, std::size_t end) {
      Box& part = parts[begin / grain];
      for (std::size_t i = begin; i < end; ++i)
        if (is_finite(points[i])) part.add(f(points[i]));
    });
    for (const Box& part : parts)
      if (!part.empty()) box.add(part.min), box.add(part.max);
  }
  return box;
}

void aim(Camera& camera, const View& view, const Vec3& direction) {
  camera.forward = normalized(direction);
  if (camera.forward == Vec3{}) camera.forward = {0, 1, 0};
  Vec3 up = normalized(view.up);
  for (const Vec3& other : {Vec3{0, 1, 0}, Vec3{1, 0, 0}})
    if (norm(cross(camera.forward, up)) < 1e-6) up = other;
  camera.right = normalized(cross(camera.forward, up));
  camera.up = cross(camera.right, camera.forward);
}

// Sets scale and middle so that what spans `seen` at scale 1 fills the frame.
void frame_box(Camera& camera, const Box& seen, const Frame& frame, double zoom) {
  const double width = std::max(frame.x1 - frame.x0, 1.0),
               height = std::max(frame.y1 - frame.y0, 1.0);
  const Vec3 size = seen.size();
  const double unit = camera.perspective ? 1 / camera.distance : 1;
  const double smallest = 1e-12 * unit * camera.distance;
  camera.scale =
      size.x <= smallest && size.y <= smallest
          ? std::min(width, height) / (2 * unit)
          : std::min(width / std::max(size.x, smallest), height / std::max(size.y, smallest));
  camera.scale *= zoom;
  camera.cx = 0.5 * (frame.x0 + frame.x1) - camera.scale * seen.center().x;
  camera.cy = 0.5 * (frame.y0 + frame.y1) + camera.scale * seen.center().y;
}

}  // namespace

Projected Camera::project(const Vec3& p) const {
  const Vec3 d = p - center;
  const double z = dot(d, forward) + distance;
  const double s = perspective ? scale / z : scale;
  return {cx + s * dot(d, right), cy - s * dot(d, up), z};
}

Vec3 Camera::unproject(double x, double y, double z) const {
  const double s = pixel_size(z);
  return {(x - cx) * s, (cy - y) * s, z};
}

Camera fit_camera(std::span<const std::span<const Vec3>> positions, const View& view,
                  const Vec3& direction, const Frame& frame, const Job& job) {
  const Box box = box_of(positions, job, [](const Vec3& p) { return p; });
  Camera camera;
  aim(camera, view, direction);
  camera.perspective = view.perspective;
  camera.center = box.empty() ? Vec3{} : box.center();
  const double extent = 0.5 * norm(box.size());
  const double radius = extent > 0 ? extent : 1;
  camera.distance = eye_distance * radius;
  const Camera unit = camera;  // scale 1, middle at 0: projects to tangents or to model units
  const auto flat = [&](const Vec3& p) {
    const Projected q = unit.project(p);
    return Vec3{q.x, -q.y, 0};
  };
  Box seen;
  if (view.target) {
    const Vec3 middle = flat(*view.target);
    const double z = std::max(unit.project(*view.target).z, 0.1 * radius);
    const double r =
        (view.radius > 0 ? view.radius : radius) * unit.pixel_size(1) / (view.perspective ? z : 1);
    seen.add(middle - Vec3{r, r, 0}), seen.add(middle + Vec3{r, r, 0});
  } else {
    seen = box_of(positions, job, flat);
    if (seen.empty()) seen.add({});
  }
  frame_box(camera, seen, frame, view.zoom);
  return camera;
}

}  // namespace spigolo
