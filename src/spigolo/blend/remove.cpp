// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/remove.cpp
#include "spigolo/blend/remove.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "spigolo/core/error.h"
#include "spigolo/core/symmetric3.h"

namespace spigolo {
namespace {

// Lengths in spacings.
constexpr double longest_edge = 2.2;  // that joins two samples of one surface
constexpr double band_width = 2.5;    // of the band that tells the two sides apart, to each side
constexpr double on_curve = 1.75;     // samples so close to the curve begin it
constexpr double rim = 1.25;          // from X: farther out a sample of the band has a side
constexpr double steep = 0.8;         // cosine of edge and normal: such an edge leaves the surface
constexpr double says_little = 0.2;   // mean of cosines below which a direction decides nothing
constexpr std::size_t normal_points = 12;
// The cloud goes on beyond an end of X if a sample is there.
constexpr double beyond_end = 4, at_hand = 1.75;
constexpr std::size_t end_direction = 4;  // strands that tell which way it goes on

enum class Zone : char { none, inner, middle, outer };

// Steps from sample to sample along the surface, never across a thin wall.
class SurfaceGraph {
 public:
  explicit SurfaceGraph(const CloudSide& cloud) : cloud_(cloud) {}

  template <class Visit>
  void for_each_neighbor(std::uint32_t i, Visit&& visit) const {
    const Vec3 p = cloud_.points()[i], n = normal(i);
    const auto row = cloud_.neighbors(i);
    // The twelfth neighbor tells the local spacing.
    const std::size_t rank = std::min(normal_points, row.size()) - 1;
    const double local = distance(p, cloud_.points()[row[rank]]) * std::sqrt(pi / 12.5);
    const double longest = longest_edge * std::max(local, cloud_.spacing());
    for (const std::uint32_t j : row) {
      const Vec3 edge = cloud_.points()[j] - p;
      const double length = norm(edge);
      if (length > longest) break;
      const bool leaves = std::abs(dot(edge, n)) > steep * length &&
                          std::abs(dot(edge, normal(j))) > steep * length;
      if (!leaves) visit(j);
    }
  }

 private:
  Vec3 normal(std::uint32_t i) const {
    const auto row = cloud_.neighbors(i);
    const std::size_t count = std::min(normal_points, row.size());
    Vec3 mean = cloud_.points()[i];
    for (std::size_t k = 0; k < count; ++k) mean += cloud_.points()[row[k]];
    mean = mean / static_cast<double>(count + 1);
    Symmetric3 scatter;
    scatter.add(cloud_.points()[i] - mean);
    for (std::size_t k = 0; k < count; ++k) scatter.add(cloud_.points()[row[k]] - mean);
    return smallest_axis(scatter).axis;
  }

  const CloudSide& cloud_;
};

// A curve on the cloud, and at each of its points the way to the side that stays.
struct Border {
  std::vector<Vec3> points, outward;
  bool closed = false;
  double undecided = 0;  // [length] so close to it a sample has no side
};

// The connected samples near a curve, each with its side.
class Band {
 public:
  Band(const CloudSide& cloud, const Border& border)
      : cloud_(cloud),
        border_(border),
        curve_(border.points, border.closed),
        zone_(cloud.points().size()) {
    for (const Vec3& p : border.points) start_at(p);
    const SurfaceGraph graph(cloud);
    for (std::size_t next = 0; next < members_.size(); ++next)
      graph.for_each_neighbor(members_[next], [&](std::uint32_t j) { add(j); });
  }

  const std::vector<std::uint32_t>& members() const { return members_; }
  Zone zone(std::uint32_t i) const { return zone_[i]; }
  // Of any sample not far from the band.
  Zone side(std::uint32_t i) const {
    const Vec3& p = cloud_.points()[i];
    return side_of(p, curve_.nearest(p, scratch_)) >= 0 ? Zone::outer : Zone::inner;
  }

 private:
  void start_at(const Vec3& x) {
    cloud_.tree().within(x, on_curve * cloud_.spacing(), scratch_);
    const std::vector<Neighbor> seeds = scratch_;
    for (const Neighbor& n : seeds) add(n.index);
  }

  void add(std::uint32_t i) {
    if (zone_[i] != Zone::none) return;
    const Vec3& p = cloud_.points()[i];
    const CurvePlace place = curve_.nearest(p, scratch_);
    if (!(place.distance < band_width * cloud_.spacing())) return;
    const double side = side_of(p, place);
    zone_[i] = std::abs(side) < border_.undecided ? Zone::middle
               : side >= 0                        ? Zone::outer
                                                  : Zone::inner;
    members_.push_back(i);
  }

  double side_of(const Vec3& p, const CurvePlace& place) const {
    const std::size_t a = place.index, b = (a + 1) % border_.points.size();
    const auto between = [&](const std::vector<Vec3>& v) {
      return v[a] + (v[b] - v[a]) * place.share;
    };
    return dot(p - between(border_.points), between(border_.outward));
  }

  const CloudSide& cloud_;
  const Border& border_;
  CurveDistance curve_;
  std::vector<Zone> zone_;
  std::vector<std::uint32_t> members_;
  mutable std::vector<Neighbor> scratch_;
};

// Spreads over the samples beyond one rim of the band.
class Flood {
 public:
  Flood(const CloudSide& cloud, const Band& band, Zone from)
      : graph_(cloud), band_(band), from_(from), seen_(cloud.points().size(), 0) {
    for (const std::uint32_t i : band.members())
      if (band.zone(i) == from)
        graph_.for_each_neighbor(i, [&](std::uint32_t j) {
          if (band.zone(j) == Zone::none && band.side(j) == from) reach(j);
        });
  }

  bool done() const { return next_ == reached_.size(); }
  void step() {
    graph_.for_each_neighbor(reached_[next_++], [&](std::uint32_t j) { reach(j); });
  }
  /// It has come to the other rim.
  bool came_round() const { return came_round_; }
  const std::vector<std::uint32_t>& reached() const { return reached_; }

 private:
  void reach(std::uint32_t i) {
    const Zone zone = band_.zone(i);
    if (zone != Zone::none) {
      came_round_ |= zone != Zone::middle && zone != from_;
      return;
    }
    if (seen_[i]) return;
    seen_[i] = 1;
    reached_.push_back(i);
  }

  SurfaceGraph graph_;
  const Band& band_;
  Zone from_;
  std::vector<char> seen_;
  std::vector<std::uint32_t> reached_;
  std::size_t next_ = 0;
  bool came_round_ = false;
};

// Mean of the cosines between the direction and the way from X into the cloud.
double agreement(const BorderLoop& loop, const Vec3& keep) {
  const Vec3 direction = normalized(keep);
  double sum = 0;
  for (const Strand& s : loop.strands) sum += dot(s.toward_cloud, direction);
  return sum / static_cast<double>(loop.strands.size());
}

// In the coordinates of the input, to about a hundredth of the spacing.
std::string place_text(const CloudSide& cloud, const Vec3& p) {
  const Vec3 place = p + cloud.mls().origin();
  const int digits =
      std::clamp(2 - static_cast<int>(std::floor(std::log10(cloud.spacing()))), 0, 12);
  const double unit = std::pow(10, -digits);
  const auto rounded = [&](double x) { return std::round(x / unit) * unit + 0.0; };
  std::array<char, 128> text{};
  std::snprintf(text.data(), text.size(), "(%.*f, %.*f, %.*f)", digits, rounded(place.x), digits,
                rounded(place.y), digits, rounded(place.z));
  return text.data();
}

// Whether the cloud goes on beyond that end of an open loop.
bool ends_inside(const CloudSide& cloud, const Vec3& end, const Vec3& before) {
  std::vector<Neighbor> found;
  const Vec3 beyond = end + normalized(end - before) * (beyond_end * cloud.spacing());
  cloud.tree().nearest(beyond, 1, found);
  return found.front().squared_distance < std::pow(at_hand * cloud.spacing(), 2);
}

// Where an open loop ends though the cloud goes on.
std::vector<std::string> ends_inside(const CloudSide& cloud, const BorderLoop& loop) {
  std::vector<std::string> places;
  const std::vector<Strand>& s = loop.strands;
  if (loop.closed || s.size() < 2) return places;
  const std::size_t last = s.size() - 1, step = std::min(last, end_direction);
  if (ends_inside(cloud, s[0].x, s[step].x)) places.push_back(place_text(cloud, s[0].x));
  if (ends_inside(cloud, s[last].x, s[last - step].x))
    places.push_back(place_text(cloud, s[last].x));
  return places;
}

[[noreturn]] void encloses_nothing(const CloudSide& cloud, const BorderLoop& loop) {
  const std::string start = "the intersection does not cut the cloud in two: ";
  const std::vector<std::string> places = ends_inside(cloud, loop);
  if (places.empty())
    throw NoResultError(start + (loop.closed ? "it is closed" : "it runs from border to border") +
                        ", but the cloud goes round it, as round a handle; cut the cloud into "
                        "pieces that the face divides");
  std::string where = places.front();
  if (places.size() > 1) where += " and at " + places.back();
  throw NoResultError(start + "it ends inside the cloud at " + where +
                      ", and beyond that no side can stay and the other go; extend the face in "
                      "the CAD program to where the cloud ends, fill the cloud if it has a hole "
                      "there, or cut the cloud off");
}

}  // namespace

int choose_side(const CloudSide& cloud, const BorderLoop& loop, const std::optional<Vec3>& keep) {
  if (keep) {
    const double agrees = agreement(loop, *keep);
    if (std::abs(agrees) >= says_little) return agrees > 0 ? loop.side : -loop.side;
  }
  Border crossing{{}, {}, loop.closed, rim * cloud.spacing()};
  for (const Strand& s : loop.strands) {
    crossing.points.push_back(s.x);
    crossing.outward.push_back(s.toward_cloud);
  }
  const Band band(cloud, crossing);
  Flood outer(cloud, band, Zone::outer), inner(cloud, band, Zone::inner);
  while (!outer.done() && !inner.done()) {
    inner.step();
    if (!inner.done()) outer.step();
  }
  const Flood& smaller = inner.done() ? inner : outer;
  if (smaller.came_round()) encloses_nothing(cloud, loop);
  return inner.done() ? loop.side : -loop.side;
}

void remove_enclosed(const CloudSide& cloud, const BorderLoop& loop, std::vector<char>& removed) {
  Border rim_of_collar{{}, {}, loop.closed, 0};
  for (const Strand& s : loop.strands) {
    rim_of_collar.points.push_back(s.beta);
    rim_of_collar.outward.push_back(-normalized(s.beta_handle));
  }
  const Band band(cloud, rim_of_collar);
  Flood flood(cloud, band, Zone::inner);
  while (!flood.done()) flood.step();
  if (flood.came_round()) encloses_nothing(cloud, loop);
  for (const std::uint32_t i : band.members())
    if (band.zone(i) == Zone::inner) removed[i] = 1;
  for (const std::uint32_t i : flood.reached()) removed[i] = 1;
}

}  // namespace spigolo
