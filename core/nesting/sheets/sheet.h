// A sheet that pieces are nested on: a rectangle of cloth, a remnant, or a hide with an outline of its own; it may have
// holes and faults that no piece may cover.
//
// What pieces must not cover is made of locked pieces: the walls between an outline and its bounding box
// (core/outline/enclosed/container.h), and the holes.  So one proof decides whether a position is allowed, as
// everywhere.  Walls touch each other, hence they must keep no spacing: on a sheet with walls or holes, the marker's
// spacing is divided into the pieces' buffers.  Pieces then keep their buffers, or half of the spacing, from walls and
// holes. Units: lattice units; the origin is the low corner of the sheet's bounding box.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/marker/marker.h"

namespace selvage::nesting::sheets {

struct Sheet {
  Coord width{}, length{};  // across and along; of an outline: those of its bounding box
  std::optional<Polygon> outline{};
  std::vector<Polygon> holes{};
  std::size_t count{1};  // how many of them there are

  [[nodiscard]] bool plain() const { return !outline && holes.empty(); }
};

// The sheet within an outline, all moved so that the outline's bounding box begins at the origin.
[[nodiscard]] Sheet sheet_within(const Polygon& outline, std::vector<Polygon> holes);

// What pieces can cover; square lattice units.
[[nodiscard]] double area_of(const Sheet& sheet);

// The marker without its pieces, on the sheet: its only pieces are the walls and the holes.
// Errors: kOutOfRange for a sheet without an area, holes that overlap or lie beyond the outline, and a margin where
// there are walls or holes; `field` is a JSON pointer into the sheet.
[[nodiscard]] Result<Marker> bare(const Marker& marker, const Sheet& sheet);
// The piece as it is nested on the sheet.
[[nodiscard]] Piece on_sheet(Piece piece, const Marker& marker, const Sheet& sheet);

}  // namespace selvage::nesting::sheets
