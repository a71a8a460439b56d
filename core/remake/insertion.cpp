#include "core/remake/insertion.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/marker/clearance.h"
#include "core/matching/pairing.h"
#include "core/motion/placing/place.h"
#include "core/remake/substitution/area.h"
#include "core/scene/scene.h"

namespace selvage::remake {
namespace {

using substitution::area_of;

struct Found {
  Piece piece;
  Coord end{};  // of the marker with it
  double distance{};
};

// The best position in one orientation.
std::optional<Found> found_in(const Marker& marker, Piece piece, const Orientation& orientation, const Homes& homes,
                              const scene::Run& run) {
  piece.orientation = orientation;
  if (!may_lie(marker, piece)) return std::nullopt;
  const Box box = box_of(oriented(marker.shapes[piece.shape.value].outline, orientation));
  const Box room = marker.strip.room(kLatticeLimit);
  const auto home = homes.find(piece.id);
  const bool kept = home != homes.end() && home->second.orientation == orientation;
  piece.locked = {};
  piece.at = kept ? home->second.at : Vec{room.low.x - box.low.x, room.low.y - box.low.y};
  Marker with = marker;
  with.pieces.push_back(piece);
  with.unplaced.clear();
  const scene::Scene scene{std::move(with), run.sums};
  const PieceId last{static_cast<std::uint32_t>(scene.marker.pieces.size() - 1)};
  const auto place = motion::placing::place(scene, last, piece.at, {.may_grow = true, .tuning = {}});
  if (!place) return std::nullopt;
  piece.at = place->at;
  return Found{piece, std::max(length_of(marker), place->at.x + box.high.x), place->distance};
}

std::optional<Found> best_of(const Marker& marker, const Piece& piece, const Homes& homes, const scene::Run& run) {
  const auto home = homes.find(piece.id);
  const Orientation own = home == homes.end() ? piece.orientation : home->second.orientation;
  std::optional<Found> best;
  for (const Orientation& orientation : matching::orientations_of(marker.shapes[piece.shape.value], own)) {
    auto found = found_in(marker, piece, orientation, homes, run);
    if (!found) continue;
    if (!best || std::pair{found->end, found->distance} < std::pair{best->end, best->distance}) best = std::move(found);
  }
  return best;
}

}  // namespace

std::size_t insert_unplaced(Marker& marker, const Homes& homes, const scene::Run& run) {
  std::vector<Piece> pieces = std::exchange(marker.unplaced, {});
  std::stable_sort(pieces.begin(), pieces.end(),
                   [&](const Piece& a, const Piece& b) { return area_of(marker, a) > area_of(marker, b); });
  std::size_t within = 0;
  for (const Piece& piece : pieces) {
    std::optional<Found> found;
    if (!run.stopped()) found = best_of(marker, piece, homes, run);
    if (!found) {
      marker.unplaced.push_back(piece);
      continue;
    }
    if (!marker.pieces.empty() && found->end <= length_of(marker)) ++within;
    found->piece.locked = piece.locked;
    marker.pieces.push_back(std::move(found->piece));
  }
  return within;
}

}  // namespace selvage::remake
