// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/radix_sort.h - keys by their code, stable, on all threads
#pragma once

#include <cstdint>
#include <vector>

#include "spigolo/core/job.h"

namespace spigolo {

struct CodeKey {
  std::uint64_t code;
  std::uint32_t index;
};

inline constexpr int radix_digit_bits = 11;

/// Sorts by `digits` digits of radix_digit_bits each, from bit `lowest` of the code on; keys alike
/// in them keep their order. Linear in the number of keys; takes as much memory again.
void radix_sort(std::vector<CodeKey>& keys, int lowest, int digits, const Job& job = {});

}  // namespace spigolo
