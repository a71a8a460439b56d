// The sheets of marker.nestSheets: as its parameters describe them, or the bins of the opened file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/nesting/sheets/sheet.h"
#include "protocol/calls/values.h"
#include "protocol/document/marker_file.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/schema/visitors.h"

namespace selvage::protocol::methods::nesting {

inline constexpr std::size_t kMostSheets = 100;

// The corners of a polygon in parameters.
struct SheetOutline {
  std::vector<calls::Point> corners;
};

}  // namespace selvage::protocol::methods::nesting

namespace selvage::protocol::schema {

template <>
struct Wire<methods::nesting::SheetOutline> {
  static Type type() { return list_of(Wire<calls::Point>::type()); }
  static Json write(const methods::nesting::SheetOutline& value);
  static void read(const FieldAt& at, methods::nesting::SheetOutline& value);
  static methods::nesting::SheetOutline read_entry(const Json& value, const std::string& at, json::Mistake& mistake);
};

}  // namespace selvage::protocol::schema

namespace selvage::protocol::methods::nesting {

struct SheetZoneParams {
  static constexpr std::string_view kName = "SheetZone";
  static constexpr std::string_view kMeaning = "A part of a sheet that only pieces which accept its quality may cover.";
  SheetOutline outline;
  std::optional<marker::Quality> quality;

  static void describe(auto& v, auto& self) {
    v.required("outline", self.outline, "Its corners [x, y].");
    v.optional("quality", self.quality, "The quality class of its cloth; absent: one that no piece accepts.",
               {.range = {{1, marker::kWorstQuality}}});
  }
};

struct SheetParams {
  static constexpr std::size_t kMostZones = 200;
  static constexpr double kMostOfOneKind = 1'000;
  static constexpr double kMostCost = 1e12;
  static constexpr std::string_view kName = "Sheet";
  static constexpr std::string_view kMeaning = "Sheets of one size and form: a rectangle, or the inside of an outline.";
  std::optional<double> width, length;
  std::optional<SheetOutline> outline;
  std::optional<std::vector<SheetOutline>> holes;
  std::optional<std::vector<SheetZoneParams>> zones;
  std::uint64_t count{1};
  double cost{1};

  static void describe(auto& v, auto& self) {
    v.optional("width", self.width, "The width of a rectangle, across the grain, in the marker's unit.",
               {.range = formats::kStripWidths});
    v.optional("length", self.length, "The length of a rectangle, along the grain.", {.range = formats::kStripWidths});
    v.optional("outline", self.outline, "The corners [x, y] of the sheet, instead of a width and a length.");
    v.optional("holes", self.holes, "Outlines of holes and faults that no piece may cover.",
               {.entries = {{0, kMostZones}}, .entries_are = "holes"});
    v.optional("zones", self.zones, "Parts of another quality, as the zones of a marker.",
               {.entries = {{0, kMostZones}}, .entries_are = "zones"});
    v.optional("count", self.count, "How many of these sheets there are, 1 to 1,000.",
               {.range = {{1, kMostOfOneKind}}});
    v.optional("cost", self.cost,
               "What one of these sheets costs, in any unit; sheets whose total cost is least are used.",
               {.range = {{0, kMostCost}}});
  }
};

// A sheet, and JSON pointers to it and to its outline: into the parameters, or into the file with its bins.
struct GivenSheet {
  selvage::nesting::sheets::Sheet sheet;
  std::string field, outline_field;
};

// The sheets of the parameter or, without it, the bins of the file's instance (protocol/formats/jagua/bins.h).
// Errors: kMissingField when there are neither, and for half of a rectangle; kTooManyVertices; kOutOfRange for what is
// no sheet, and for too many bins; those of read_bins.
[[nodiscard]] Result<std::vector<GivenSheet>> sheets_of(const std::optional<std::vector<SheetParams>>& params,
                                                        const MarkerFile& file);

// The error of nesting on these sheets, whose field begins with "/sheets/K", with the pointers of sheet K.
[[nodiscard]] Error with_field_of(Error error, const std::vector<GivenSheet>& sheets);

}  // namespace selvage::protocol::methods::nesting
