#include "protocol/trade/hpgl/hpgl_marker.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "protocol/trade/hpgl/pen_strokes.h"
#include "protocol/trade/placed_marker.h"

namespace selvage::protocol::trade::hpgl {
namespace {

constexpr double kPlotterUnit = 0.025;  // millimetres
constexpr double kEndsReach = 0.06;     // millimetres, between the ends of strokes
constexpr double kLeastPiece = 100;     // square millimetres; smaller isolated outlines are marks

void to_millimetres(Run& run, double unit) {
  for (Spot& point : run.points) point = {point.x * unit, point.y * unit};
  for (Edge& edge : run.edges) {
    if (edge.apex) edge.apex = Spot{edge.apex->x * unit, edge.apex->y * unit};
  }
}

bool is_rectangle(const Loop& loop) {
  std::size_t dropped = 0;
  const std::vector<Spot> corners = without_repeats(loop.points, dropped);
  if (corners.size() != 4) return false;
  for (std::size_t k = 0; k < 4; ++k) {
    const Spot a = corners[k], b = corners[(k + 1) % 4];
    if (std::min(std::abs(a.x - b.x), std::abs(a.y - b.y)) > kEndsReach) return false;
  }
  return true;
}

struct Bounds {
  Spot low, high;
};
Bounds bounds_of(const Loop& loop) {
  Bounds box{loop.points.front(), loop.points.front()};
  for (const Spot& point : loop.points) {
    box.low = {std::min(box.low.x, point.x), std::min(box.low.y, point.y)};
    box.high = {std::max(box.high.x, point.x), std::max(box.high.y, point.y)};
  }
  return box;
}
bool within(const Bounds& inner, const Bounds& outer) {
  return inner.low.x >= outer.low.x - kEndsReach && inner.low.y >= outer.low.y - kEndsReach &&
         inner.high.x <= outer.high.x + kEndsReach && inner.high.y <= outer.high.y + kEndsReach;
}

// Removes the frame, if there is one: a rectangle, drawn once or more, in whose box everything else lies.  Pieces may
// touch it.
std::optional<Bounds> take_frame(std::vector<Loop>& closed) {
  const auto area = [](const Loop& loop) { return std::abs(doubled_area(loop.points)) / 2; };
  const auto largest = std::ranges::max_element(closed, {}, area);
  if (largest == closed.end() || !is_rectangle(*largest)) return std::nullopt;
  const Bounds frame = bounds_of(*largest);
  const auto is_frame = [&](const Loop& loop) { return is_rectangle(loop) && within(frame, bounds_of(loop)); };
  if (!std::ranges::all_of(closed, [&](const Loop& loop) { return within(bounds_of(loop), frame); }))
    return std::nullopt;
  if (std::ranges::none_of(closed, [&](const Loop& loop) { return area(loop) >= kLeastPiece && !is_frame(loop); })) {
    return std::nullopt;
  }
  std::erase_if(closed, is_frame);
  return frame;
}

Spot from_corner(Spot spot, Spot corner) {
  return rounded({spot.x - corner.x, spot.y - corner.y});
}
document::DrawnLine inner_line(bool closed, std::vector<Spot> points, Spot corner) {
  for (Spot& point : points) point = from_corner(point, corner);
  return {document::LineKind::kInternal, closed, std::move(points)};
}

class PlotReader {
 public:
  PlotReader(PenStrokes strokes, double unit) : strokes_{std::move(strokes)} {
    for (Run& run : strokes_.runs) to_millimetres(run, unit);
    for (Run& run : strokes_.dashed) to_millimetres(run, unit);
    for (PenLabel& label : strokes_.labels) label.at = {label.at.x * unit, label.at.y * unit};
  }

  PlacedMarker read() {
    Loops loops = joined(std::move(strokes_.runs), kEndsReach);
    frame_ = take_frame(loops.closed);
    outlines_ = nested(std::move(loops.closed));
    if (frame_) corner_ = frame_->low;
    std::erase_if(outlines_, [](const NestedLoop& outline) {
      return std::abs(doubled_area(outline.loop.points)) / 2 < kLeastPiece;
    });
    for (NestedLoop& outline : outlines_) marker_.pieces.push_back(pattern_of(outline));
    for (Run& run : loops.open) add_line(std::move(run));
    for (Run& run : strokes_.dashed) add_line(std::move(run));
    name_pieces();
    say_what_was_read();
    return std::move(marker_);
  }
  [[nodiscard]] std::optional<double> width() const {
    return frame_ ? std::optional{std::round((frame_->high.y - frame_->low.y) * 1000) / 1000} : std::nullopt;
  }

 private:
  PlacedPattern pattern_of(const NestedLoop& outline) const {
    PlacedPattern piece;
    std::size_t dropped = 0;
    for (const Spot& point : without_repeats(containing_outline(outline.loop), dropped)) {
      piece.outline.push_back(from_corner(point, corner_));
    }
    for (const Loop& inner : outline.inner) piece.annotations.lines.push_back(inner_line(true, inner.points, corner_));
    return piece;
  }
  void add_line(Run run) {
    const NestedLoop* const around = around_of(outlines_, run.points);
    if (!around) {
      ++outside_;
      return;
    }
    marker_.pieces[static_cast<std::size_t>(around - outlines_.data())].annotations.lines.push_back(
        inner_line(run.closed, std::move(run.points), corner_));
  }
  void name_pieces() {
    for (const PenLabel& label : strokes_.labels) {
      for (std::size_t k = 0; k < outlines_.size(); ++k) {
        if (!contains(outlines_[k].loop.points, label.at)) continue;
        if (marker_.pieces[k].name.empty()) marker_.pieces[k].name = label.text;
        break;
      }
    }
  }
  void say_what_was_read() {
    marker_.notes = std::move(strokes_.notes);
    marker_.notes.push_back(
        {"", "a plot does not say which lines are cut: every outermost closed line is taken as a piece"});
    if (frame_) marker_.notes.push_back({"", "the rectangle around everything is taken as the cloth's edges"});
    if (outside_ > 0) {
      marker_.notes.push_back({"", std::to_string(outside_) + " lines outside of all pieces are left out"});
    }
  }

  PenStrokes strokes_;
  std::vector<NestedLoop> outlines_;
  std::optional<Bounds> frame_;
  Spot corner_{};
  PlacedMarker marker_;
  std::size_t outside_{};
};

}  // namespace

Result<MarkerFile> read_hpgl_marker(std::string_view text, const ReadingOptions& options) {
  const double unit = options.unit ? in_millimetres(*options.unit) : kPlotterUnit;
  Flattening flattening{options.tolerance / unit, text.size()};
  PlotReader reader{read_strokes(text, flattening), unit};
  if (const auto error = flattening.error()) return *error;
  PlacedMarker marker = reader.read();
  ReadingOptions placed = options;
  if (!placed.width) placed.width = reader.width();
  return file_of(std::move(marker), placed);
}

}  // namespace selvage::protocol::trade::hpgl
