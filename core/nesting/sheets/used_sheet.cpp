#include "core/nesting/sheets/used_sheet.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/marker/validity.h"
#include "core/nesting/filling/fill.h"
#include "core/nesting/filling/lying.h"
#include "core/nesting/layout/piece_set.h"
#include "core/nesting/start/shelves.h"

namespace selvage::nesting::sheets {
namespace {

// Whether the piece fits on the sheet alone, in some orientation.
bool fits(const Marker& bare, const Piece& piece, SumCache& sums) {
  Marker alone = bare;
  alone.pieces.clear();
  alone.unplaced = {piece};
  const auto set = layout::piece_set_of(alone, layout::PlacedPiecesMay::kMove, sums);
  return set && set->kind(0).fits_before(static_cast<double>(*bare.strip.last()) / set->lattice_units);
}

// By piece; pieces of one shape without rules are tested once.
std::vector<bool> fitting(const Marker& bare, const std::vector<Piece>& pieces, SumCache& sums) {
  std::map<ShapeId, bool> of_shape;
  std::vector<bool> all;
  for (const Piece& piece : pieces) {
    if (piece.rules != marker::Rules{}) {
      all.push_back(fits(bare, piece, sums));
      continue;
    }
    const auto [found, fresh] = of_shape.try_emplace(piece.shape);
    if (fresh) found->second = fits(bare, {.id = "alone", .shape = piece.shape, .orientation = {}, .at = {}}, sums);
    all.push_back(found->second);
  }
  return all;
}

// Shelves do not look at zones, which come first: pieces that lie over one are taken off.
void take_off_zones(const Marker& all, std::size_t zones, std::vector<bool>& lies) {
  std::vector<std::size_t> lying;  // in their order
  for (std::size_t i = 0; i < lies.size(); ++i) {
    if (lies[i]) lying.push_back(i);
  }
  for (const marker::Overlap& overlap : marker::overlaps_unmeasured(filling::with_lying_pieces(all, lies))) {
    if (overlap.first.value < zones) lies[lying[overlap.second.value]] = false;
  }
}

}  // namespace

Result<ReadySheet> ready(const Marker& marker, const std::vector<Piece>& pieces, const Sheet& sheet, SumCache& sums) {
  auto empty = bare(marker, sheet);
  if (!empty) return empty.error();
  ReadySheet made{.sheet = &sheet, .bare = *std::move(empty), .area = area_of(sheet)};
  made.fits = fitting(made.bare, pieces, sums);
  return made;
}

Filled filled(const ReadySheet& sheet, const UsedSheet& present, const std::vector<std::size_t>& more,
              const FillTask& task, const scene::Run& run) {
  Filled result{.used = present};
  std::vector<std::size_t> named = present.pieces;
  Marker start = sheet.bare;
  const std::size_t zones = start.pieces.size();
  start.pieces.insert(start.pieces.end(), present.placed.begin(), present.placed.end());
  for (const std::size_t piece : more) {
    if (!sheet.fits[piece]) continue;
    named.push_back(piece);
    start.unplaced.push_back(task.pieces[piece]);
  }
  for (const std::size_t piece : present.pieces) result.value += task.values[piece];
  if (named.size() == present.pieces.size()) return result;

  const auto set = layout::piece_set_of(start, layout::PlacedPiecesMay::kMove, run.sums);
  Marker endless = start;
  endless.strip = start.strip.ending(std::nullopt);
  auto all = set ? start::on_shelves(endless, *set, std::vector<bool>(start.pieces.size(), true)) : set.error();
  if (!all) return result;  // the shelves would not fit the lattice
  all->strip = start.strip;
  filling::FillSettings settings{.values = std::vector<double>(zones),
                                 .seed = task.seed,
                                 .map_bytes = task.tuning.map_bytes,
                                 .room = sheet.area,
                                 .over = task.over,
                                 .search = task.tuning.search,
                                 .tuning = task.tuning.fill};
  for (const std::size_t piece : named) settings.values.push_back(task.values[piece]);
  std::vector<bool> lies = filling::pieces_before(*all, *start.strip.last());
  take_off_zones(*all, zones, lies);
  if (!is_valid(filling::with_lying_pieces(*all, lies))) {  // shelves do not always keep bands and shades
    std::fill(lies.begin() + static_cast<std::ptrdiff_t>(zones + present.placed.size()), lies.end(), false);
  }
  const filling::Filling done = fill({.marker = *std::move(all), .lies = std::move(lies)}, *set, settings, run);

  result = {.used = {.kind = present.kind, .pieces = {}, .placed = {}},
            .value = done.value,
            .moves = done.moves,
            .programs = done.programs};
  for (std::size_t k = 0; k < named.size(); ++k) {
    if (!done.lies[zones + k]) continue;
    result.used.pieces.push_back(named[k]);
    result.used.placed.push_back(done.marker.pieces[zones + k]);
  }
  return result;
}

}  // namespace selvage::nesting::sheets
