// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/glb_writer.cpp - binary glTF 2.0 (Khronos, 2021): header, JSON, one buffer
#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <string>

#include "spigolo/core/error.h"
#include "spigolo/io/scalar.h"
#include "spigolo/io/shaded_mesh.h"
#include "spigolo/io/text.h"

namespace spigolo {
namespace {

constexpr std::uint32_t magic = 0x46546c67, version = 2, json_chunk = 0x4e4f534a,
                        bin_chunk = 0x004e4942;
constexpr int float_type = 5126, uint_type = 5125, vertex_target = 34962, index_target = 34963;

using Float3 = std::array<float, 3>;

Float3 narrow3(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

// Vertices as a viewer wants them: one for each normal.
struct Buffers {
  std::vector<Float3> position, normal;
  std::vector<std::uint32_t> triangles, lines;
  std::vector<Float3> line_position;
};

class Splitter {
 public:
  std::uint32_t vertex(std::uint32_t v, const Vec3& at, const Vec3& n, Buffers& out) {
    const Float3 normal = narrow3(n);
    if (v >= first_.size()) first_.resize(v + std::size_t{1}, none);
    std::uint32_t* place = &first_[v];
    while (*place != none && out.normal[*place] != normal) place = &next_[*place];
    if (*place == none) {
      *place = static_cast<std::uint32_t>(out.position.size());
      const std::uint32_t made = *place;
      out.position.push_back(narrow3(at));
      out.normal.push_back(normal);
      next_.push_back(none);  // may move what `place` points to
      return made;
    }
    return *place;
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffu;
  std::vector<std::uint32_t> first_, next_;  // splits of a vertex, as a list
};

Buffers split(const ShadedMesh& shaded, const Vec3& center) {
  Buffers out;
  Splitter splitter;
  const auto& points = shaded.mesh.vertices.points;
  for (std::size_t t = 0; t < shaded.mesh.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = shaded.mesh.triangles[t][i];
      out.triangles.push_back(
          splitter.vertex(v, points[v] - center, shaded.corner_normals[t][i], out));
    }
  std::vector<std::uint32_t> number(points.size(), 0xffffffffu);
  for (const auto& edge : shaded.creases)
    for (const std::uint32_t v : edge) {
      if (number[v] == 0xffffffffu) {
        number[v] = static_cast<std::uint32_t>(out.line_position.size());
        out.line_position.push_back(narrow3(points[v] - center));
      }
      out.lines.push_back(number[v]);
    }
  return out;
}

std::string numbers(std::initializer_list<double> values) {
  std::string text = "[";
  for (const double x : values) {
    if (text.size() > 1) text += ',';
    append_number(text, x, ScalarType::float64);
  }
  return text + "]";
}

// The JSON and the bytes grow together.
class Document {
 public:
  template <class T>
  void view(const std::vector<T>& data, int target) {
    const std::size_t size = data.size() * sizeof(T);
    views_ += (views_.empty() ? "" : ",") + std::string("{\"buffer\":0,\"byteOffset\":") +
              std::to_string(bytes_) + ",\"byteLength\":" + std::to_string(size) +
              ",\"target\":" + std::to_string(target) + "}";
    parts_.push_back({reinterpret_cast<const char*>(data.data()), size});
    bytes_ += size;
  }
  void vectors(const std::vector<Float3>& data, bool bounds) {
    std::string extra;
    if (bounds) {
      Box box;
      for (const Float3& p : data) box.add({p[0], p[1], p[2]});
      extra = ",\"min\":" + numbers({box.min.x, box.min.y, box.min.z}) +
              ",\"max\":" + numbers({box.max.x, box.max.y, box.max.z});
    }
    accessor(float_type, data.size(), "VEC3", extra);
    view(data, vertex_target);
  }
  void indices(const std::vector<std::uint32_t>& data) {
    accessor(uint_type, data.size(), "SCALAR", "");
    view(data, index_target);
  }

  std::string json(bool lines, const Vec3& center) const {
    std::string meshes =
        R"({"name":"surface","primitives":[{"attributes":{"POSITION":0,"NORMAL":1},"indices":2,"material":0}]})";
    if (lines)
      meshes +=
          R"(,{"name":"creases","primitives":[{"attributes":{"POSITION":3},"indices":4,"mode":1,"material":1}]})";
    const std::string shift = ",\"translation\":" + numbers({center.x, center.y, center.z}) + "}";
    return R"({"asset":{"version":"2.0","generator":"spigolo"},"scene":0,"scenes":[{"nodes":[0)" +
           std::string(lines ? ",1" : "") + R"(]}],"nodes":[{"mesh":0)" + shift +
           (lines ? ",{\"mesh\":1" + shift : "") + R"(],"meshes":[)" + meshes +
           R"(],"materials":[{"name":"surface","doubleSided":true,"pbrMetallicRoughness":{"baseColorFactor":[0.72,0.74,0.78,1],"metallicFactor":0.1,"roughnessFactor":0.7}},{"name":"creases","pbrMetallicRoughness":{"baseColorFactor":[0.8,0.1,0.05,1],"metallicFactor":0}}],"buffers":[{"byteLength":)" +
           std::to_string(bytes_) + R"(}],"bufferViews":[)" + views_ + R"(],"accessors":[)" +
           accessors_ + "]}";
  }
  std::size_t bytes() const { return bytes_; }
  void write(AtomicFile& out) const {
    for (const std::string_view part : parts_) out.write(part);
  }

 private:
  void accessor(int component, std::size_t count, const char* type, const std::string& extra) {
    accessors_ +=
        (accessors_.empty() ? "" : ",") + std::string("{\"bufferView\":") +
        std::to_string(parts_.size()) + ",\"componentType\":" + std::to_string(component) +
        ",\"count\":" + std::to_string(count) + ",\"type\":\"" + type + "\"" + extra + "}";
  }

  std::string views_, accessors_;
  std::vector<std::string_view> parts_;
  std::size_t bytes_ = 0;
};

void write_words(AtomicFile& out, std::initializer_list<std::uint32_t> words) {
  for (const std::uint32_t word : words) {
    std::byte bytes[sizeof word];
    store(bytes, word);
    out.write({reinterpret_cast<const char*>(bytes), sizeof bytes});
  }
}

}  // namespace

void write_glb(AtomicFile& out, const ShadedMesh& shaded, WriteReport& report) {
  static_assert(std::endian::native == std::endian::little, "buffers are written as they lie");
  if (shaded.mesh.triangles.empty()) throw UsageError("GLB holds triangles and there are none");
  for (const Attribute& a : shaded.mesh.vertices.attributes) report.dropped.push_back(a.name);
  const Vec3 center = bounding_box(shaded.mesh.vertices.points).center();
  for (const Vec3& p : shaded.mesh.vertices.points)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double x = p[axis] - center[axis];
      report.rounding = std::max(report.rounding, std::abs(x - static_cast<float>(x)));
    }
  const Buffers buffers = split(shaded, center);
  Document document;
  document.vectors(buffers.position, true);
  document.vectors(buffers.normal, false);
  document.indices(buffers.triangles);
  const bool lines = !buffers.lines.empty();
  if (lines) {
    document.vectors(buffers.line_position, true);
    document.indices(buffers.lines);
  }
  std::string json = document.json(lines, center);
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::size_t total = 12 + 8 + json.size() + 8 + document.bytes();
  if (total > std::numeric_limits<std::uint32_t>::max())
    throw UsageError("a GLB file holds 4 GB at most; write .ply instead");
  write_words(out, {magic, version, static_cast<std::uint32_t>(total)});
  write_words(out, {static_cast<std::uint32_t>(json.size()), json_chunk});
  out.write(json);
  write_words(out, {static_cast<std::uint32_t>(document.bytes()), bin_chunk});
  document.write(out);
}

}  // namespace spigolo
