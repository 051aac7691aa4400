// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/file_format.cpp
#include "spigolo/io/file_format.h"

#include <algorithm>
#include <array>

#include "spigolo/core/error.h"
#include "spigolo/io/text.h"

namespace spigolo {
namespace {

constexpr unsigned bit(FileUse use) { return 1u << static_cast<unsigned>(use); }
constexpr unsigned cloud_only = bit(FileUse::read_cloud) | bit(FileUse::write_cloud);
constexpr unsigned mesh_only = bit(FileUse::read_mesh) | bit(FileUse::write_mesh);

struct Ending {
  const char* text;
  FileFormat format;
  unsigned uses;
};

constexpr std::array<Ending, 10> endings = {{
    {".ply", FileFormat::ply, cloud_only | mesh_only},
    {".xyz", FileFormat::xyz, cloud_only},
    {".txt", FileFormat::xyz, cloud_only},
    {".csv", FileFormat::csv, cloud_only},
    {".pts", FileFormat::pts, cloud_only},
    {".obj", FileFormat::obj, cloud_only | mesh_only},
    {".off", FileFormat::off, cloud_only | mesh_only},
    {".stl", FileFormat::stl, bit(FileUse::read_cloud) | mesh_only},
    {".pcd", FileFormat::pcd, cloud_only},
    {".las", FileFormat::las, cloud_only},
}};

struct Foreign {
  const char* ending;
  const char* advice;
};

constexpr std::array<Foreign, 4> foreign_formats = {{
    {".laz",
     "compressed LAS (LAZ) is not supported; decompress it first: 'laszip -i in.laz -o out.las', "
     "or 'pip install laspy lazrs' and 'laspy decompress in.laz', or CloudCompare"},
    {".e57",
     "E57 is not supported; save the scan as .ply or .las with CloudCompare, or with PDAL: 'pdal "
     "translate in.e57 out.las'"},
    {".ptx", "PTX is not supported; save the scan as .ply or .pts with CloudCompare"},
    {".zip", "is an archive; unpack it and name the file in it"},
}};

}  // namespace

std::string known_endings(FileUse use) {
  std::string text;
  for (const Ending& e : endings)
    if (e.uses & bit(use)) text += (text.empty() ? "" : " ") + std::string(e.text);
  return text;
}

FileFormat file_format(const std::filesystem::path& path, FileUse use) {
  const std::string ending = lower(path.extension().string());
  for (const Ending& e : endings)
    if (ending == e.text && (e.uses & bit(use))) return e.format;
  const bool reading = use == FileUse::read_cloud || use == FileUse::read_mesh;
  for (const Foreign& f : foreign_formats)
    if (reading && ending == f.ending) throw InputError(path.string(), "", f.advice);
  const std::string what = ending.empty() ? "has no ending" : "has the unknown ending " + ending;
  throw UsageError(path.string() + ": the name " + what + "; known here are " + known_endings(use));
}

}  // namespace spigolo
