// The layout of a marker: every piece's polygon in its orientation, its position, and the room in which it may lie.
// Units: lattice units.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/geometry/overlap.h"
#include "core/marker/marker.h"
#include "core/marker/rules.h"

namespace selvage::marker {

// A polygon that several pieces may share, with its bounding box.
struct SharedPolygon {
  Polygon vertices;
  Box box;
  Polygon part{};  // the part that accepts less of the cloth's quality (rules.h); empty: there is none
};

// Two pieces, first < second.
using PiecePair = std::pair<std::uint32_t, std::uint32_t>;

class PlacedPieces {
 public:
  explicit PlacedPieces(const Marker& marker);

  [[nodiscard]] std::size_t size() const { return at_.size(); }
  [[nodiscard]] geometry::PlacedPolygon operator[](std::size_t piece) const {
    const SharedPolygon& polygon = *polygons_[piece];
    return {polygon.vertices, polygon.box, at_[piece]};
  }
  // What the other one must not overlap: the piece or, where the other one is a zone that is too bad only for the
  // piece's part, that part.  The box is that of the whole piece.
  [[nodiscard]] geometry::PlacedPolygon facing(std::size_t piece, std::size_t other) const {
    if (!shows_part(piece, other)) return (*this)[piece];
    const SharedPolygon& polygon = *polygons_[piece];
    return {polygon.part, polygon.box, at_[piece]};
  }
  // True when the other one must not overlap the piece's part, but may overlap the rest of it.
  [[nodiscard]] bool shows_part(std::size_t piece, std::size_t other) const {
    return rooms_ && only_part_meets(rooms_->rules[piece], rooms_->rules[other]);
  }
  // The part of the piece as it is turned, relative to its position; empty: it has none.
  [[nodiscard]] std::span<const Vec> part(std::size_t piece) const { return polygons_[piece]->part; }
  [[nodiscard]] Box box(std::size_t piece) const { return polygons_[piece]->box.moved(at_[piece]); }
  [[nodiscard]] Vec at(std::size_t piece) const { return at_[piece]; }
  [[nodiscard]] const std::vector<Vec>& positions() const { return at_; }
  void place(std::vector<Vec> positions) { at_ = std::move(positions); }
  // Moves every piece, each by a vector of its own.
  void move_by(std::span<const Vec> by);
  // Replaces the polygon and position of one piece, for instance after a tilt.  `match` and `part`: its match point and
  // its part as it is turned now, if it has them.
  void replace(std::size_t piece, Polygon polygon, Vec at, Vec match, Polygon part = {});
  // The least signed distance that the two pieces must keep: the marker's spacing or the sum of their buffers,
  // whichever is larger; when both are 0, the smaller of their overlap allowances, negated.  From a zone it is 0.
  [[nodiscard]] Coord spacing(PiecePair pair) const {
    const auto [p, q] = pair;
    if (is_zone(p) || is_zone(q)) return 0;
    const Coord apart = std::max(spacing_, buffers_[p] + buffers_[q]);
    return apart > 0 ? apart : -std::min(overlaps_[p], overlaps_[q]);
  }
  // The largest spacing of any pair; at least 0.
  [[nodiscard]] Coord widest_spacing() const { return widest_spacing_; }
  // True for a part of the cloth that no piece may cover, or only some (rules.h).
  [[nodiscard]] bool is_zone(std::size_t piece) const { return rooms_ && rooms_->rules[piece].zone; }
  // True for a zone whose cloth has a quality, which some pieces may accept.
  [[nodiscard]] bool is_usable_zone(std::size_t piece) const { return is_zone(piece) && rooms_->rules[piece].quality; }
  // True for a pair that may lie over each other: a zone, and another zone or a piece that accepts its cloth.  Searches
  // for the neighbours of a piece leave these out.
  [[nodiscard]] bool may_share_cloth(std::size_t p, std::size_t q) const {
    return rooms_ && marker::may_share_cloth(rooms_->rules[p], rooms_->rules[q]);
  }
  // The x up to which a piece makes the marker extend: its right end.  A zone does not lengthen the marker.
  [[nodiscard]] Coord end_of(std::size_t piece) const { return is_zone(piece) ? 0 : box(piece).high.x; }
  // The x coordinate at which the rightmost piece ends.
  [[nodiscard]] Coord length() const;
  // The box in which the piece's box may lie when the strip ends at x = `end`; of a piece that is matched to the cloth,
  // without changing to another repeat.
  [[nodiscard]] Box room(std::size_t piece, const Strip& strip, Coord end) const {
    return rooms_ ? room_by_rules(piece, strip, end) : strip.room(end);
  }
  // The repeat of the pattern that the piece has to match; 0 on an axis on which it need not match.
  [[nodiscard]] Vec repeat_of(std::size_t piece, const Strip& strip) const {
    const bool matched = rooms_ && (rooms_->rules[piece].matched_to_cloth() || match_set_of(piece) != nullptr);
    return matched ? Vec{strip.repeat.along, strip.repeat.across} : Vec{};
  }
  // The room, limited to positions near enough to the other pieces of its shade and in phase with those of its match
  // set, where these lie now; pieces that move with it do not count.  Empty (high < low) if there is no such position.
  [[nodiscard]] Box room_among(std::size_t piece, const std::vector<bool>& moving, const Strip& strip, Coord end) const;
  // The pieces of each shade.
  [[nodiscard]] std::span<const Shade> shades() const {
    return rooms_ ? std::span<const Shade>{rooms_->shades} : std::span<const Shade>{};
  }
  // The match sets of at least two placed pieces.
  [[nodiscard]] std::span<const MatchSet> match_sets() const {
    return rooms_ ? std::span<const MatchSet>{rooms_->match_sets} : std::span<const MatchSet>{};
  }
  // The set of this piece, if it has one; null when it is alone in it.
  [[nodiscard]] const MatchSet* match_set_of(std::size_t piece) const;
  // Where the match point of a piece lies.  REQUIRES: it belongs to a match set.
  [[nodiscard]] Vec match_at(std::size_t piece) const { return at_[piece] + matches_[piece]; }
  // By how much a piece is off the phase of another one of its match set.
  [[nodiscard]] Vec off_phase(std::size_t piece, std::size_t other) const {
    return off_repeat(match_at(piece) - match_at(other), rooms_->repeat);
  }
  // The most by which a piece of a match set is off the phase of its first piece, on any axis.
  [[nodiscard]] Coord off_phase(const MatchSet& set) const;
  // By how much the pieces of a shade are farther from each other than they may be; 0 or less when they are not.
  [[nodiscard]] Coord excess_of(const Shade& shade) const;

 private:
  [[nodiscard]] Box room_by_rules(std::size_t piece, const Strip& strip, Coord end) const;

  std::vector<std::shared_ptr<const SharedPolygon>> polygons_;
  std::vector<Vec> at_;
  std::vector<Coord> buffers_;
  std::vector<Coord> overlaps_;  // the overlap allowance of each piece
  std::vector<Vec> matches_;     // the match point of each piece as it is turned; empty when no piece has rules
  Coord spacing_, widest_spacing_;
  std::shared_ptr<const Rooms> rooms_;  // null: no piece has rules
};

// All pairs whose boxes are closer than `distance` on both axes (0: whose boxes overlap), sorted; those that may share
// their cloth are left out.
[[nodiscard]] std::vector<PiecePair> pairs_within(const PlacedPieces& pieces, Coord distance);
// Whether one of these pairs passes the test.
[[nodiscard]] bool any_pair_within(const PlacedPieces& pieces, Coord distance,
                                   const std::function<bool(PiecePair)>& test);

}  // namespace selvage::marker
