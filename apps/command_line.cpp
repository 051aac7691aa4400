// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/command_line.cpp
#include "command_line.h"

#include <algorithm>
#include <iostream>

#include "spigolo/core/error.h"
#include "spigolo/io/atomic_file.h"
#include "spigolo/io/input_bytes.h"
#include "suggest.h"

namespace spigolo {
namespace {

std::string with_underscores(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

std::string with_dashes(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

std::string long_name(const CLI::Option* option) {
  return option->get_lnames().empty() ? "" : option->get_lnames().front();
}

Json parse_json(const std::string& file) {
  const FileBytes bytes(file);
  try {
    Json json = Json::parse(bytes.view().text());
    if (json.is_object()) return json;
  } catch (const Json::parse_error& error) {
    throw InputError(file, "byte " + std::to_string(error.byte),
                     "is not JSON; a parameter file is what --save-params writes");
  }
  throw InputError(file, "", "should hold one JSON object of option names and values");
}

// What the command line would hold for a value of the parameter file.
std::string argument_text(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

}  // namespace

CommandLine::CommandLine(const VerbHelp& help, CommonOptions& common)
    : help_(help), app_(help.purpose, "spigolo " + help.name), common_(common) {
  app_.footer("Example:\n  " + help.example);
  app_.get_formatter()->column_width(34);
}

CLI::Option* CommandLine::switch_parameter(const std::string& names, bool& value,
                                           const std::string& help) {
  CLI::Option* option = app_.add_flag(names, value, help);
  parameters_.push_back({option, [&value] { return Json(value); }});
  return option;
}

bool CommandLine::parse(const Arguments& arguments) {
  add_common_options(app_, common_);  // last, as the help shows them
  parameters_.push_back({app_.get_option("--seed"), [this] { return Json(common_.seed); }});
  try {
    parse_checked(arguments);
    return true;
  } catch (const CLI::CallForHelp&) {
    std::cout << app_.help() << std::flush;
    return false;
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what());
  }
}

void CommandLine::parse_checked(const Arguments& arguments) {
  check_names(arguments);
  app_.parse(Arguments(arguments.rbegin(), arguments.rend()));  // CLI11 takes them last first
  if (!common_.params.empty()) load(common_.params);
  check_common_options(common_);
}

// Before anything else: a wrong name explains what else seems wrong.
void CommandLine::check_names(const Arguments& arguments) const {
  for (const std::string& argument : arguments) {
    if (argument == "--") return;
    if (!argument.starts_with("--")) continue;
    const std::string name = argument.substr(2, argument.find('=') - 2);
    const auto names = option_names();
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const std::string nearest = nearest_name(name, names);
    throw UsageError("unknown option '--" + name + "'" +
                     (nearest.empty() ? "" : "; did you mean '--" + nearest + "'?"));
  }
}

std::vector<std::string> CommandLine::option_names() const {
  std::vector<std::string> names;
  for (const CLI::Option* option : app_.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back(name);
  return names;
}

void CommandLine::load(const std::string& file) {
  const Json json = parse_json(file);
  for (const auto& [name, value] : json.items()) {
    if (name != "verb") {
      load_one(file, with_dashes(name), value);
    } else if (value != help_.name) {
      throw UsageError(file + " holds parameters of '" + argument_text(value) + "', not of '" +
                       help_.name + "'");
    }
  }
}

void CommandLine::load_one(const std::string& file, const std::string& name, const Json& value) {
  std::vector<std::string> names;
  for (const Parameter& p : parameters_) names.push_back(long_name(p.option));
  const auto it = std::find(names.begin(), names.end(), name);
  if (it == names.end())
    throw UsageError(file + ": '" + help_.name + "' has no parameter '" + name + "'" +
                     suggestion(name, names));
  CLI::Option* option = parameters_[static_cast<std::size_t>(it - names.begin())].option;
  if (option->count() > 0 || value.is_null()) return;  // the command line wins
  try {
    if (!value.is_array()) option->add_result(argument_text(value));
    if (value.is_array())
      for (const Json& one : value) option->add_result(argument_text(one));
    if (option->count() > 0) option->run_callback();
  } catch (const CLI::ParseError& error) {
    throw UsageError(file + ": " + error.what());
  }
}

Json CommandLine::parameters() const {
  Json json = Json::object();
  for (const Parameter& p : parameters_) json[with_underscores(long_name(p.option))] = p.value();
  return json;
}

void save_parameters(const CommonOptions& common, const VerbHelp& help, const Json& parameters) {
  if (common.save_params.empty()) return;
  Json json = {{"verb", help.name}};
  json.update(parameters);
  AtomicFile file(common.save_params);
  file.write(json.dump(2) + "\n");
  file.commit();
}

}  // namespace spigolo
