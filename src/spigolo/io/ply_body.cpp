// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/ply_body.cpp
#include "spigolo/io/ply_body.h"

#include <limits>

#include "spigolo/core/error.h"

namespace spigolo {

// Both walkers offer number(type), length(type) and skip(type, n), and throw InputError at the end.
class PlyBody::AsciiWalker {
 public:
  explicit AsciiWalker(PlyBody& body) : words_(body.words_) {}
  double number(ScalarType type) { return words_.number(type); }
  std::uint64_t length(ScalarType) { return words_.count(); }
  void skip(ScalarType, std::uint64_t n) {
    for (std::uint64_t i = 0; i < n; ++i) words_.word();
  }
  [[noreturn]] void fail(const std::string& problem) { words_.fail(problem); }

 private:
  WordReader& words_;
};

class PlyBody::BinaryWalker {
 public:
  explicit BinaryWalker(PlyBody& body) : body_(body) {}
  double number(ScalarType type) {
    const std::size_t at = body_.at_;
    skip(type, 1);
    return load_scalar(body_.input_.bytes.data() + at, type, body_.order_);
  }
  std::uint64_t length(ScalarType type) {
    const double length = number(type);
    if (length < 0) fail("a list has a negative length; the file is damaged");
    return static_cast<std::uint64_t>(length);
  }
  void skip(ScalarType type, std::uint64_t n) {
    if (n > (body_.input_.size() - body_.at_) / size_of(type))
      fail("the file is cut off here; fetch it again or export it anew");
    body_.at_ += n * size_of(type);
  }
  [[noreturn]] void fail(const std::string& problem) {
    throw InputError(body_.input_.name, "byte " + std::to_string(body_.at_), problem);
  }

 private:
  PlyBody& body_;
};

namespace {

// Reads the scalars of one row into the columns and steps over its lists.
template <class Walker>
void read_row(Walker& walker, const PlyElementHeader& element,
              std::vector<std::vector<double>>& columns) {
  for (std::size_t p = 0; p < element.properties.size(); ++p) {
    const PlyProperty& property = element.properties[p];
    if (property.is_list())
      walker.skip(property.type, walker.length(*property.count_type));
    else
      columns[p].push_back(walker.number(property.type));
  }
}

template <class Walker>
void skip_property(Walker& walker, const PlyProperty& property) {
  walker.skip(property.type, property.is_list() ? walker.length(*property.count_type) : 1);
}

template <class Walker>
void skip_rows(Walker& walker, const PlyElementHeader& element) {
  for (std::uint64_t row = 0; row < element.count; ++row)
    for (const PlyProperty& property : element.properties) skip_property(walker, property);
}

template <class Walker>
void read_indices(Walker& walker, const PlyProperty& property, std::vector<std::uint32_t>& list) {
  constexpr double highest = std::numeric_limits<std::uint32_t>::max();
  list.clear();
  const std::uint64_t length = walker.length(*property.count_type);
  for (std::uint64_t i = 0; i < length; ++i) {
    const double index = walker.number(property.type);
    if (!(index >= 0 && index <= highest))
      walker.fail("a face names a vertex with a negative or impossible number");
    list.push_back(static_cast<std::uint32_t>(index));
  }
}

template <class Walker>
void read_list_rows(Walker& walker, const PlyElementHeader& element, std::size_t wanted,
                    const std::function<void(std::span<const std::uint32_t>)>& visit) {
  std::vector<std::uint32_t> list;
  for (std::uint64_t row = 0; row < element.count; ++row) {
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      if (p == wanted)
        read_indices(walker, element.properties[p], list);
      else
        skip_property(walker, element.properties[p]);
    }
    visit(list);
  }
}

}  // namespace

PlyBody::PlyBody(const InputBytes& input, const PlyHeader& header)
    : input_(input),
      ascii_(header.ascii),
      order_(header.order),
      at_(header.body),
      words_(input.name, input.text().substr(header.body), header.lines + 1) {}

bool PlyBody::at_end() { return ascii_ ? words_.at_end() : at_ == input_.size(); }

// Refuses a count that the remaining bytes cannot hold, before anything is allocated for it.
void PlyBody::check_room(const PlyElementHeader& element) {
  const std::size_t rest = ascii_ ? words_.rest() : input_.size() - at_;
  // In ascii a number takes a character and, but for the last, a blank.
  const std::size_t row = ascii_ ? 2 * element.properties.size() : element.least_row_size();
  const std::size_t room = row == 0 ? 0 : (rest + (ascii_ ? 1 : 0)) / row;
  if (row == 0 || element.count <= room) return;
  const std::string place = ascii_ ? "header" : "byte " + std::to_string(at_ + room * row);
  throw InputError(input_.name, place,
                   "the header claims " + std::to_string(element.count) + " rows of '" +
                       element.name + "', the file has room for at most " + std::to_string(room) +
                       "; it is cut off or damaged, fetch it again");
}

std::vector<std::vector<double>> PlyBody::read_fixed_rows(const PlyElementHeader& element) {
  const std::size_t stride = element.least_row_size();
  std::vector<std::vector<double>> columns(element.properties.size());
  const std::byte* first = input_.bytes.data() + at_;
  for (std::size_t p = 0; p < columns.size(); ++p) {
    columns[p].resize(element.count);
    load_column(first, stride, element.properties[p].type, order_, columns[p]);
    first += size_of(element.properties[p].type);
  }
  at_ += element.count * stride;
  return columns;
}

std::vector<std::vector<double>> PlyBody::read_columns(const PlyElementHeader& element) {
  if (element.properties.empty()) return {};
  check_room(element);
  if (!ascii_ && !element.has_list()) return read_fixed_rows(element);
  std::vector<std::vector<double>> columns(element.properties.size());
  for (std::size_t p = 0; p < columns.size(); ++p)
    if (!element.properties[p].is_list()) columns[p].reserve(element.count);
  AsciiWalker ascii(*this);
  BinaryWalker binary(*this);
  for (std::uint64_t row = 0; row < element.count; ++row) {
    if (ascii_)
      read_row(ascii, element, columns);
    else
      read_row(binary, element, columns);
  }
  return columns;
}

void PlyBody::read_lists(const PlyElementHeader& element, std::size_t property,
                         const std::function<void(std::span<const std::uint32_t>)>& visit) {
  check_room(element);
  AsciiWalker ascii(*this);
  BinaryWalker binary(*this);
  if (ascii_)
    read_list_rows(ascii, element, property, visit);
  else
    read_list_rows(binary, element, property, visit);
}

void PlyBody::skip(const PlyElementHeader& element) {
  if (element.properties.empty()) return;
  check_room(element);
  AsciiWalker ascii(*this);
  BinaryWalker binary(*this);
  if (ascii_)
    skip_rows(ascii, element);
  else if (element.has_list())
    skip_rows(binary, element);
  else
    at_ += element.count * element.least_row_size();
}

}  // namespace spigolo
