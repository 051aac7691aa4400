// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// fuzz/fuzz_pcd.cpp - any bytes into the pcd reader
#include <cstdint>

#include "reader_contract.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  spigolo::check_reader(bytes, spigolo::FileFormat::pcd, false);
  return 0;
}
