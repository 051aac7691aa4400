// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/suggest.h - what the user may have meant
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace spigolo {

/// The candidate nearest to `word` by edit distance; empty if none is near enough to be meant.
std::string nearest_name(std::string_view word, const std::vector<std::string>& candidates);

/// "; did you mean 'X'?" or nothing.
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

/// "a, b, c".
std::string joined(const std::vector<std::string>& words);

}  // namespace spigolo
