// Nesting on sheets that end, of given sizes and forms: as much as possible lies on them, on sheets that cost as little
// as possible, and what they have no room for is left over.  Sheets cost the same unless their costs are given; then
// as few as possible are used.
//
//     sheets that cost least for their area first, the largest of them: fill each with pieces that are not laid yet
//       (filling/fill.h)
//     the last one: exchange it for the cheapest sheet that holds its pieces, the smallest of them
//     until the budget is used up, or nothing can be gained:
//       while pieces are left over: bring them onto a sheet, in place of others that are worth less
//       then: move pieces of the sheet that holds least for its cost to another, until it is empty
//
// Laws.  (1) Every sheet is valid, proved in integers, also against its outline and its zones.  (2) Every piece lies on
// one sheet or is left over.  (3) No more sheets are used than there are.  (4) The same input and settings give the
// same answer, whatever the cache holds; with `elapsed` or when cancelled, the best so far.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/marker/marker.h"
#include "core/nesting/nest.h"
#include "core/nesting/sheets/sheet.h"
#include "core/scene/run.h"
#include "core/scene/stop_reason.h"

namespace selvage::nesting::sheets {

inline constexpr std::size_t kMostCandidates = 1'500;  // pieces that are tried on a sheet at once

struct SheetSettings {
  std::uint64_t moves{};  // budget
  std::uint64_t seed{};
  std::function<double()> elapsed{};                    // as in NestSettings
  std::map<std::string, double, std::less<>> values{};  // as in NestSettings
  NestTuning tuning{};
};

// A sheet that is used: the marker of its zones, and after them the pieces on it.  Its strip is the sheet, or the
// bounding box of its outline, and the positions count from the low corner of that.
struct SheetLayout {
  std::size_t sheet{};  // index of its kind
  double area{};        // what pieces can cover (area_of); square lattice units
  Marker marker;
};

struct SheetNesting {
  std::vector<SheetLayout> layouts;
  std::vector<Piece> left_over;
  std::uint64_t moves{};
  int programs{};
  scene::StopReason reason{};
  bool out_of_time{};  // as in Nesting
};

// All pieces of the marker are laid, including the placed ones, wherever they lie.
// Errors: kEmptyMarker when it has no piece; kOutOfRange for a piece that is locked in place, belongs to a group or is
// a zone of the marker's own cloth (`field` points into the marker); those of `bare` (below "/sheets/K").
[[nodiscard]] Result<SheetNesting> nest_on_sheets(const Marker& start, std::span<const Sheet> sheets,
                                                  const SheetSettings& settings, const scene::Run& run);

}  // namespace selvage::nesting::sheets
