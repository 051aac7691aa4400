// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// fuzz/fuzz_las.cpp - any bytes into the las reader
#include <cstdint>

#include "reader_contract.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  spigolo::check_reader(bytes, spigolo::FileFormat::las, false);
  return 0;
}
