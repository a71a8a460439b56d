// A sheet with the pieces that lie on it, and how more pieces are brought onto it.
// Pieces are named by their index in a list that all sheets share.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/result.h"
#include "core/marker/marker.h"
#include "core/nesting/nest.h"
#include "core/nesting/sheets/sheet.h"
#include "core/scene/run.h"

namespace selvage::nesting::sheets {

// A kind of sheet, ready for pieces.
struct ReadySheet {
  const Sheet* sheet{};
  Marker bare{};             // sheet.h
  double area{};             // square lattice units
  std::vector<bool> fits{};  // by piece: in some allowed orientation, within the room that its rules leave
};
// Errors: those of `bare`.
[[nodiscard]] Result<ReadySheet> ready(const Marker& marker, const std::vector<Piece>& pieces, const Sheet& sheet,
                                       SumCache& sums);

struct UsedSheet {
  std::size_t kind{};               // index of its ReadySheet
  std::vector<std::size_t> pieces;  // those that lie on it
  std::vector<Piece> placed;        // the same, as they lie
};

// What filling a sheet works with.
struct FillTask {
  const Marker& marker;               // shapes, spacing and so on
  const std::vector<Piece>& pieces;   // the shared list
  const std::vector<double>& values;  // of each of them; at least 0
  const NestTuning& tuning;
  std::uint64_t seed{};
  std::function<bool(std::uint64_t moves)> over;  // of this filling
};
struct Filled {
  UsedSheet used;
  double value{};  // of its pieces
  std::uint64_t moves{};
  int programs{};
};
// The sheet with pieces chosen from the present ones and `more`, worth as much as the search can achieve, and never
// less than the present ones.  Those of `more` that fit the sheet in no orientation are left out.
[[nodiscard]] Filled filled(const ReadySheet& sheet, const UsedSheet& present, const std::vector<std::size_t>& more,
                            const FillTask& task, const scene::Run& run);

}  // namespace selvage::nesting::sheets
