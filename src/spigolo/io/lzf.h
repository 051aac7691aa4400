// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/lzf.h - the LZF compression of binary_compressed PCD files
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace spigolo {

/// A stream cannot grow more than this: three bytes stand for 264 at most.
inline constexpr std::size_t lzf_largest_growth = 88;

/// Fills `out` exactly; false if the stream is damaged or of another length.
bool lzf_decompress(std::span<const std::byte> in, std::span<std::byte> out);

/// A stream that decompresses to `in`; up to a 32nd longer than it. in: less than 4 GiB.
std::vector<std::byte> lzf_compress(std::span<const std::byte> in);

}  // namespace spigolo
