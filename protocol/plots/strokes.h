// A sheet as strokes and labels, which plots draw in any language.  Units:
// millimetres.
#pragma once

#include <vector>

#include "protocol/plots/sheet.h"

namespace selvage::protocol::plots {

enum class StrokeStyle { kFrame, kOutline, kInner, kDashed };

struct Stroke {
  StrokeStyle style{};
  bool closed{};
  std::vector<Spot> points;
};

struct PlotLabel {
  std::string text;
  Spot at;          // the left end of its base line
  double height{};  // of the letters
  double angle{};   // degrees
};

struct Plot {
  double width{}, length{};  // of the marker
  std::vector<Stroke> strokes;
  std::vector<PlotLabel> labels;
};

// Labels of pieces are placed inside their outlines, as large as possible up to 10 mm, and left out below 2 mm.
[[nodiscard]] Plot plot_of(const Sheet& sheet);
// "length 6,491.6 mm, width 1,638.3 mm, utilisation 87.20 %".
[[nodiscard]] std::string figures_of(const Sheet& sheet);
// Its name; "Marker" when it has none.
[[nodiscard]] std::string title_of(const Sheet& sheet);

}  // namespace selvage::protocol::plots
