// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/cad_report.h - what a CAD file holds, as JSON and as text
#pragma once

#include <string>

#include "command_line.h"
#include "spigolo/cad/cad_file.h"

namespace spigolo {

Json cad_json(const std::string& path, const CadFile& file);
std::string cad_text(const std::string& path, const CadFile& file);

/// One line a face: number, type, area, ranges, closed or trimmed.
std::string face_lines(const CadFile& file);

}  // namespace spigolo
