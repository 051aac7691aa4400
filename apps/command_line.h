// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/command_line.h - the command line of one verb: its own options and those that all verbs have
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <vector>

#include "common_options.h"

namespace spigolo {

using Json = nlohmann::ordered_json;
using Arguments = std::vector<std::string>;

/// Ways to say which command line is meant and how to use it.
struct VerbHelp {
  std::string name;     // "detect"
  std::string purpose;  // one sentence
  std::string example;  // one or more lines, without indent
};

class CommandLine {
 public:
  /// `common` receives the values of the options that all verbs have.
  CommandLine(const VerbHelp& help, CommonOptions& common);

  /// For inputs, outputs and everything else that a parameter file does not save.
  CLI::App& app() { return app_; }

  /// An option that --params may set and --save-params saves, with its default shown in the help.
  /// `value` must outlive this.
  template <typename T>
  CLI::Option* parameter(const std::string& names, T& value, const std::string& help) {
    CLI::Option* option = app_.add_option(names, value, help)->capture_default_str();
    if constexpr (std::is_unsigned_v<T>) refuse_negative(*option);
    parameters_.push_back({option, [&value] { return Json(value); }});
    return option;
  }
  CLI::Option* switch_parameter(const std::string& names, bool& value, const std::string& help);

  /// Fills all values, those of --params first; to be called once. False if help was asked for and
  /// printed. Throws UsageError, with the nearest option's name for an unknown one; InputError for
  /// a parameter file that is missing or damaged.
  bool parse(const Arguments& arguments);

  /// Name and value of every parameter in use, '-' in names as '_'.
  Json parameters() const;

 private:
  struct Parameter {
    CLI::Option* option;
    std::function<Json()> value;
  };

  void parse_checked(const Arguments& arguments);
  void check_names(const Arguments& arguments) const;
  void load(const std::string& file);
  void load_one(const std::string& file, const std::string& name, const Json& value);
  std::vector<std::string> option_names() const;

  VerbHelp help_;
  CLI::App app_;
  CommonOptions& common_;
  std::vector<Parameter> parameters_;
};

/// Writes verb and parameters to common.save_params, if that is set.
void save_parameters(const CommonOptions& common, const VerbHelp& help, const Json& parameters);

}  // namespace spigolo
