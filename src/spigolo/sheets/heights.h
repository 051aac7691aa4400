// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/heights.h - how far many points are from one sheet
#pragma once

#include <span>

#include "spigolo/sheets/sheet.h"

namespace spigolo {

/// out[i] = height(sheet, points[i]), to the last bit, several points at once.
void heights(const Sheet& sheet, std::span<const Vec3> points, double* out);

}  // namespace spigolo
