// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/report.h - docs/results.md as it is written: sections, tables, numbers
#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace spigolo::bench {

/// Number with so many digits behind the point.
std::string number(double value, int digits = 0);

/// A Markdown document that grows section by section.
class Report {
 public:
  void heading(int level, const std::string& text);
  void text(const std::string& paragraph);
  void table(const std::vector<std::string>& head,
             const std::vector<std::vector<std::string>>& rows);
  std::string str() const { return out_.str(); }
  /// All tables: {"tables": [{"section": [headings ...], "head": [...], "rows": [[...] ...]} ...]}.
  std::string json() const;

 private:
  struct Table {
    std::vector<std::string> section, head;
    std::vector<std::vector<std::string>> rows;
  };
  std::ostringstream out_;
  std::vector<std::string> section_;  // headings that stand over what comes next
  std::vector<Table> tables_;
};

}  // namespace spigolo::bench
