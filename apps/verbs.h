// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/verbs.h - one function a verb: reads its arguments, calls one front door, writes the result
#pragma once

#include <string>
#include <vector>

namespace spigolo {

/// They throw what the library throws; main() turns that into messages and exit status.
void run_info(const std::vector<std::string>& arguments);
void run_detect(const std::vector<std::string>& arguments);
void run_lines(const std::vector<std::string>& arguments);
void run_mesh(const std::vector<std::string>& arguments);
void run_blend(const std::vector<std::string>& arguments);
void run_compare(const std::vector<std::string>& arguments);
void run_synth(const std::vector<std::string>& arguments);
void run_render(const std::vector<std::string>& arguments);
void run_smooth(const std::vector<std::string>& arguments);
void run_convert(const std::vector<std::string>& arguments);

}  // namespace spigolo
