// A marker whose pieces are known by where they lie, such as a cut file or a drawing: to shapes and placements.
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

// Pieces of the same outline and annotations share a shape.  The cloth is as wide as asked for, else as the pieces
// reach, rounded up to a millimetre, which is noted; pieces that reach below 0 move all pieces up or to the right.
// Errors: kEmptyMarker, and those of on_lattice.
[[nodiscard]] Result<MarkerFile> file_of(PlacedMarker marker, const ReadingOptions& options);

}  // namespace selvage::protocol::trade
