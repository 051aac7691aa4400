// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/sheet_places.cpp
#include "spigolo/sheets/sheet_places.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "spigolo/core/parallel.h"
#include "spigolo/sheets/bend.h"
#include "spigolo/sheets/label_hints.h"
#include "spigolo/sheets/separate.h"
#include "spigolo/sheets/sheet_model.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 16;
// [spacings] size of a place, small against the reach of a look.
constexpr double least_size = 1.4, size_per_smoothing = 0.25;
constexpr double alike = 1e-6;  // [spacings] what rounding may change, when a cloud is turned
constexpr int sweeps = 2;       // neighbors' sheets reach so many places farther
constexpr std::size_t most_tried = 2;  // neighbors' sheets that are fitted
constexpr std::size_t glance = 4;      // of so many points one tells whether that is worth it
constexpr double worth = 1.25;         // a glance's score may be worse by that
constexpr int try_rounds = 2;
// Each further sheet, found or left out: it may lie anywhere, so some place is found where it
// explains the noise.
constexpr double price_of_sheet = 15;
// [spacings] with more noise, sheets that might be one are one: two of them would follow the noise.
constexpr double noise_joins = 0.4;
constexpr int label_rounds = 4, fold_rounds = 4;
constexpr double better = 2;  // by how much a score must be better to count

double size_of_place(const ProbeReach& reach) {
  return least_size + size_per_smoothing * reach.smoothing;
}

// Points in an order that a turned, moved or scaled cloud has too: by their spacing, the
// largest first, which takes the fewest places; points alike in that in the canonical order.
std::vector<std::uint32_t> by_spacing(const Spacing& spacing) {
  std::vector<std::pair<std::int64_t, std::uint32_t>> keyed(spacing.of_point.size());
  for (std::uint32_t i = 0; i < keyed.size(); ++i)
    keyed[i] = {std::llround(-spacing.of_point[i] / (alike * spacing.of_cloud)), i};
  std::sort(keyed.begin(), keyed.end());
  std::vector<std::uint32_t> order;
  for (const auto& [_, i] : keyed) order.push_back(i);
  return order;
}

// A point of the order that no place has taken yet is one, and takes the points near it from places
// that are farther away.
void choose_places(SheetModel& model, double size) {
  SheetPlaces& places = model.places;
  const std::span<const Vec3> points = model.points();
  places = {};
  places.of_point.assign(model.size(), no_point);
  std::vector<double> away(model.size(), infinity);  // squared, from the point's place
  std::uint32_t entries = 0;
  for (const std::uint32_t i : by_spacing(model.prepared.spacing)) {
    if (places.of_point[i] != no_point) continue;
    const auto number = static_cast<std::uint32_t>(places.point.size());
    places.point.push_back(i);
    places.known.push_back(model.plain[i] ? no_point : entries++);
    const double limit = size * model.prepared.spacing.of_point[i];
    const auto take = [&](std::uint32_t j) {
      const double off = squared_distance(points[i], points[j]);
      if (off < limit * limit && off < away[j]) places.of_point[j] = number, away[j] = off;
    };
    take(i);
    for (const std::uint32_t j : model.prepared.neighborhoods.of(i)) take(j);
  }
  places.sheets.resize(entries);
}

LocalSheets without(LocalSheets sheets, std::size_t s) {
  for (std::size_t i = s; i + 1 < sheets.count; ++i) sheets.sheet[i] = sheets.sheet[i + 1];
  --sheets.count;
  sheets.data_sides.fill(~std::uint64_t{0});  // not known yet
  return sheets;
}

bool any_bent(const LocalSheets& sheets) {
  return std::any_of(sheets.sheet.begin(), sheets.sheet.begin() + sheets.count,
                     [](const Sheet& s) { return s.is_curved(); });
}

// One thread's means to find the sheets of one place after the other.
class PlaceWork {
 public:
  PlaceWork(const SheetModel& model, const KdTree& tree, const ProbeReach& reach, double noise)
      : model_(model), tree_(tree), reach_(reach), separator_(model, noise) {}

  PlaceSheets find(std::uint32_t place) {
    gather(place);
    const bool joined = separator_.separate(region_);
    PlaceSheets found{region_.sheets, reach_, separator_.score(region_)};
    if (joined && model_.tolerances.noise < noise_joins) {
      separator_.separate(region_, false);
      take_if_better(found);
    }
    if (labels_help(model_.tolerances.noise)) try_labels(found);
    return found;
  }

  // The same without each of its sheets; a fold; then what places near it have.
  PlaceSheets improve(std::uint32_t place, const std::vector<PlaceSheets>& last) {
    const SheetPlaces& places = model_.places;
    PlaceSheets best = last[places.known[place]];
    gather(place);
    region_.sheets = best.sheets;
    best.score = separator_.score(region_);
    try_fewer(best);
    try_fold(best);
    for (const std::uint32_t other : worth_trying(place, last))
      try_sheets(last[places.known[other]].sheets, best);
    return best;
  }

  // Halves the look while the sheets fit badly: a thin part is too much for one quadric a sheet.
  PlaceSheets narrow(std::uint32_t place, PlaceSheets found) {
    if (!separator_.fits_badly(found.sheets)) return found;
    gather(place);
    while (halve(region_)) {
      separator_.separate(region_);
      found = {region_.sheets, {region_.smoothing, region_.points.size()}, 0};
      if (!separator_.fits_badly(found.sheets)) break;
    }
    return found;
  }

 private:
  void gather(std::uint32_t place) {
    gather_region(model_, tree_, model_.points()[model_.places.point[place]], reach_, region_);
  }

  void try_labels(PlaceSheets& best) {
    const LocalSheets labelled = sheets_of_labels(model_, region_);
    if (labelled.count < 2) return;
    separator_.start_from(labelled, region_, label_rounds, true);
    take_if_better(best);
    try_fewer(best);
  }

  void try_fewer(PlaceSheets& best) {
    const LocalSheets own = best.sheets;
    for (std::size_t s = 0; s < own.count && own.count > 1; ++s) try_sheets(without(own, s), best);
  }

  // A single look often bends a sheet over a crease of little bend, and no neighbor knows better.
  void try_fold(PlaceSheets& best) {
    if (best.sheets.count > 2 || !any_bent(best.sheets)) return;
    separator_.take_one(region_);
    take_if_better(best);
    const std::optional<LocalSheets> fold = fold_at_bend(region_, region_.sheets.sheet[0]);
    if (!fold) return;
    separator_.start_from(*fold, region_, fold_rounds);
    take_if_better(best);
  }

  void try_sheets(const LocalSheets& sheets, PlaceSheets& best) {
    separator_.start_from(sheets, region_, try_rounds);
    take_if_better(best);
  }

  void take_if_better(PlaceSheets& best) {
    const double score = separator_.score(region_);
    const double more =
        static_cast<double>(region_.sheets.count) - static_cast<double>(best.sheets.count);
    if (score < best.score - price_of_sheet * more - better)
      best.score = score, best.sheets = region_.sheets;
  }

  // Places next to this one whose sheets, as they are, explain its points about as well.
  std::vector<std::uint32_t> worth_trying(std::uint32_t place,
                                          const std::vector<PlaceSheets>& last) {
    const SheetPlaces& places = model_.places;
    std::vector<std::uint32_t> others;
    for (const std::uint32_t j : model_.prepared.neighborhoods.of(places.point[place])) {
      const std::uint32_t other = places.of_point[j];
      if (other != place && places.known[other] != no_point &&
          std::find(others.begin(), others.end(), other) == others.end())
        others.push_back(other);
    }
    std::vector<std::pair<double, std::uint32_t>> scored;
    const double limit = worth * last[places.known[place]].score;
    for (const std::uint32_t other : others) {
      region_.sheets = last[places.known[other]].sheets;
      const double score = separator_.score(region_, glance);
      if (score < limit) scored.emplace_back(score, other);
    }
    std::sort(scored.begin(), scored.end());
    others.clear();
    for (std::size_t i = 0; i < std::min(most_tried, scored.size()); ++i)
      others.push_back(scored[i].second);
    return others;
  }

  const SheetModel& model_;
  const KdTree& tree_;
  ProbeReach reach_;
  SheetSeparator separator_;
  SheetRegion region_;
};

// Median deviation of the largest sheets: much noise was read as less from narrow looks.
double noise_of(const std::vector<PlaceSheets>& found) {
  std::vector<double> deviation;
  for (const PlaceSheets& place : found) {
    const Sheet* largest = nullptr;
    for (std::size_t s = 0; s < place.sheets.count; ++s)
      if (!largest || place.sheets.sheet[s].support > largest->support)
        largest = &place.sheets.sheet[s];
    if (largest) deviation.push_back(largest->deviation);
  }
  if (deviation.empty()) return 0;
  const auto middle = deviation.begin() + static_cast<std::ptrdiff_t>(deviation.size() / 2);
  std::nth_element(deviation.begin(), middle, deviation.end());
  return *middle;
}

}  // namespace

ProbeReach reach_of_places(const ProbeReach& reach) {
  const double radius = std::sqrt(static_cast<double>(reach.k) / pi) + size_of_place(reach);
  return {reach.smoothing, static_cast<std::size_t>(pi * radius * radius)};
}

void separate_places(SheetModel& model, const KdTree& tree, const ProbeReach& reach,
                     const Job& job) {
  choose_places(model, size_of_place(reach));
  std::vector<std::uint32_t> open;
  for (std::uint32_t p = 0; p < model.places.point.size(); ++p)
    if (model.places.known[p] != no_point) open.push_back(p);
  const ProbeReach wide = reach_of_places(reach);
  double& noise = model.places.noise;
  if (!model.tolerances.exact()) noise = model.tolerances.noise;
  const auto for_all = [&](const auto& work) {
    std::vector<PlaceSheets> next(open.size());
    parallel_for(job, "sheets", open.size(), grain, [&](std::size_t begin, std::size_t end) {
      PlaceWork own(model, tree, wide, noise);
      for (std::size_t i = begin; i < end; ++i) next[i] = work(own, open[i], i);
    });
    model.places.sheets = std::move(next);
  };
  for_all([](PlaceWork& work, std::uint32_t p, std::size_t) { return work.find(p); });
  if (!model.tolerances.exact())
    noise = std::max(model.tolerances.noise, noise_of(model.places.sheets));
  for (int sweep = 0; sweep < sweeps && !model.tolerances.exact(); ++sweep)
    for_all([&](PlaceWork& work, std::uint32_t p, std::size_t) {
      return work.improve(p, model.places.sheets);
    });
  for_all([&](PlaceWork& work, std::uint32_t p, std::size_t i) {
    return work.narrow(p, model.places.sheets[i]);
  });
}

}  // namespace spigolo
