// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/report.cpp
#include "report.h"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace spigolo::bench {
namespace {

std::string row_of(const std::vector<std::string>& cells) {
  std::string row = "|";
  for (const std::string& cell : cells) row += " " + cell + " |";
  return row + "\n";
}

}  // namespace

std::string number(double value, int digits) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*f", digits, value);
  return buffer;
}

Report::Report(const std::string& title, const std::string& paragraph) {
  heading(1, title);
  text(paragraph);
}

void Report::append(const Report& other) {
  out_ << other.out_.str();
  tables_.insert(tables_.end(), other.tables_.begin(), other.tables_.end());
}

void Report::heading(int level, const std::string& text) {
  out_ << std::string(static_cast<std::size_t>(level), '#') << ' ' << text << "\n\n";
  section_.resize(static_cast<std::size_t>(level) - 1);
  section_.push_back(text);
}

void Report::text(const std::string& paragraph) { out_ << paragraph << "\n\n"; }

void Report::table(const std::vector<std::string>& head,
                   const std::vector<std::vector<std::string>>& rows) {
  out_ << row_of(head) << row_of(std::vector<std::string>(head.size(), "---"));
  for (const auto& row : rows) out_ << row_of(row);
  out_ << "\n";
  tables_.push_back({section_, head, rows});
}

std::string Report::json() const {
  nlohmann::json list = nlohmann::json::array();
  for (const Table& table : tables_)
    list.push_back({{"section", table.section}, {"head", table.head}, {"rows", table.rows}});
  return nlohmann::json{{"tables", list}}.dump(1) + "\n";
}

}  // namespace spigolo::bench
