// A marker as an AAMA/ASTM D6673 DXF nest: a block for each shape, and an insert for each piece.
//
// R12 with an empty HEADER and no TABLES, in ASCII; the layers are those of D6673.  A flipped piece has a separate,
// mirrored block, because readers disagree on negative scales.  Coordinates are the exact decimals of the lattice, in
// millimetres, or in inches for a marker in inches.  What a nest cannot express (the width of the cloth, the ids of
// pieces, allowed rotations) is written as texts "Marker ...:" and as attributes of the inserts, from which
// protocol/trade/aama/nest.h reads the same marker back.  Names that DXF does not keep as they are stand in quotes.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "protocol/document/marker_file.h"

namespace selvage::protocol::plots {

// Errors: kOutOfRange for a marker in a unit other than mm, cm, m, in.
[[nodiscard]] Result<std::string> dxf_file(const MarkerFile& file);

// What the file does not contain, or contains in quotes.
[[nodiscard]] std::vector<Note> dxf_losses(const MarkerFile& file);

}  // namespace selvage::protocol::plots
