// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/linear.cpp
#include "spigolo/blend/linear.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "spigolo/core/error.h"
#include "spigolo/core/random.h"

namespace spigolo {
namespace {

constexpr std::size_t betas_per_alpha = 3;  // k
constexpr double line_step = 0.25;          // [mean distances] between points of a line
constexpr double beta_step = 0.5;           // betas farther apart are filled up
constexpr double fan_step = 0.5;            // [widths] between the swept spheres
constexpr double beta_chain = 6;            // [mean distances] no filling over longer gaps

// (5.3), (5.4).
double mean_distance(const CloudSide& cloud) {
  double sum = 0;
  for (std::size_t i = 0; i < cloud.points().size(); ++i)
    sum += distance(cloud.points()[i], cloud.points()[cloud.neighbors(i)[0]]);
  return sum / static_cast<double>(cloud.points().size());
}

struct Alpha {
  double cross = 0, along = 0;
};

// §5.4.2.1, §5.4.2.2
class Sampling {
 public:
  Sampling(const CloudSide& cloud, const TracedStart& traced, double step, double height)
      : cloud_(cloud), traced_(traced), step_(step), height_(height) {}

  void run(std::uint32_t border) {
    for (const double cross : traced_.isolines.seeds(step_)) {
      const auto line = traced_.isolines.line(cross);
      if (line) follow(*line, border);
    }
  }
  std::vector<FilledPoint> points;
  std::vector<Alpha> alphas;

 private:
  void follow(const Isoline& line, std::uint32_t border) {
    const double direction = line.end > line.begin ? 1 : -1;
    double at = line.begin;
    bool any = false;
    Alpha last;
    while (direction * (line.end - at) >= 0) {
      const IsoPoint p = traced_.isolines.at(line.cross, at);
      if (cloud_.sample_distance(p.point, scratch_) < height_) {
        if (any) alphas.push_back(last);
        return;
      }
      if (traced_.isolines.on_face(line.cross, at))
        points.push_back({p.point, p.normal * traced_.loop.side, BlendSource::nurbs, border});
      last = {line.cross, at};
      any = true;
      const double speed = norm(p.onward);
      at += direction * (speed > 0 ? step_ / speed : std::abs(line.end - line.begin));
    }
    if (traced_.loop.closed)
      throw NoResultError(
          "a line of the face runs through the cloud: the height is below the distance of its "
          "samples; take a larger one, or the method 'tangent'");
  }

  const CloudSide& cloud_;
  const TracedStart& traced_;
  double step_, height_;
  MlsScratch scratch_;
};

std::vector<Alpha> doubled(const std::vector<Alpha>& alphas, const TracedStart& traced) {
  std::vector<Alpha> out;
  const std::size_t n = alphas.size();
  for (std::size_t i = 0; i < n; ++i) {
    out.push_back(alphas[i]);
    if (!traced.loop.closed && i + 1 == n) break;
    const Alpha& next = alphas[(i + 1) % n];
    double step = next.cross - alphas[i].cross;
    if (step < 0) step += traced.isolines.range().length();
    out.push_back({alphas[i].cross + step / 2, (alphas[i].along + next.along) / 2});
  }
  return out;
}

void remove_within(const CloudSide& cloud, const Vec3& center, double radius,
                   std::vector<char>& removed, std::vector<Neighbor>& scratch) {
  cloud.tree().within(center, radius, scratch);
  for (const Neighbor& n : scratch) removed[n.index] = 1;
}

// §5.4.2.3, figure 71
void sweep(const CloudSide& cloud, const std::vector<Strand>& strands, double width,
           std::vector<char>& removed) {
  std::vector<Neighbor> scratch;
  for (const Strand& s : strands) remove_within(cloud, s.alpha, width, removed, scratch);
  const Vec3& from = strands.front().alpha;
  for (const Strand& s : strands) {
    const double length = distance(from, s.alpha);
    const int steps = static_cast<int>(std::ceil(length / (fan_step * width)));
    for (int i = 1; i < steps; ++i)
      remove_within(cloud, from + (s.alpha - from) * (double(i) / steps), width, removed, scratch);
  }
}

// (5.5); the search widens until a sample that stays is found.
Vec3 nearest_kept(const CloudSide& cloud, const Vec3& p, const std::vector<char>& removed,
                  std::vector<Neighbor>& scratch) {
  for (std::size_t k = 64; k < 2 * cloud.points().size(); k *= 4) {
    cloud.tree().nearest(p, k, scratch);
    for (const Neighbor& n : scratch)
      if (!removed[n.index]) return cloud.points()[n.index];
  }
  throw NoResultError("the width removes the whole cloud");
}

std::vector<Vec3> filled_betas(const BorderLoop& loop, double step) {
  std::vector<Vec3> betas;
  const std::size_t n = loop.strands.size();
  for (std::size_t i = 0; i < n; ++i) {
    betas.push_back(loop.strands[i].beta);
    if (!loop.closed && i + 1 == n) break;
    const Vec3 &a = loop.strands[i].beta, &b = loop.strands[(i + 1) % n].beta;
    const double gap = distance(a, b);
    if (gap > beta_chain * step) continue;
    const int pieces = static_cast<int>(std::ceil(gap / (beta_step * step)));
    for (int k = 1; k < pieces; ++k) betas.push_back(a + (b - a) * (double(k) / pieces));
  }
  return betas;
}

// §5.4.2.4, figure 73
std::vector<FilledPoint> lines(const BorderLoop& loop, const std::vector<Vec3>& betas, double step,
                               std::uint32_t border) {
  std::vector<FilledPoint> points;
  std::vector<std::pair<double, std::size_t>> order(betas.size());
  const std::size_t n = loop.strands.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Strand& s = loop.strands[i];
    for (std::size_t j = 0; j < betas.size(); ++j)
      order[j] = {squared_distance(s.alpha, betas[j]), j};
    const std::size_t k = std::min(betas_per_alpha, betas.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(k), order.end());
    const Vec3 along = loop.strands[(i + 1) % n].alpha - loop.strands[(i + n - 1) % n].alpha;
    for (std::size_t j = 0; j < k; ++j) {
      const Vec3 way = betas[order[j].second] - s.alpha;
      Vec3 normal = normalized(cross(way, along));
      if (dot(normal, s.alpha_normal * loop.side + s.beta_normal) < 0) normal = -normal;
      const int pieces = static_cast<int>(std::ceil(norm(way) / (line_step * step)));
      for (int m = 1; m < pieces; ++m)
        points.push_back(
            {s.alpha + way * (double(m) / pieces), normal, BlendSource::collar, border});
    }
  }
  return points;
}

// Greedy, in random order: figure 75.
void thin(std::vector<FilledPoint>& points, double radius, Random& random) {
  std::vector<Vec3> places;
  for (const FilledPoint& p : points) places.push_back(p.point);
  const OrderedCloud ordered = order_cloud(places);
  const KdTree tree(ordered);
  std::vector<char> gone(ordered.size(), 0), kept(ordered.size(), 0);
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  std::vector<FilledPoint> out;
  std::vector<Neighbor> found;
  for (const std::size_t i : order) {
    const std::uint32_t at = ordered.rank[i];
    if (gone[at] || kept[at]) continue;
    kept[at] = 1;
    out.push_back(points[i]);
    tree.within(ordered.points[at], radius, found);
    for (const Neighbor& n : found) gone[n.index] = 1;
  }
  points = std::move(out);
}

}  // namespace

LinearBorder linear_border(const CloudSide& cloud, const TracedStart& traced,
                           const Setbacks& setbacks, std::uint32_t border, std::uint64_t seed,
                           std::vector<char>& removed) {
  const double step = mean_distance(cloud);
  Sampling sampling(cloud, traced, step, setbacks.height);
  sampling.run(border);
  if (sampling.alphas.size() < 3)
    throw NoResultError(
        "the collar is wider than the face it runs on: the start is nearer to the "
        "cloud than the height");
  LinearBorder out;
  out.loop.closed = traced.loop.closed;
  out.loop.side = traced.loop.side;
  for (const Alpha& a : doubled(sampling.alphas, traced)) {
    const IsoPoint p = traced.isolines.at(a.cross, a.along);
    Strand s;
    s.alpha = p.point;
    s.alpha_normal = p.normal;
    s.toward_face = -normalized(p.onward);
    s.alpha_at = a.along;
    s.line.cross = a.cross;
    out.loop.strands.push_back(s);
  }
  sweep(cloud, out.loop.strands, setbacks.width, removed);
  MlsScratch scratch;
  for (Strand& s : out.loop.strands) {
    s.beta = nearest_kept(cloud, s.alpha, removed, scratch.found);
    const Vec3 up = s.alpha - s.beta;
    const OrientedFoot foot = orient_foot(cloud.project(s.beta, scratch), s.beta, up);
    s.beta_normal = foot.found ? foot.normal : normalized(up);
    s.x = (s.alpha + s.beta) / 2;
    s.alpha_handle = s.x - s.alpha;
    s.beta_handle = s.x - s.beta;
    const Vec3 away = s.beta - s.alpha;
    s.toward_cloud = normalized(away - s.beta_normal * dot(away, s.beta_normal));
  }
  Random random(seed);
  std::vector<FilledPoint> collar = lines(out.loop, filled_betas(out.loop, step), step, border);
  thin(collar, step, random);
  out.points = std::move(sampling.points);
  out.points.insert(out.points.end(), collar.begin(), collar.end());
  return out;
}

}  // namespace spigolo
