#include "core/marker/validity.h"

#include <algorithm>
#include <string>

#include "core/marker/clearance.h"
#include "core/minkowski/cache.h"
#include "core/minkowski/nearest_edges.h"
#include "core/outline/outline.h"

namespace selvage::marker {
namespace {

constexpr std::size_t kMostMeasured = 500'000;  // overlaps; a heap of pieces has millions

Overlap measured(PiecePair pair, const PlacedPieces& pieces, const Marker& marker, SumCache& sums) {
  const auto [first, second] = pair;
  const geometry::PlacedPolygon p = pieces.facing(first, second);
  const geometry::PlacedPolygon q = pieces.facing(second, first);
  const auto inside_both = common_point(p, q);
  const RealVec witness = inside_both ? *inside_both : nearest_point(p, q);
  const auto facing = [&](std::uint32_t piece, std::uint32_t other) {
    return pieces.shows_part(piece, other) ? oriented_part(marker.pieces[piece], sums)
                                           : oriented_outline(marker, PieceId{piece}, sums);
  };
  const minkowski::Obstacle obstacle = sums.obstacle(facing(first, second), facing(second, first));
  const double distance = nearest_boundary_point(obstacle.sum(), obstacle.to_frame(q.at - p.at)).distance;
  const double depth = static_cast<double>(pieces.spacing(pair)) + (inside_both ? distance : -distance);
  return {PieceId{first}, PieceId{second}, witness.x, witness.y, std::max(0.0, depth)};
}

// The fault of a shade whose pieces are too far from each other.
ShadeFault fault_of(const Shade& shade, const PlacedPieces& pieces) {
  const auto leftmost =
      std::min_element(shade.pieces.begin(), shade.pieces.end(),
                       [&](std::uint32_t p, std::uint32_t q) { return pieces.box(p).low.x < pieces.box(q).low.x; });
  const auto rightmost =
      std::max_element(shade.pieces.begin(), shade.pieces.end(),
                       [&](std::uint32_t p, std::uint32_t q) { return pieces.box(p).high.x < pieces.box(q).high.x; });
  return {PieceId{*leftmost}, PieceId{*rightmost}, pieces.excess_of(shade)};
}

Overlap unmeasured(PiecePair pair, const PlacedPieces& pieces) {
  const Box p = pieces.box(pair.first);
  const Box q = pieces.box(pair.second);
  const auto middle = [](Coord low, Coord high) { return static_cast<double>(low + high) / 2; };
  return {PieceId{pair.first}, PieceId{pair.second}, middle(std::max(p.low.x, q.low.x), std::min(p.high.x, q.high.x)),
          middle(std::max(p.low.y, q.low.y), std::min(p.high.y, q.high.y))};
}

// Whether the piece lies with its nap, and has a side for the fold where it has to.
bool keeps_turn_rules(const Marker& marker, const Piece& piece) {
  if (!piece.rules.nap && !piece.rules.on_fold) return true;
  const Polygon outline = oriented(marker.shapes[piece.shape.value].outline, piece.orientation);
  return keeps_nap(piece.rules, piece.orientation) && has_side_for_fold(piece.rules, outline, marker.strip);
}

}  // namespace

outline::OrientedOutline oriented_outline(const Marker& marker, PieceId id, SumCache& sums) {
  const Piece& piece = marker.pieces[id.value];
  const geometry::SplitOrientation parts = split(piece.orientation);
  return {sums.outline(turned(marker.shapes[piece.shape.value].outline, parts.turn)), parts.symmetry};
}

outline::OrientedOutline oriented_part(const Piece& piece, SumCache& sums) {
  const geometry::SplitOrientation parts = split(piece.orientation);
  return {sums.outline(turned(piece.rules.part->outline, parts.turn)), parts.symmetry};
}

Validity check(const Marker& marker, SumCache& sums) {
  return *check(marker, sums, std::stop_token{});
}

Result<Validity> check(const Marker& marker, SumCache& sums, const std::stop_token& stop) {
  Validity validity;
  const PlacedPieces pieces{marker};
  for (const PiecePair& pair : conflicts(pieces, serial(), stop)) {
    if (stop.stop_requested() || validity.overlaps.size() == kMostMeasured) break;
    validity.overlaps.push_back(measured(pair, pieces, marker, sums));
  }
  if (stop.stop_requested()) {
    return Error{ErrorCode::kStoppedEarly, "stopped before all overlaps were measured", ""};
  }
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    if (const Coord by = protrusion_of(pieces, i, marker.strip); by > 0) {
      validity.protrusions.push_back({PieceId{i}, by});
    }
  }
  for (const Shade& shade : pieces.shades()) {
    if (pieces.excess_of(shade) > 0) validity.shades.push_back(fault_of(shade, pieces));
  }
  for (const MatchSet& set : pieces.match_sets()) {
    for (const std::uint32_t piece : set) {
      if (const Vec by = pieces.off_phase(piece, set.front()); by != Vec{})
        validity.matches.push_back({PieceId{piece}, PieceId{set.front()}, by});
    }
  }
  return validity;
}

std::vector<Overlap> overlaps_unmeasured(const Marker& marker) {
  const PlacedPieces pieces{marker};
  std::vector<Overlap> overlaps;
  for (const PiecePair& pair : conflicts(pieces)) overlaps.push_back(unmeasured(pair, pieces));
  return overlaps;
}

std::optional<Error> defect_of_fixed(const Marker& marker, const std::vector<bool>& fixed) {
  const PlacedPieces pieces{marker};
  for (std::uint32_t i = 0; i < marker.pieces.size(); ++i) {
    if (!fixed[i]) continue;
    if (protrusion_of(pieces, i, marker.strip) > 0) {
      return Error{ErrorCode::kOutsideStrip,
                   "piece \"" + marker.pieces[i].id +
                       "\" must stay where it is, but lies outside the strip or the room that its rules leave",
                   "/pieces/" + std::to_string(i)};
    }
  }
  for (const Shade& shade : pieces.shades()) {
    std::optional<Box> box;
    for (const std::uint32_t i : shade.pieces) {
      if (fixed[i]) box = box ? united(*box, pieces.box(i)) : pieces.box(i);
    }
    if (!box || box->width() <= shade.length) continue;
    return Error{ErrorCode::kOutsideStrip,
                 "pieces of shade \"" + marker.pieces[shade.pieces.front()].rules.shade +
                     "\" must stay where they are, but lie too far from each other",
                 "/shade"};
  }
  for (const MatchSet& set : pieces.match_sets()) {
    const auto first = std::ranges::find_if(set, [&](const std::uint32_t i) { return fixed[i]; });
    for (auto other = first; other != set.end(); ++other) {
      if (!fixed[*other] || pieces.off_phase(*other, *first) == Vec{}) continue;
      return Error{ErrorCode::kOutsideStrip,
                   "pieces \"" + marker.pieces[*first].id + "\" and \"" + marker.pieces[*other].id +
                       "\" of one match set must stay where they are, but are off each other's repeats",
                   "/pieces/" + std::to_string(*other)};
    }
  }
  std::optional<PiecePair> least;
  (void)any_pair_within(pieces, pieces.widest_spacing(), [&](PiecePair pair) {
    if (fixed[pair.first] && fixed[pair.second] && (!least || pair < *least) && conflict(pieces, pair)) least = pair;
    return false;
  });
  if (least) {
    const auto [first, second] = *least;
    return Error{ErrorCode::kMarkerOverlaps,
                 "pieces \"" + marker.pieces[first].id + "\" and \"" + marker.pieces[second].id +
                     "\" must stay where they are, but overlap or are too close",
                 "/pieces/" + std::to_string(second)};
  }
  return std::nullopt;
}

bool is_valid(const Marker& marker) {
  const auto keeps = [&](const Piece& piece) { return keeps_turn_rules(marker, piece); };
  return std::all_of(marker.pieces.begin(), marker.pieces.end(), keeps) &&
         all_clear(PlacedPieces{marker}, marker.strip);
}

}  // namespace selvage::marker
