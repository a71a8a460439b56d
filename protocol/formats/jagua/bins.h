// The bins of a jagua-rs instance of bin packing (ExtBPInstance; github.com/JeroenGar/jagua-rs): rectangles, remnants
// or hides, with holes and zones of lower quality.
//
// Its qualities run from 0, that of a hole, to 10, that of all other cloth, and an item states the least one that it
// needs; ours are classes, of which 0 is the best (core/marker/rules.h).
// Units: the instance's own; x runs along the strip.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/marker/rules.h"
#include "protocol/document/annotations.h"
#include "protocol/json/fields.h"

namespace selvage::protocol::formats::jagua {

inline constexpr std::int64_t kBestQuality = 10;

// The class of cloth of a quality from 1 to 10, and the worst class that an item accepts which needs that quality.
[[nodiscard]] marker::Quality class_of(std::int64_t quality);

struct BinPolygon {
  std::vector<document::Spot> corners;
  std::string field;  // a JSON pointer to them in the instance
};
struct BinZone {
  BinPolygon outline;
  std::optional<marker::Quality> quality{};  // its class; none: a hole
};
struct Bin {
  std::string field;  // a JSON pointer to it in the instance
  BinPolygon outline;
  std::optional<document::Spot> rectangle{};  // its size, if it is one
  std::vector<BinZone> zones;                 // those of the best quality are left out
  std::size_t count{};                        // of its stock
  double cost{};                              // of one of them
};

// The bins of the field "bins".  Bins of which none is in stock are left out.
// Errors: kMissingField, kWrongType, kOutOfRange for what is no list of bins, and for more than 1,000 holes and zones
// of one bin.  Without a cost, a bin costs 1.
[[nodiscard]] Result<std::vector<Bin>> read_bins(const Json& bins);

// The size across of the widest one; 0 when there is none.
[[nodiscard]] double widest(const std::vector<Bin>& bins);

}  // namespace selvage::protocol::formats::jagua
