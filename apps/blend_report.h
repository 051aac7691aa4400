// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/blend_report.h - how a blend went, as JSON and as text
#pragma once

#include <string>

#include "command_line.h"
#include "spigolo/blend/blend.h"

namespace spigolo {

Json blend_json(const Blend& blend, const std::string& method, const Json& parameters);
std::string blend_text(const Blend& blend, const std::string& method, double seconds);

}  // namespace spigolo
