// The polylines that PE encodes in printable characters.
// Source: Hewlett-Packard, PCL 5 Printer Language Technical Reference Manual, chapter 20, "PE (Polyline Encoded)".
#pragma once

#include <string_view>
#include <vector>

#include "protocol/document/annotations.h"

namespace selvage::protocol::trade::hpgl {

struct EncodedMove {
  document::Spot by;  // the step, or the place if it is absolute; in current units
  bool up{};          // the pen is raised for it
  bool absolute{};
};

struct EncodedPolyline {
  std::vector<EncodedMove> moves;
  bool damaged{};  // some characters have no meaning there, and were skipped
};

// `text`: what stands between PE and its semicolon.
[[nodiscard]] EncodedPolyline decode_polyline(std::string_view text);

}  // namespace selvage::protocol::trade::hpgl
