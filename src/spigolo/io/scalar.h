// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/scalar.h - numbers as they lie in binary files
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <type_traits>

#include "spigolo/core/point_cloud.h"

namespace spigolo {

enum class ByteOrder : std::uint8_t { little, big };

/// Calls f with a value of the C++ type that `type` names.
template <class F>
decltype(auto) with_type(ScalarType type, F&& f) {
  switch (type) {
    case ScalarType::int8:
      return f(std::int8_t{});
    case ScalarType::uint8:
      return f(std::uint8_t{});
    case ScalarType::int16:
      return f(std::int16_t{});
    case ScalarType::uint16:
      return f(std::uint16_t{});
    case ScalarType::int32:
      return f(std::int32_t{});
    case ScalarType::uint32:
      return f(std::uint32_t{});
    case ScalarType::float32:
      return f(float{});
    case ScalarType::float64:
      break;
  }
  return f(double{});
}

inline std::size_t size_of(ScalarType type) {
  return with_type(type, [](auto value) { return sizeof value; });
}
inline bool is_integer(ScalarType type) { return type < ScalarType::float32; }

/// The number at `from`, which need not be aligned. The caller has checked that it lies in bounds.
template <class T>
T load(const std::byte* from, ByteOrder order = ByteOrder::little) {
  std::byte bytes[sizeof(T)];
  constexpr ByteOrder native =
      std::endian::native == std::endian::little ? ByteOrder::little : ByteOrder::big;
  for (std::size_t i = 0; i < sizeof(T); ++i)
    bytes[i] = from[order == native ? i : sizeof(T) - 1 - i];
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

inline double load_scalar(const std::byte* from, ScalarType type, ByteOrder order) {
  return with_type(type,
                   [&](auto tag) { return static_cast<double>(load<decltype(tag)>(from, order)); });
}

/// out[i] = the number at from + i * stride; all of them lie in bounds.
inline void load_column(const std::byte* from, std::size_t stride, ScalarType type, ByteOrder order,
                        std::span<double> out) {
  with_type(type, [&](auto tag) {
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = static_cast<double>(load<decltype(tag)>(from + i * stride, order));
  });
}

/// The nearest value of T: integers saturate and take 0 for NaN; floats overflow to infinity.
template <class T>
T narrow(double value) {
  if constexpr (std::is_same_v<T, double>) {
    return value;
  } else if constexpr (std::is_same_v<T, float>) {
    if (std::isfinite(value) && std::abs(value) > std::numeric_limits<float>::max())
      return static_cast<float>(std::copysign(std::numeric_limits<double>::infinity(), value));
    return static_cast<float>(value);
  } else {
    constexpr auto lowest = static_cast<double>(std::numeric_limits<T>::min());
    constexpr auto highest = static_cast<double>(std::numeric_limits<T>::max());
    if (!(value > lowest)) return std::isnan(value) ? T{0} : std::numeric_limits<T>::min();
    return value >= highest ? std::numeric_limits<T>::max() : static_cast<T>(std::round(value));
  }
}

/// Writes a number in little-endian order.
template <class T>
void store(std::byte* to, T value) {
  std::memcpy(to, &value, sizeof(T));
  if constexpr (std::endian::native == std::endian::big)
    for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(to[i], to[sizeof(T) - 1 - i]);
}

/// Writes get(i) for i in [0, count) at to + i * stride, narrowed to `type`.
template <class Get>
void store_column(std::byte* to, std::size_t stride, ScalarType type, std::size_t count, Get get) {
  with_type(type, [&](auto tag) {
    for (std::size_t i = 0; i < count; ++i) store(to + i * stride, narrow<decltype(tag)>(get(i)));
  });
}

}  // namespace spigolo
