// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/cad_report.cpp
#include "cad_report.h"

#include "report.h"

namespace spigolo {
namespace {

Json range_json(const Interval& range) { return Json::array({range.begin, range.end}); }

std::string range_text(const char* name, const Interval& range, bool closed) {
  return std::string("  ") + name + " " + number_text(range.begin) + " to " +
         number_text(range.end) + (closed ? " closed" : "");
}

}  // namespace

Json cad_json(const std::string& path, const CadFile& file) {
  Json json = {{"file", path}, {"format", file.format()}, {"unit", file.unit()}};
  json["bounds"] = file.bounds().empty() ? Json()
                                         : Json{{"min", to_json(file.bounds().min)},
                                                {"max", to_json(file.bounds().max)}};
  json["free_curves"] = file.free_curves();
  json["free_points"] = file.free_points();
  json["faces"] = Json::array();
  for (const CadFaceInfo& face : file.faces())
    json["faces"].push_back({{"type", face.type},
                             {"area", face.area},
                             {"u", range_json(face.u)},
                             {"v", range_json(face.v)},
                             {"closed_u", face.closed_u},
                             {"closed_v", face.closed_v},
                             {"periodic_u", face.periodic_u},
                             {"periodic_v", face.periodic_v},
                             {"trimmed", face.trimmed}});
  return json;
}

std::string face_lines(const CadFile& file) {
  std::string text;
  for (std::size_t i = 0; i < file.faces().size(); ++i) {
    const CadFaceInfo& face = file.faces()[i];
    text += "face " + std::to_string(i) + "  " + face.type + "  area " + number_text(face.area) +
            range_text("u", face.u, face.closed_u) + range_text("v", face.v, face.closed_v) +
            (face.trimmed ? "  trimmed" : "") + "\n";
  }
  return text;
}

std::string cad_text(const std::string& path, const CadFile& file) {
  std::string text = "file        " + path + "\nformat      " + file.format() + "\nunit        " +
                     (file.unit().empty() ? "not given" : file.unit()) + "\n";
  const Box& box = file.bounds();
  const auto line = [](const Vec3& v) {
    return number_text(v.x) + "  " + number_text(v.y) + "  " + number_text(v.z) + "\n";
  };
  if (!box.empty()) text += "from        " + line(box.min) + "to          " + line(box.max);
  text += "curves      " + count_text(file.free_curves()) + "\npoints      " +
          count_text(file.free_points()) + "\nfaces       " + count_text(file.faces().size()) +
          "\n";
  return text + face_lines(file);
}

}  // namespace spigolo
