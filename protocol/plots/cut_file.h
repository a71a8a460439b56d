// Cut files: ASTM D6672 (a subset of EIA-274-D) with Gerber's codes.
//
// Blocks end with *; G71: a tenth of a millimetre; M14 and M15 lower and raise the knife; M31 is a label, M43 a drill
// hole; N begins a piece, M0 ends the file.  Of a piece come first its label, then its drill holes, notches and inner
// cuts, and its outline last, counter-clockwise, while the cloth still holds it.  Notches that have no depth are not
// cut.
#pragma once

#include <string>

#include "protocol/plots/sheet.h"

namespace selvage::protocol::plots {

struct CutFile {
  std::string text;
  double travel{};           // of the raised knife from piece to piece, millimetres
  double travel_in_order{};  // what it would be in the marker's own order
};
[[nodiscard]] CutFile cut_file(const Sheet& sheet);

}  // namespace selvage::protocol::plots
