#include "core/nesting/sheets/used_sheet.h"

#include <algorithm>
#include <utility>

#include "core/nesting/filling/fill.h"
#include "core/nesting/filling/lying.h"
#include "core/nesting/layout/piece_set.h"
#include "core/nesting/shelves.h"

namespace selvage::nesting::sheets {
namespace {

bool fits(const Marker& bare, std::size_t shape, SumCache& sums) {
  Marker alone = bare;
  alone.pieces.clear();
  alone.unplaced = {{.id = "alone", .shape = {static_cast<std::uint32_t>(shape)}, .orientation = {}, .at = {}}};
  const auto set = layout::piece_set_of(alone, layout::PlacedPiecesMay::kMove, sums);
  if (!set) return false;
  const double room = static_cast<double>(*bare.strip.last()) / set->lattice_units - set->low;
  const auto& turned = set->kind(0).turned;
  return std::any_of(turned.begin(), turned.end(), [room](const auto& one) { return one.box.width() <= room; });
}

}  // namespace

Result<ReadySheet> ready(const Marker& marker, const Sheet& sheet, SumCache& sums) {
  auto empty = bare(marker, sheet);
  if (!empty) return empty.error();
  ReadySheet made{.sheet = &sheet, .bare = *std::move(empty), .area = area_of(sheet)};
  for (std::size_t shape = 0; shape < marker.shapes.size(); ++shape) {
    made.shape_fits.push_back(fits(made.bare, shape, sums));
  }
  return made;
}

Filled filled(const ReadySheet& sheet, const UsedSheet& present, const std::vector<std::size_t>& more,
              const FillTask& task, const scene::Run& run) {
  Filled result{.used = present};
  std::vector<std::size_t> named = present.pieces;
  Marker start = sheet.bare;
  const std::size_t walls = start.pieces.size();
  start.pieces.insert(start.pieces.end(), present.placed.begin(), present.placed.end());
  for (const std::size_t piece : more) {
    if (!sheet.shape_fits[task.pieces[piece].shape.value]) continue;
    named.push_back(piece);
    start.unplaced.push_back(on_sheet(task.pieces[piece], task.marker, *sheet.sheet));
  }
  for (const std::size_t piece : present.pieces) result.value += task.values[piece];
  if (named.size() == present.pieces.size()) return result;

  const auto set = layout::piece_set_of(start, layout::PlacedPiecesMay::kMove, run.sums);
  Marker endless = start;
  endless.strip = start.strip.ending(std::nullopt);
  auto all = set ? on_shelves(endless, *set, std::vector<bool>(start.pieces.size(), true)) : set.error();
  if (!all) return result;  // the shelves would not fit the lattice
  all->strip = start.strip;
  filling::FillSettings settings{.values = std::vector<double>(walls),
                                 .seed = task.seed,
                                 .map_bytes = task.tuning.map_bytes,
                                 .over = task.over,
                                 .search = task.tuning.search,
                                 .tuning = task.tuning.fill};
  for (const std::size_t piece : named) settings.values.push_back(task.values[piece]);
  std::vector<bool> lies = filling::pieces_before(*all, *start.strip.last());
  const filling::Filling done = fill({.marker = *std::move(all), .lies = std::move(lies)}, *set, settings, run);

  result = {.used = {.kind = present.kind, .pieces = {}, .placed = {}},
            .value = done.value,
            .moves = done.moves,
            .programs = done.programs};
  for (std::size_t k = 0; k < named.size(); ++k) {
    if (!done.lies[walls + k]) continue;
    result.used.pieces.push_back(named[k]);
    result.used.placed.push_back(done.marker.pieces[walls + k]);
  }
  return result;
}

}  // namespace selvage::nesting::sheets
