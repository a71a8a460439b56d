#include "protocol/plots/cut_file.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "protocol/document/frame.h"
#include "protocol/plots/holes.h"
#include "protocol/plots/route.h"

namespace selvage::protocol::plots {
namespace {

constexpr double kCutUnits = 10;                       // G71
constexpr double kLabelAspect = 3, kLabelHeight = 20;  // the room that a printed or stuck label takes, about

std::string number(double millimetres) {
  // The format has no negative coordinates.
  return std::to_string(std::max(0LL, std::llround(millimetres * kCutUnits)));
}

std::string point(Spot spot) {
  return "X" + number(spot.x) + "Y" + number(spot.y);
}

double distance(Spot a, Spot b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

class Cutter {
 public:
  explicit Cutter(const Sheet& sheet) : sheet_{sheet} {}

  CutFile write() {
    std::vector<std::vector<Spot>> outlines;
    for (const SheetPiece& piece : sheet_.pieces) outlines.push_back(piece.outline);
    const Route route = route_through(outlines, pieces_in_holes(sheet_));
    text_ = "H1*G71*M70*M15*M20*" + cut_label(sheet_.name) + "*";
    std::size_t number_of_piece = 0;
    for (const RouteStop& stop : route.stops) {
      text_ += "N" + std::to_string(++number_of_piece) + "*";
      cut_piece(sheet_.pieces[stop.piece], stop.vertex);
    }
    text_ += "M15*M0*\n";
    return {std::move(text_), route.travel, travel_as_given(outlines)};
  }

 private:
  void cut_piece(const SheetPiece& piece, std::size_t first) {
    text_ += point(label_place(piece, kLabelAspect, kLabelHeight).middle) + "M31*" + cut_label(piece.label) + "*";
    for (const Spot& drill : piece.annotations.drills) text_ += point(drill) + "M43*";
    Spot here = piece.outline[first];
    for (const document::Notch& notch : piece.annotations.notches) {
      if (notch.depth <= 0) continue;
      const double angle = direction_of(notch, piece.outline) * std::numbers::pi / 180;
      here = {notch.at.x + notch.depth * std::cos(angle), notch.at.y + notch.depth * std::sin(angle)};
      cut({notch.at, here});
    }
    for (const document::DrawnLine& line : piece.annotations.lines) {
      if (line.kind != document::LineKind::kCutOut) continue;
      std::vector<Spot> points = line.points;
      if (line.closed) points.push_back(points.front());
      if (distance(here, points.back()) < distance(here, points.front())) std::reverse(points.begin(), points.end());
      cut(points);
      here = points.back();
    }
    std::vector<Spot> around{piece.outline.begin() + static_cast<std::ptrdiff_t>(first), piece.outline.end()};
    around.insert(around.end(), piece.outline.begin(), piece.outline.begin() + static_cast<std::ptrdiff_t>(first) + 1);
    cut(around);
  }

  void cut(const std::vector<Spot>& points) {
    text_ += point(points.front()) + "*M14*";
    for (std::size_t k = 1; k < points.size(); ++k) text_ += point(points[k]) + "*";
    text_ += "M15*";
  }

  const Sheet& sheet_;
  std::string text_;
};

}  // namespace

std::string cut_label(const std::string& text) {
  std::string label = in_ascii(text);
  std::replace(label.begin(), label.end(), '*', '.');
  return label.empty() ? "-" : label;
}

CutFile cut_file(const Sheet& sheet) {
  return Cutter{sheet}.write();
}

}  // namespace selvage::protocol::plots
