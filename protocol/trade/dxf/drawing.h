// The blocks and entities of a DXF file, and the few header variables that matter to a pattern.
//
// Units: those of the file.  Entities refer to the tags that they were read from.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "protocol/json/fields.h"
#include "protocol/trade/dxf/tags.h"

namespace selvage::protocol::trade::dxf {

inline constexpr double kFarthestCoordinate = 1e8;  // of the file's unit, either way: no pattern reaches so far

struct DxfVertex {
  double x{}, y{};
  double bulge{};  // of the arc to the next vertex: the tangent of a quarter of its angle; 0: a straight edge
};

struct Entity {
  std::string_view type;   // "POLYLINE", "TEXT", ...
  std::string_view layer;  // "1"
  std::uint32_t line{};    // of the type
  std::span<const Tag> tags;
  std::vector<DxfVertex> vertices;  // of POLYLINE, LWPOLYLINE, LINE, POINT, TEXT and INSERT
  bool closed{};                    // by its flag; of POLYLINE and LWPOLYLINE

  // The first value of a group code.  A number beyond kFarthestCoordinate counts as none.
  [[nodiscard]] std::string_view text(int code) const;
  [[nodiscard]] std::optional<double> number(int code) const;
};

struct Block {
  std::string_view name;
  std::uint32_t line{};
  double base_x{}, base_y{};  // the point that an INSERT places
  std::vector<Entity> entities;
};

struct DxfDrawing {
  std::optional<int> insert_units;           // $INSUNITS
  std::string_view code_page;                // $DWGCODEPAGE
  std::string_view version;                  // $ACADVER
  std::set<std::string_view> hidden_layers;  // frozen or switched off
  std::vector<Block> blocks;
  std::vector<Entity> entities;  // of the section ENTITIES, without those in paper space
};

// REQUIRES: the tags outlive the drawing.
// Errors: kSyntax for a coordinate or scale that is no number, kOutOfRange for one beyond kFarthestCoordinate, with the
// line.
[[nodiscard]] Result<DxfDrawing> read_drawing(std::span<const Tag> tags);

}  // namespace selvage::protocol::trade::dxf
