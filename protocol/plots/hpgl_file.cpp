#include "protocol/plots/hpgl_file.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "protocol/plots/strokes.h"

namespace selvage::protocol::plots {
namespace {

constexpr double kPlotterUnits = 40;
constexpr double kHeading = 12;      // millimetres above the frame
constexpr char kEndOfText = '\x03';  // ETX

std::string coordinates(Spot spot) {
  const auto coordinate = [](double value) {
    return std::to_string(std::max(0LL, std::llround(value * kPlotterUnits)));
  };
  return coordinate(spot.x) + "," + coordinate(spot.y);
}

std::string stroke(const Stroke& drawn) {
  std::string out = "PU" + coordinates(drawn.points.front()) + ";PD";
  for (std::size_t k = 1; k < drawn.points.size(); ++k) out += (k > 1 ? "," : "") + coordinates(drawn.points[k]);
  if (drawn.closed) out += "," + coordinates(drawn.points.front());
  return out + ";\n";
}

// Width and height of letters are in centimetres; their direction is given by its cosine and sine.
std::string label(const PlotLabel& drawn) {
  const double angle = drawn.angle * std::numbers::pi / 180;
  std::string out = "PU" + coordinates(drawn.at) + ";SI" + thousandths(drawn.height * 0.65 / 10) + "," +
                    thousandths(drawn.height / 10) + ";DI" + thousandths(std::cos(angle)) + "," +
                    thousandths(std::sin(angle)) + ";LB";
  return out + in_ascii(drawn.text) + kEndOfText + ";\n";
}

}  // namespace

std::string hpgl_file(const Sheet& sheet) {
  const Plot plot = plot_of(sheet);
  std::string out = "IN;CO\"ASTMD6959-03\";SP1;\n";
  StrokeStyle style = StrokeStyle::kOutline;
  for (const Stroke& drawn : plot.strokes) {
    const bool dashed = drawn.style == StrokeStyle::kDashed;
    if (dashed != (style == StrokeStyle::kDashed)) out += dashed ? "LT2,0.4;\n" : "LT;\n";
    style = drawn.style;
    out += stroke(drawn);
  }
  if (style == StrokeStyle::kDashed) out += "LT;\n";
  for (const PlotLabel& drawn : plot.labels) out += label(drawn);
  out +=
      label({sheet.name + (sheet.name.empty() ? "" : ": ") + figures_of(sheet), {0, sheet.width + kHeading / 2}, 8, 0});
  return out + "PU" + coordinates({sheet.length, 0}) + ";SP0;\n";
}

}  // namespace selvage::protocol::plots
