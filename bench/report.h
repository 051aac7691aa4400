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
  /// A page of that title, and the paragraph under it.
  Report(const std::string& title, const std::string& paragraph);
  /// What comes under `title` on another page, without the title itself.
  explicit Report(const std::string& title) : section_{title} {}

  void heading(int level, const std::string& text);
  void text(const std::string& paragraph);
  void table(const std::vector<std::string>& head,
             const std::vector<std::vector<std::string>>& rows);
  /// Everything of the other one behind what is here.
  void append(const Report& other);
  std::string str() const { return out_.str(); }
  struct Table {
    std::vector<std::string> section, head;  // section: headings that stand over it
    std::vector<std::vector<std::string>> rows;
  };
  const std::vector<Table>& tables() const { return tables_; }
  /// All tables: {"tables": [{"section": [headings ...], "head": [...], "rows": [[...] ...]} ...]}.
  std::string json() const;

 private:
  std::ostringstream out_;
  std::vector<std::string> section_;  // headings that stand over what comes next
  std::vector<Table> tables_;
};

}  // namespace spigolo::bench
