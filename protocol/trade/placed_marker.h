// Converts pieces that are known by their placed outlines, as in a cut file or a drawing, to shapes and placements.
// Units: millimetres.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "protocol/trade/options.h"
#include "protocol/trade/style.h"

namespace selvage::protocol::trade {

struct PlacedPattern {
  std::string name, size;  // empty: the file does not say
  std::vector<Spot> outline;
  document::Annotations annotations;  // where they lie
  Json attributes = Json::object();   // of the piece
  std::string field;                  // of the file, for notes and errors
};

struct PlacedMarker {
  std::string name;
  std::vector<PlacedPattern> pieces;
  std::vector<Note> notes;
};

// Pieces of the same outline and annotations share a shape.  The cloth has the requested width; otherwise it is as wide
// as the pieces need, rounded up to a millimetre, which is noted.  If pieces extend below 0, all pieces are moved up or
// to the right.  Errors: kEmptyMarker, and those of on_lattice.
[[nodiscard]] Result<MarkerFile> file_of(PlacedMarker marker, const ReadingOptions& options);

}  // namespace selvage::protocol::trade
