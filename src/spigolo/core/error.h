// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/core/error.h - what can go wrong, one type for each thing the caller can do about it
#pragma once

#include <stdexcept>
#include <string>

namespace spigolo {

/// Base of everything spigolo throws. what() is one readable sentence: what, where, and the remedy.
/// Thrown as itself for a failure inside (a bug, or numerics); exit status 1 of the program.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An option or argument out of its range, or an output that cannot be created; exit status 2.
class UsageError : public Error {
 public:
  using Error::Error;
};

/// An input file is missing, unreadable, damaged or not what it claims; exit status 3.
/// what() names the file, the place in it and the remedy.
class InputError : public Error {
 public:
  /// place: "line 12", "byte 340", "header"; may be empty.
  InputError(const std::string& file, const std::string& place, const std::string& problem)
      : Error(place.empty() ? file + ": " + problem : file + ", " + place + ": " + problem) {}
};

/// The input is sound but no result can be had from it (fewer than four points, all points on one
/// line); exit status 4.
class NoResultError : public Error {
 public:
  using Error::Error;
};

/// More memory would be needed than there is, or than the caller allowed; exit status 5.
class MemoryError : public Error {
 public:
  using Error::Error;
};

/// The caller's stop token was triggered; exit status 130.
class Cancelled : public Error {
 public:
  Cancelled() : Error("cancelled") {}
};

}  // namespace spigolo
