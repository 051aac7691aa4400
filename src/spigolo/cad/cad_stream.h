// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/cad/cad_stream.h - CAD faces as bytes, between two processes of one machine
#pragma once

#include <string>
#include <string_view>

#include "spigolo/cad/cad_file.h"

namespace spigolo {

std::string encode(const CadSummary& summary);
std::string encode(const NurbsFace& face);

/// Throw Error if the bytes are not what encode() made: too short, too long, counts that cannot be,
/// a face that is not valid. Never read beyond the bytes.
CadSummary decode_summary(std::string_view bytes);
NurbsFace decode_face(std::string_view bytes);

/// One answer of the reading process: what it is, then its bytes.
enum class CadAnswer : std::uint32_t {
  done,  // a summary or a face
  input_error,
  no_result,
  usage_error,
  out_of_memory,
  failed  // these: a message
};

struct CadAnswerHead {
  CadAnswer kind = CadAnswer::failed;
  std::uint64_t size = 0;  // of the bytes that follow
};

}  // namespace spigolo
