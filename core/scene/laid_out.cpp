#include "core/scene/laid_out.h"

#include <map>

#include "core/marker/validity.h"

namespace selvage::scene {

LaidOut::LaidOut(const Marker& marker, SumCache& sums) : LaidOut{marker, Run{sums}} {}

LaidOut::LaidOut(const Marker& marker, const Run& run)
    : pieces{marker},
      outlines{outlines_of(marker, run)},
      parts{parts_of(marker, run.sums)},
      ties{model::ties_of(marker)},
      figures{figures_of(marker, pieces)} {}

// The cache compares whole polygons, so pieces of the same shape and orientation share one look-up.
std::vector<outline::OrientedOutline> outlines_of(const Marker& marker, SumCache& sums) {
  std::map<std::pair<ShapeId, Orientation>, outline::OrientedOutline> known;
  std::vector<outline::OrientedOutline> outlines;
  outlines.reserve(marker.pieces.size());
  for (std::uint32_t i = 0; i < marker.pieces.size(); ++i) {
    const Piece& piece = marker.pieces[i];
    const auto [at, fresh] = known.try_emplace({piece.shape, piece.orientation});
    if (fresh) at->second = oriented_outline(marker, PieceId{i}, sums);
    outlines.push_back(at->second);
  }
  return outlines;
}

std::vector<outline::OrientedOutline> outlines_of(const Marker& marker, const Run& run) {
  run.observer.on_stage(Stage::kDecomposition);
  auto outlines = outlines_of(marker, run.sums);
  run.observer.on_stage(Stage::kOther);
  return outlines;
}

std::vector<outline::OrientedOutline> parts_of(const Marker& marker, SumCache& sums) {
  std::vector<outline::OrientedOutline> parts;
  for (std::size_t i = 0; i < marker.pieces.size(); ++i) {
    if (!marker.pieces[i].rules.part) continue;
    parts.resize(marker.pieces.size());
    parts[i] = marker::oriented_part(marker.pieces[i], sums);
  }
  return parts;
}

marker::Figures figures_after(const Marker& before, const LaidOut& laid_out, const Marker& after) {
  return laid_out.figures.valid ? figures_after(before, laid_out.pieces, laid_out.figures, after) : figures_of(after);
}

}  // namespace selvage::scene
