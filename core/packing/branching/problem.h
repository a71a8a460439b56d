// A packing as a search sees it: bodies that move without turning, each in one of several variants, and rings that keep
// the relative positions of two bodies apart.
//
// A body is a piece, or a rigid group of pieces; a variant is one of its allowed orientations.  A body's position is
// the low corner of its box, so that all its variants share one meaning of it.  The body `world()` is the plane that
// fixed pieces lie in.
// Units: lattice units, in doubles.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/packing/cells/free_cells.h"
#include "core/packing/cells/wedge_ring.h"
#include "core/packing/lines/chords.h"

namespace selvage::packing::branching {

using cells::WedgeRing;
using lines::Lines;

struct BodyVariant {
  RealBox range;            // allowed positions; where the length is minimised, the ceiling limits x further
  double width{};           // along x
  bool more_room_across{};  // to move along y than along x, relative to its size
};

struct Body {
  std::vector<BodyVariant> variants;  // at least one
  double area{};
  std::uint32_t kind{};  // bodies of one kind can change places without changing anything else
};

// A body in one of its variants.
struct Chosen {
  std::uint32_t body{}, variant{};
  friend auto operator<=>(const Chosen&, const Chosen&) = default;
};

struct Problem {
  std::vector<Body> bodies;
  std::vector<WedgeRing> rings;
  // The rings of two bodies in given variants, the first before the second; fixed pieces are `{world(), 0}`, which
  // comes last as a body but first in pairs.
  std::map<std::pair<Chosen, Chosen>, std::vector<std::uint32_t>> between;
  // By body and variant; nothing where no fixed piece is near.
  std::vector<std::vector<std::optional<cells::FreeCells>>> free_cells;
  std::array<Lines, 2> lines;  // those that cross x, and those that cross y; none where bodies may overlap
  bool minimises_length{};
  double least_length{};  // no layout is shorter
  // A body whose middle may be taken to lie in the left half of any length: of a layout and its mirror image, or its
  // half turn, one has it there (core/packing/bodies/mirror.h).  Only where the length is minimised.
  std::optional<std::uint32_t> left_half{};

  // Whether bodies of one kind in this variant are kept in order by y, and not by x.  Along the axis with more room for
  // their size they lie one behind another, so an order along it excludes most.  `left_half` relies on an order by x.
  [[nodiscard]] bool is_ordered_by_y(std::uint32_t body, std::uint32_t variant) const {
    return !minimises_length && bodies[body].variants[variant].more_room_across;
  }
  [[nodiscard]] std::uint32_t world() const { return static_cast<std::uint32_t>(bodies.size()); }
};

// The layouts that are like a given one: in the same variants, and no body is farther away along an axis.
struct Vicinity {
  std::vector<RealVec> positions;      // of the bodies
  std::vector<std::uint32_t> variant;  // of the bodies
  double reach{};
};

}  // namespace selvage::packing::branching
