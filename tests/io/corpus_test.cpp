// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/io/corpus_test.cpp - the fuzzers' seeds and old crashers keep the readers' contract
#include "../../fuzz/reader_contract.h"
#include "support.h"

namespace spigolo {
namespace {

std::filesystem::path fuzz_folder() { return SPIGOLO_FUZZ_DIR; }

constexpr std::pair<const char*, FileFormat> formats[] = {
    {"ply", FileFormat::ply}, {"text", FileFormat::xyz}, {"obj", FileFormat::obj},
    {"off", FileFormat::off}, {"stl", FileFormat::stl},  {"pcd", FileFormat::pcd},
    {"las", FileFormat::las}};

bool has_mesh(FileFormat format) {
  return format == FileFormat::ply || format == FileFormat::obj || format == FileFormat::off ||
         format == FileFormat::stl;
}

std::vector<std::string> contents(const std::filesystem::path& folder) {
  std::vector<std::string> all;
  if (std::filesystem::is_directory(folder))
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      all.push_back(read_file(entry.path()));
  return all;
}

TEST(Corpus, SeedsAndRegressionsKeepTheContract) {
  for (const auto& [name, format] : formats) {
    const std::vector<std::string> seeds = contents(fuzz_folder() / "corpus" / name);
    EXPECT_FALSE(seeds.empty()) << name;
    for (const std::string& bytes : seeds)
      check_reader(as_input(bytes).bytes, format, has_mesh(format));
    for (const std::string& bytes : contents(fuzz_folder() / "regressions" / name))
      check_reader(as_input(bytes).bytes, format, has_mesh(format));
  }
}

// A poor man's fuzzer, so that every build meets a few thousand damaged files.
TEST(Corpus, SeedsWithRandomDamageKeepTheContract) {
  Random random(2026);
  for (const auto& [name, format] : formats)
    for (std::string bytes : contents(fuzz_folder() / "corpus" / name))
      for (int round = 0; round < 300; ++round) {
        std::string damaged = bytes;
        for (std::uint64_t n = random.below(4); n < 4 && !damaged.empty(); ++n) {
          const std::size_t at = random.below(damaged.size());
          if (random.below(4) == 0)
            damaged.erase(at, random.below(8));
          else
            damaged[at] = random.below(2) ? static_cast<char>(random.below(256))
                                          : bytes[random.below(bytes.size())];
        }
        check_reader(as_input(damaged).bytes, format, has_mesh(format));
      }
}

}  // namespace
}  // namespace spigolo
