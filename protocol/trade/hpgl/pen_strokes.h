// The strokes and labels of HP-GL and HP-GL/2 files, as far as pattern rooms use them.
//
// The reader supports PU, PD, PA and PR (the pen), PE (encoded polylines), AA, AR and CI (arcs and circles), EA, ER, RA
// and RR (rectangles), LB with DT (labels), LT (a stroke is dashed), IP and SC (user units); it ignores other
// instructions.  Units: plotter units, 0.025 mm.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "protocol/trade/flattening.h"
#include "protocol/trade/loops.h"
#include "protocol/trade/style.h"

namespace selvage::protocol::trade::hpgl {

struct PenLabel {
  std::string text;
  Spot at;  // where the first letter begins
};

struct PenStrokes {
  std::vector<Run> runs;    // solid
  std::vector<Run> dashed;  // of another line type
  std::vector<PenLabel> labels;
  std::vector<Note> notes;
};

// Arcs are flattened in plotter units.
[[nodiscard]] PenStrokes read_strokes(std::string_view text, Flattening& flattening);

}  // namespace selvage::protocol::trade::hpgl
