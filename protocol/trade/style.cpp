#include "protocol/trade/style.h"

#include <algorithm>
#include <cmath>
#include <set>

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

void cut_from_two_layers(Style& style) {
  std::set<std::string> noted;  // by name: the sizes of a piece have the same quantity
  for (PatternPiece& piece : style.pieces) {
    const Quantity wanted = piece.quantity;
    const int all = wanted.right + wanted.left;
    const int pairs = wanted.left > 0 ? std::max(wanted.right, wanted.left) : (wanted.right + 1) / 2;
    piece.quantity = {piece.half ? all : pairs, 0};
    if (piece.half) continue;
    piece.attributes["layers"] = 2;
    if ((wanted.left > 0 && wanted.left == wanted.right) || !noted.insert(piece.name).second) continue;
    std::string text = piece.name + ": " + std::to_string(all) + " are cut as " + std::to_string(pairs) +
                       (pairs == 1 ? " pair" : " pairs") + " from two layers";
    if (2 * pairs > all) text += ", " + std::to_string(2 * pairs - all) + " more than wanted";
    style.notes.push_back(note_at(piece.line, std::move(text)));
  }
}

Note note_at(std::size_t line, std::string text) {
  return {line_field(line), std::move(text)};
}

Error error_at(std::size_t line, ErrorCode code, const std::string& text) {
  return {code, "line " + std::to_string(line) + ": " + text, line_field(line)};
}

}  // namespace selvage::protocol::trade
