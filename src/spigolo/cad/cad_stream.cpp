// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/cad/cad_stream.cpp
#include "spigolo/cad/cad_stream.h"

#include <cstring>
#include <type_traits>

#include "spigolo/core/error.h"

namespace spigolo {
namespace {

class Writer {
 public:
  template <class T>
  void put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void put_flag(bool flag) { put(static_cast<std::uint8_t>(flag)); }
  void put_count(std::size_t count) { put(static_cast<std::uint64_t>(count)); }
  void put_text(const std::string& text) {
    put_count(text.size());
    bytes_ += text;
  }
  template <class T>
  void put_all(const std::vector<T>& values) {
    put_count(values.size());
    for (const T& value : values) put(value);
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  template <class T>
  T get() {
    static_assert(std::is_trivially_copyable_v<T>);
    T value{};
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  bool flag() { return get<std::uint8_t>() != 0; }
  // Of things that take at least `each` bytes.
  std::size_t count(std::size_t each) {
    const auto count = get<std::uint64_t>();
    if (count > bytes_.size() / each) damaged();
    return static_cast<std::size_t>(count);
  }
  std::string text() { return std::string(take(count(1))); }
  template <class T>
  std::vector<T> all() {
    std::vector<T> values(count(sizeof(T)));
    for (T& value : values) value = get<T>();
    return values;
  }
  void end() const {
    if (!bytes_.empty()) damaged();
  }

 private:
  std::string_view take(std::size_t size) {
    if (size > bytes_.size()) damaged();
    const std::string_view out = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return out;
  }
  [[noreturn]] static void damaged() {
    throw Error("what the process that reads CAD files says is damaged");
  }

  std::string_view bytes_;
};

void put_info(const CadFaceInfo& info, Writer& out) {
  out.put_text(info.type);
  out.put(info.area);
  out.put(info.u);
  out.put(info.v);
  for (const bool flag :
       {info.closed_u, info.closed_v, info.periodic_u, info.periodic_v, info.trimmed})
    out.put_flag(flag);
  out.put(info.bounds);
}

CadFaceInfo get_info(Reader& in) {
  CadFaceInfo info;
  info.type = in.text();
  info.area = in.get<double>();
  info.u = in.get<Interval>();
  info.v = in.get<Interval>();
  for (bool* flag :
       {&info.closed_u, &info.closed_v, &info.periodic_u, &info.periodic_v, &info.trimmed})
    *flag = in.flag();
  info.bounds = in.get<Box>();
  return info;
}

void put_surface(const NurbsSurface& s, Writer& out) {
  out.put(s.degree_u);
  out.put(s.degree_v);
  out.put_all(s.knots_u);
  out.put_all(s.knots_v);
  out.put_count(s.poles_u);
  out.put_count(s.poles_v);
  out.put_all(s.poles);
  out.put_all(s.weights);
  out.put(s.period_u);
  out.put(s.period_v);
}

NurbsSurface get_surface(Reader& in) {
  NurbsSurface s;
  s.degree_u = in.get<int>();
  s.degree_v = in.get<int>();
  s.knots_u = in.all<double>();
  s.knots_v = in.all<double>();
  s.poles_u = static_cast<std::size_t>(in.get<std::uint64_t>());
  s.poles_v = static_cast<std::size_t>(in.get<std::uint64_t>());
  s.poles = in.all<Vec3>();
  s.weights = in.all<double>();
  s.period_u = in.get<double>();
  s.period_v = in.get<double>();
  return s;
}

}  // namespace

std::string encode(const CadSummary& summary) {
  Writer out;
  out.put_text(summary.format);
  out.put_text(summary.unit);
  out.put_count(summary.faces.size());
  for (const CadFaceInfo& info : summary.faces) put_info(info, out);
  out.put_count(summary.free_curves);
  out.put_count(summary.free_points);
  out.put(summary.bounds);
  return out.take();
}

CadSummary decode_summary(std::string_view bytes) {
  Reader in(bytes);
  CadSummary summary;
  summary.format = in.text();
  summary.unit = in.text();
  const std::size_t faces = in.count(sizeof(Box));
  for (std::size_t i = 0; i < faces; ++i) summary.faces.push_back(get_info(in));
  summary.free_curves = static_cast<std::size_t>(in.get<std::uint64_t>());
  summary.free_points = static_cast<std::size_t>(in.get<std::uint64_t>());
  summary.bounds = in.get<Box>();
  in.end();
  return summary;
}

std::string encode(const NurbsFace& face) {
  Writer out;
  put_surface(face.surface, out);
  out.put(face.u);
  out.put(face.v);
  for (const bool flag : {face.closed_u, face.closed_v, face.reversed}) out.put_flag(flag);
  out.put_count(face.trims.size());
  for (const TrimCurve& trim : face.trims) out.put_all(trim);
  return out.take();
}

NurbsFace decode_face(std::string_view bytes) {
  Reader in(bytes);
  NurbsFace face;
  face.surface = get_surface(in);
  face.u = in.get<Interval>();
  face.v = in.get<Interval>();
  for (bool* flag : {&face.closed_u, &face.closed_v, &face.reversed}) *flag = in.flag();
  const std::size_t trims = in.count(sizeof(std::uint64_t));
  for (std::size_t i = 0; i < trims; ++i) face.trims.push_back(in.all<ParamPoint>());
  in.end();
  validate(face);
  return face;
}

}  // namespace spigolo
