// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/chains.cpp
#include "spigolo/trace/chains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "spigolo/trace/place_grid.h"

namespace spigolo {
namespace {

constexpr double step = 0.9;           // [spacings] between the samples of a chain
constexpr double noisy_step = 2;       // [scatters] more where samples scatter
constexpr double reach = 4.5;          // [spacings] to the next sample of a chain
constexpr double smallest_radius = 3;  // [spacings] of a crease that is followed round
constexpr double most_bend = 0.26;     // sine of the largest bend at either end of a step
constexpr double least_bend = 0.06;    // [rad] allowed whatever the distance
constexpr double bend_cost = 4;        // a bend of 1 rad costs as much as so many lengths
constexpr double same_cosine = 0.8;    // of directions of one crease, for thinning
constexpr std::uint32_t none = 0xffffffffu;

using Ends = std::array<std::uint32_t, 2>;  // behind (against the direction) and ahead

// The samples that stay, by weight; within a step of each other only where directions differ.
std::vector<std::uint32_t> thin(std::span<const CreaseSample> samples, const PlaceGrid& grid,
                                double least_step) {
  std::vector<std::uint32_t> order(samples.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return samples[a].weight > samples[b].weight;
  });
  std::vector<char> kept(samples.size(), 0);
  for (const std::uint32_t i : order) {
    bool free = true;
    grid.within(samples[i].place, least_step, [&](std::uint32_t j) {
      if (kept[j] && std::abs(dot(samples[i].direction, samples[j].direction)) > same_cosine)
        free = false;
    });
    kept[i] = free;
  }
  std::vector<std::uint32_t> stay;
  for (std::uint32_t i = 0; i < samples.size(); ++i)
    if (kept[i]) stay.push_back(i);
  return stay;
}

struct Link {
  double cost = 0;
  std::uint32_t a = 0, b = 0;
  std::uint8_t side_a = 0, side_b = 0;  // 0 behind, 1 ahead
};

// How a step from a to b leaves and arrives; nothing if it turns too sharply.
std::optional<Link> try_link(const CreaseSample& a, const CreaseSample& b, double scatter) {
  const Vec3 d = b.place - a.place;
  const double length = norm(d);
  if (length <= 0) return std::nullopt;
  const Vec3 c = d / length;
  const double ahead = dot(a.direction, c), arriving = dot(b.direction, c);
  const double bend_a = std::acos(std::min(1.0, std::abs(ahead)));
  const double bend_b = std::acos(std::min(1.0, std::abs(arriving)));
  const double limit = std::asin(std::min(most_bend, length / (2 * smallest_radius))) + least_bend +
                       std::min(0.2, scatter * (0.5 + 1 / length));
  if (bend_a > limit || bend_b > limit) return std::nullopt;
  Link link;
  link.cost = length * (1 + bend_cost * (bend_a + bend_b));
  link.side_a = ahead > 0 ? 1 : 0;
  link.side_b = arriving > 0 ? 0 : 1;
  return link;
}

std::vector<Link> possible_links(std::span<const CreaseSample> nodes, double scatter) {
  std::vector<Vec3> places;
  for (const CreaseSample& node : nodes) places.push_back(node.place);
  const PlaceGrid grid(places, reach);
  std::vector<Link> links;
  for (std::uint32_t i = 0; i < nodes.size(); ++i)
    grid.within(nodes[i].place, reach, [&](std::uint32_t j) {
      if (j <= i) return;
      auto link = try_link(nodes[i], nodes[j], scatter);
      if (!link) return;
      link->a = i, link->b = j;
      links.push_back(*link);
    });
  std::sort(links.begin(), links.end(), [](const Link& x, const Link& y) {
    return std::tie(x.cost, x.a, x.b) < std::tie(y.cost, y.a, y.b);
  });
  return links;
}

// Cheapest first; each end of each sample takes part once.
std::vector<Ends> choose(std::size_t count, const std::vector<Link>& links) {
  std::vector<Ends> next(count, Ends{none, none});
  for (const Link& link : links) {
    std::uint32_t& from = next[link.a][link.side_a];
    std::uint32_t& to = next[link.b][link.side_b];
    if (from != none || to != none) continue;
    if (next[link.a][1 - link.side_a] == link.b) continue;  // there and back is no curve
    from = link.b;
    to = link.a;
  }
  return next;
}

// From a node away from where it was come from, to the end or round to the start.
Chain walk(std::span<const CreaseSample> nodes, const std::vector<Ends>& next, std::uint32_t start,
           std::vector<char>& seen) {
  Chain chain;
  std::uint32_t from = none, at = start;
  while (at != none && !seen[at]) {
    seen[at] = 1;
    chain.places.push_back(nodes[at].place);
    const std::uint32_t to = next[at][0] == from ? next[at][1] : next[at][0];
    from = at;
    at = to;
  }
  chain.closed = at == start && chain.places.size() > 2;
  return chain;
}

}  // namespace

double Chain::length() const {
  double sum = closed ? distance(places.back(), places.front()) : 0;
  for (std::size_t i = 1; i < places.size(); ++i) sum += distance(places[i - 1], places[i]);
  return sum;
}

std::vector<Chain> link_samples(std::span<const CreaseSample> samples, double scatter) {
  std::vector<Vec3> places;
  for (const CreaseSample& s : samples) places.push_back(s.place);
  const double least_step = step + noisy_step * scatter;
  std::vector<CreaseSample> nodes;
  for (const std::uint32_t i : thin(samples, PlaceGrid(places, least_step), least_step))
    nodes.push_back(samples[i]);
  const std::vector<Ends> next = choose(nodes.size(), possible_links(nodes, scatter));
  std::vector<char> seen(nodes.size(), 0);
  std::vector<Chain> chains;
  const auto collect = [&](std::uint32_t start) {
    if (seen[start]) return;
    Chain chain = walk(nodes, next, start, seen);
    if (chain.places.size() > 1) chains.push_back(std::move(chain));
  };
  for (std::uint32_t i = 0; i < nodes.size(); ++i)
    if (next[i][0] == none || next[i][1] == none) collect(i);
  for (std::uint32_t i = 0; i < nodes.size(); ++i) collect(i);
  return chains;
}

}  // namespace spigolo
