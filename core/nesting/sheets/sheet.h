// A sheet that pieces are nested on: a rectangle of cloth, a remnant, or a hide with an outline of its own.  Parts of
// it, such as holes and flaws, may be closed to all pieces or, with a quality, to some (core/marker/rules.h).
//
// What pieces must not cover are zones of the sheet's marker: the walls between an outline and its bounding box
// (core/outline/enclosed/container.h), holes, and parts of a quality.  So one proof decides whether a position is
// allowed, as everywhere, and a motion that is run on the marker later knows the sheet.  As with all zones, pieces may
// touch them, and they may lie over each other and beyond the sheet.
// Units: lattice units; the origin is the low corner of the sheet's bounding box.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/marker/marker.h"

namespace selvage::nesting::sheets {

struct SheetZone {
  Polygon outline;
  std::optional<marker::Quality> quality{};  // the class of its cloth; none: a hole, which no piece may cover
};

struct Sheet {
  Coord width{}, length{};  // across and along; of an outline: those of its bounding box
  std::optional<Polygon> outline{};
  std::vector<SheetZone> zones{};
  std::size_t count{1};  // how many of them there are
  double cost{1};        // of one of them, in any unit; at least 0, such as for a remnant
};

// The sheet within an outline, all moved so that the outline's bounding box begins at the origin.
[[nodiscard]] Sheet sheet_within(const Polygon& outline, std::vector<SheetZone> zones);

// What some pieces can cover: all but the holes; square lattice units.
[[nodiscard]] double area_of(const Sheet& sheet);

// The marker without its pieces, on the sheet: its only pieces are the zones.
// Errors: kOutOfRange for a sheet without an area, and for one with an outline where the marker has a margin or
// selvedges; kTooManyVertices for an outline.  `field` is a JSON pointer into the sheet.
[[nodiscard]] Result<Marker> bare(const Marker& marker, const Sheet& sheet);

}  // namespace selvage::nesting::sheets
