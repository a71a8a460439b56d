// The pieces of a marker as a nesting search sees them: which are alike, in which orientations each may lie, and which
// stay where they are.
//
// Units: model units, a thousandth of the strip's width (core/model/model_unit.h), except where lattice units are
// named.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/real_plane.h"
#include "core/marker/marker.h"
#include "core/minkowski/cache.h"
#include "core/outline/outline.h"

namespace selvage::nesting::layout {

// An outline up to the eight exact symmetries, with the clearance around it and its overlap allowance.
struct BaseOutline {
  std::shared_ptr<const outline::Outline> outline;
  Coord buffer{}, overlap{};  // lattice units
  marker::Rules on_cloth{};  // of its rules: whether it is a zone, from which pieces keep no distance, its quality, and
                             // which part accepts less
  std::shared_ptr<const outline::Outline> part{};  // turned as the outline is; null: there is none
};

// A kind of piece in one of its allowed orientations.
struct Turned {
  Orientation orientation;
  std::uint32_t outline{};      // index of the base outline
  Symmetry symmetry;            // of the base outline
  RealBox box;                  // at position 0
  double match_x{}, match_y{};  // the match point at position 0; only of kinds that are matched to the cloth
  RealBox room;  // in which the box may lie by the rules of the piece; high_x is infinite where no band ends
};

// Pieces of one kind are interchangeable: they have the same rules, too.
struct Kind {
  ShapeId shape;
  Coord buffer{};                        // lattice units
  std::optional<std::uint32_t> shade{};  // index of the shade that its pieces belong to
  bool matched{};                        // to the cloth's pattern
  bool zone{};                 // not a piece but a part of the cloth that none may cover (core/marker/rules.h)
  std::vector<Turned> turned;  // at least one
  double area{}, hull_area{};  // of the outline and of its convex hull

  // Whether its pieces fit a strip that ends there, each alone, in some orientation.
  [[nodiscard]] bool fits_before(double end) const;
};

// Pieces that lie within a length of each other (core/marker/rules.h).
struct Shade {
  std::vector<std::uint32_t> pieces;
  double length{};
};

// The cloth's pattern (core/marker/rules.h).
struct Repeat {
  double along{}, across{};
  double phase_x{}, phase_y{};
};

struct PieceSet {
  std::vector<BaseOutline> outlines;
  std::vector<Kind> kinds;
  // One entry per piece: first the placed ones of the marker, then the unplaced ones.
  std::vector<std::uint32_t> kind_of;
  std::vector<bool> fixed;
  double lattice_units{};  // in a model unit
  double left{};           // pieces without rules lie at this x or beyond
  double low{}, high{};    // and between these across the strip
  Coord spacing{};         // lattice units
  double widest{};         // no two pieces keep a larger clearance
  double area{};           // of all pieces, zones aside
  std::vector<Shade> shades{};
  Repeat repeat{};

  [[nodiscard]] std::size_t size() const { return kind_of.size(); }
  [[nodiscard]] const Kind& kind(std::size_t piece) const { return kinds[kind_of[piece]]; }
  [[nodiscard]] bool is_zone(std::size_t piece) const { return kind(piece).zone; }
  // The width of the cloth that some piece may lie on: more than that of the strip's room when pieces have selvedges of
  // their own.
  [[nodiscard]] double across() const;
  // The least signed distance between two pieces with these base outlines: negative when they may overlap, as
  // marker::PlacedPieces::spacing has it, 0 from a zone, and far below 0 when they may share their cloth.
  [[nodiscard]] double clearance(std::uint32_t first, std::uint32_t second) const;
  // The base outline as another one meets it: a zone that is too bad only for a part meets that part.
  [[nodiscard]] const outline::Outline& facing(std::uint32_t outline, std::uint32_t other) const;
};

// What a search may move.
enum class PlacedPiecesMay { kMove, kNotMove };

// The rotations that are tried for a shape that may turn freely.
inline constexpr int kFreeRotations = 16;

// Placed pieces that are locked on an axis or belong to a group stay where they are.
// Errors: kPieceTooWide for a piece that fits the strip, and the room that its rules leave, neither in an allowed
// orientation nor, if it is placed, in its own.
[[nodiscard]] Result<PieceSet> piece_set_of(const Marker& marker, PlacedPiecesMay placed, SumCache& sums);

}  // namespace selvage::nesting::layout
