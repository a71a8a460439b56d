// Converts a style to a marker: which pieces are cut, and where they lie initially.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "protocol/trade/options.h"
#include "protocol/trade/style.h"

namespace selvage::protocol::trade {

// One piece of the marker: a copy of the style's piece of this position, as drawn or mirrored.
struct PieceCopy {
  std::size_t pattern{};
  bool mirrored{};
  std::string id;                    // unique in the marker
  Json attributes = Json::object();  // such as its bundle
};

// The copies of each piece that one garment needs; at most one copy more than a marker may have.
[[nodiscard]] std::vector<PieceCopy> one_of_each(const Style& style);

// A marker on cloth of the width asked for, or of kUsualWidth.  A pattern file places nothing: the copies lie in
// columns from the left, each filled upwards, in the order given.  Notes and errors point to the file's lines. Errors:
// kOutOfRange (no piece is left), and those of on_lattice.
[[nodiscard]] Result<MarkerFile> marker_of(const Style& style, const std::vector<PieceCopy>& copies,
                                           const ReadingOptions& options);

}  // namespace selvage::protocol::trade
