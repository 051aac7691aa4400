// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/core/parallel.h - the only door to threads
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <string_view>
#include <vector>

#include "spigolo/core/job.h"

namespace spigolo {

/// Calls body(begin, end) for disjoint ranges that cover [0, count), in any order, on job.threads
/// threads. A body writes only what belongs to its own range, so the result is the same for any
/// number of threads. Reports progress as `stage` (no report if it is empty) and throws Cancelled
/// between two ranges when the job is stopped. The first exception of a body is passed on.
/// grain: the longest range handed out; at least 1.
void parallel_for(const Job& job, std::string_view stage, std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t begin, std::size_t end)>& body);

/// The number of threads a job will use.
int thread_count(const Job& job);

/// What body(begin, end, found) appends to `found` for the ranges of [0, count), all of it in the
/// order of the ranges, so the same for any number of threads.
template <class Item, class Body>
std::vector<Item> parallel_collect(const Job& job, std::size_t count, std::size_t grain,
                                   const Body& body, std::string_view stage = "") {
  grain = std::max<std::size_t>(grain, 1);
  std::vector<std::vector<Item>> found((count + grain - 1) / grain);
  parallel_for(job, stage, count, grain,
               [&](std::size_t begin, std::size_t end) { body(begin, end, found[begin / grain]); });
  std::size_t total = 0;
  for (const std::vector<Item>& part : found) total += part.size();
  std::vector<Item> all;
  all.reserve(total);
  for (std::vector<Item>& part : found) {
    all.insert(all.end(), std::make_move_iterator(part.begin()),
               std::make_move_iterator(part.end()));
    std::vector<Item>().swap(part);
  }
  return all;
}

/// n value-initialized items. The system hands out their memory, which takes most of the time that
/// a large array costs, to all threads at once.
template <class Item>
std::vector<Item> parallel_array(const Job& job, std::size_t n) {
  constexpr std::size_t page = 4096, pages = 1024;
  std::vector<Item> items;
  items.reserve(n);
  auto* const memory = reinterpret_cast<std::byte*>(items.data());
  parallel_for(job, "", n * sizeof(Item), page * pages, [&](std::size_t begin, std::size_t end) {
    for (std::size_t at = begin; at < end; at += page) memory[at] = std::byte{0};
  });
  items.resize(n);
  return items;
}

/// All i of [0, count) with is_one(i), ascending.
template <class Predicate>
std::vector<std::uint32_t> parallel_select(const Job& job, std::size_t count, std::size_t grain,
                                           const Predicate& is_one) {
  return parallel_collect<std::uint32_t>(
      job, count, grain,
      [&](std::size_t begin, std::size_t end, std::vector<std::uint32_t>& found) {
        for (std::size_t i = begin; i < end; ++i)
          if (is_one(i)) found.push_back(static_cast<std::uint32_t>(i));
      });
}

/// How many i of [0, count) there are with is_one(i).
template <class Predicate>
std::size_t parallel_count(const Job& job, std::size_t count, std::size_t grain,
                           const Predicate& is_one) {
  std::size_t total = 0;
  for (const std::size_t part : parallel_collect<std::size_t>(
           job, count, grain, [&](std::size_t begin, std::size_t end, auto&found) {
             std::size_t n = 0;
             for (std::size_t i = begin; i < end; ++i) n += is_one(i) ? 1 : 0;
             found.push_back(n);
           }))
    total += part;
  return total;
}

}  // namespace spigolo
