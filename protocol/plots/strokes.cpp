#include "protocol/plots/strokes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "protocol/document/frame.h"
#include "protocol/plots/holes.h"

namespace selvage::protocol::plots {
namespace {

constexpr double kLargestLabel = 10, kSmallestLabel = 2, kUsualNotch = 4, kDrillArm = 3;  // millimetres
constexpr double kLetterWidth = 0.65;                                                     // of the height, about

Spot away(Spot from, double degrees, double by) {
  const double angle = degrees * std::numbers::pi / 180;
  return {from.x + by * std::cos(angle), from.y + by * std::sin(angle)};
}

void add_notch(Plot& plot, const document::Notch& notch, const std::vector<Spot>& outline) {
  const double inward = direction_of(notch, outline);
  const double depth = notch.depth > 0 ? notch.depth : kUsualNotch;
  const Spot tip = away(notch.at, inward, depth);
  if (notch.width <= 0) {
    plot.strokes.push_back({StrokeStyle::kInner, false, {notch.at, tip}});
    return;
  }
  const Spot left = away(notch.at, inward + 90, notch.width / 2), right = away(notch.at, inward - 90, notch.width / 2);
  switch (notch.kind) {
    case document::NotchKind::kT:
      plot.strokes.push_back({StrokeStyle::kInner, false, {notch.at, tip}});
      plot.strokes.push_back({StrokeStyle::kInner,
                              false,
                              {away(tip, inward + 90, notch.width / 2), away(tip, inward - 90, notch.width / 2)}});
      break;
    case document::NotchKind::kCastle:
    case document::NotchKind::kU:
      plot.strokes.push_back(
          {StrokeStyle::kInner, false, {left, away(left, inward, depth), away(right, inward, depth), right}});
      break;
    case document::NotchKind::kCheck:
      plot.strokes.push_back({StrokeStyle::kInner, false, {notch.at, tip, right}});
      break;
    default: plot.strokes.push_back({StrokeStyle::kInner, false, {left, tip, right}}); break;
  }
}

void add_annotations(Plot& plot, const SheetPiece& piece) {
  for (const document::Notch& notch : piece.annotations.notches) add_notch(plot, notch, piece.outline);
  for (const Spot& drill : piece.annotations.drills) {
    plot.strokes.push_back(
        {StrokeStyle::kInner, false, {{drill.x - kDrillArm, drill.y}, {drill.x + kDrillArm, drill.y}}});
    plot.strokes.push_back(
        {StrokeStyle::kInner, false, {{drill.x, drill.y - kDrillArm}, {drill.x, drill.y + kDrillArm}}});
  }
  for (const document::DrawnLine& line : piece.annotations.lines) {
    const bool dashed = line.kind == document::LineKind::kSew || line.kind == document::LineKind::kMirror;
    plot.strokes.push_back({dashed ? StrokeStyle::kDashed : StrokeStyle::kInner, line.closed, line.points});
  }
  for (const document::DrawnText& text : piece.annotations.texts) {
    if (text.height >= 1) plot.labels.push_back({text.text, text.at, std::min(text.height, kLargestLabel), text.angle});
  }
}

void add_label(Plot& plot, const SheetPiece& piece) {
  if (piece.label.empty()) return;
  const double aspect = std::max(1.0, kLetterWidth * static_cast<double>(in_ascii(piece.label).size()));
  const LabelPlace place = label_place(piece, aspect, kLargestLabel);
  if (place.height < kSmallestLabel) return;
  const double half = aspect * place.height / 2;
  const double letters = place.height * 0.7;  // of the line's height
  const Spot middle = place.middle;
  const Spot at =
      place.upright ? Spot{middle.x + letters / 2, middle.y - half} : Spot{middle.x - half, middle.y - letters / 2};
  plot.labels.push_back({piece.label, at, letters, place.upright ? 90.0 : 0.0});
}

}  // namespace

Plot plot_of(const Sheet& sheet) {
  Plot plot{sheet.width, sheet.length, {}, {}};
  plot.strokes.push_back(
      {StrokeStyle::kFrame, true, {{0, 0}, {sheet.length, 0}, {sheet.length, sheet.width}, {0, sheet.width}}});
  for (const SheetPiece& piece : sheet.pieces) {
    plot.strokes.push_back({StrokeStyle::kOutline, true, piece.outline});
    add_label(plot, piece);  // first: what reads plots takes the first label in a piece for its name
    add_annotations(plot, piece);
  }
  return plot;
}

std::string figures_of(const Sheet& sheet) {
  return std::to_string(sheet.pieces.size()) + (sheet.pieces.size() == 1 ? " piece" : " pieces") + ", length " +
         thousandths(sheet.length) + " mm, width " + thousandths(sheet.width) + " mm, utilisation " +
         thousandths(100 * sheet.utilisation) + " %";
}

std::string title_of(const Sheet& sheet) {
  return sheet.name.empty() ? "Marker" : sheet.name;
}

}  // namespace selvage::protocol::plots
