// Cut files: ASTM D6672 (a subset of EIA-274-D) with Gerber's codes.
//
// Blocks end with *; G71: a tenth of a millimetre; M14 and M15 lower and raise the knife; M31 is a label, M43 a drill
// hole; N begins a piece, M0 ends the file.  For each piece, the label comes first, then drill holes, notches and inner
// cuts, and last the outline, counter-clockwise, so that the cloth holds the piece until then.  Notches that have no
// depth are not cut.  What lies in a hole of a piece is cut before that piece.
#pragma once

#include <string>

#include "protocol/plots/sheet.h"

namespace selvage::protocol::plots {

struct CutFile {
  std::string text;
  double travel{};           // travel of the raised knife between pieces, millimetres
  double travel_in_order{};  // the travel in the marker's own order
};
[[nodiscard]] CutFile cut_file(const Sheet& sheet);

// The text as a label: in ASCII, and without characters that end a block.
[[nodiscard]] std::string cut_label(const std::string& text);

}  // namespace selvage::protocol::plots
