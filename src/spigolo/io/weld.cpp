// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/weld.cpp
#include "spigolo/io/weld.h"

#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "spigolo/core/error.h"

namespace spigolo {
namespace {

constexpr std::uint32_t free_slot = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t first_slots = 16;

std::uint64_t bits(double v) { return std::bit_cast<std::uint64_t>(v); }

bool same(const Vec3& a, const Vec3& b) {
  return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z);
}

std::uint64_t hash(const Vec3& p) {
  std::uint64_t h = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    h = (h ^ bits(p[axis])) * 0x9e3779b97f4a7c15u;
    h ^= h >> 29;
  }
  return h * 0xbf58476d1ce4e5b9u >> 8;
}

double canonical(double v) { return std::isnan(v) ? not_a_number : v == 0 ? 0.0 : v; }

}  // namespace

std::size_t Welder::slot_of(const Vec3& p) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hash(p) & mask;
  while (slots_[slot] != free_slot && !same(points_[slots_[slot]], p)) slot = (slot + 1) & mask;
  return slot;
}

void Welder::grow() {
  slots_.assign(slots_.empty() ? first_slots : slots_.size() * 2, free_slot);
  for (std::size_t i = 0; i < points_.size(); ++i)
    slots_[slot_of(points_[i])] = static_cast<std::uint32_t>(i);
}

std::uint32_t Welder::index(Vec3 p) {
  if (2 * (points_.size() + 1) > slots_.size()) grow();
  p = {canonical(p.x), canonical(p.y), canonical(p.z)};
  const std::size_t slot = slot_of(p);
  if (slots_[slot] == free_slot) {
    if (points_.size() == free_slot) throw MemoryError("more than 2^32 - 1 different vertices");
    slots_[slot] = static_cast<std::uint32_t>(points_.size());
    points_.push_back(p);
  }
  return slots_[slot];
}

std::vector<Vec3> Welder::take() {
  slots_ = {};
  return std::exchange(points_, {});
}

}  // namespace spigolo
