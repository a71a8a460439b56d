// The input of cutters and plotters: every placed piece, with everything that is drawn on it.
//
// Units: millimetres; the strip spans 0 to `width` along y and begins at x = 0.  Floating point: the exact outlines are
// those of the marker.
#pragma once

#include <string>
#include <vector>

#include "protocol/document/annotations.h"
#include "protocol/document/marker_file.h"

namespace selvage::protocol::plots {

using document::Spot;

struct SheetPiece {
  std::string id;
  std::string label;                  // for people: id, size and bundle
  std::vector<Spot> outline;          // counter-clockwise, without the slits of open holes
  document::Annotations annotations;  // among them the open holes, as cut-outs
};

struct Sheet {
  std::string name;
  double width{}, length{};
  double utilisation{};  // 0..1
  std::vector<SheetPiece> pieces;
};

// A marker in an unknown unit is treated as one in millimetres.
[[nodiscard]] Sheet sheet_of(const MarkerFile& file);
// The length of the marker's unit in millimetres; 1 when it is not known.
[[nodiscard]] double millimetres_in(const std::string& unit);

// Text for ASCII files: every other character is replaced by `otherwise`.
[[nodiscard]] std::string in_ascii(std::string_view text, char otherwise = '?');
// The shortest decimal of a value rounded to a thousandth.
[[nodiscard]] std::string thousandths(double value);

}  // namespace selvage::protocol::plots
