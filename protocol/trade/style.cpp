#include "protocol/trade/style.h"

#include <algorithm>
#include <cmath>

#include "protocol/trade/text.h"

namespace selvage::protocol::trade {

double rounded(double millimetres) {
  constexpr double kPerMillimetre = 1e6;
  constexpr double kExact = 1e9;  // beyond this a double has no millionths
  if (!(std::abs(millimetres) < kExact)) return millimetres;
  return std::round(millimetres * kPerMillimetre) / kPerMillimetre + 0.0;
}

Spot rounded(Spot spot) {
  return {rounded(spot.x), rounded(spot.y)};
}

document::Annotations rounded(document::Annotations annotations) {
  for (document::Notch& notch : annotations.notches) {
    notch.at = rounded(notch.at);
    notch.depth = rounded(notch.depth);
    notch.width = rounded(notch.width);
    if (notch.angle) notch.angle = rounded(*notch.angle);
  }
  for (Spot& drill : annotations.drills) drill = rounded(drill);
  for (document::DrawnLine& line : annotations.lines) {
    for (Spot& point : line.points) point = rounded(point);
  }
  for (document::DrawnText& text : annotations.texts) {
    text.at = rounded(text.at);
    text.height = rounded(text.height);
    text.angle = rounded(text.angle);
  }
  return annotations;
}

bool within_reach(const std::vector<Spot>& points) {
  constexpr double kFarthest = 1e8;
  return std::all_of(points.begin(), points.end(),
                     [](Spot point) { return std::abs(point.x) <= kFarthest && std::abs(point.y) <= kFarthest; });
}

Note note_at(std::size_t line, std::string text) {
  return {line_field(line), std::move(text)};
}

Error error_at(std::size_t line, ErrorCode code, const std::string& text) {
  return {code, "line " + std::to_string(line) + ": " + text, line_field(line)};
}

}  // namespace selvage::protocol::trade
