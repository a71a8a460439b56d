#include "protocol/trade/dxf/plain.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "protocol/trade/dxf/curves.h"
#include "protocol/trade/dxf/units.h"
#include "protocol/trade/loops.h"
#include "protocol/trade/text.h"

namespace selvage::protocol::trade::dxf {
namespace {

constexpr double kReach = 0.01;  // millimetres, between the ends of lines

// How an INSERT scales, rotates and moves its block; then the conversion of the unit.
struct Insertion {
  double xx{1}, xy{}, yx{}, yy{1};
  Spot at{};
  [[nodiscard]] Spot apply(Spot p) const { return {xx * p.x + xy * p.y + at.x, yx * p.x + yy * p.y + at.y}; }
  void apply(Run& run) const {
    for (Spot& point : run.points) point = apply(point);
    for (Edge& edge : run.edges) {
      if (edge.apex) edge.apex = apply(*edge.apex);
    }
  }
};

Insertion insertion_of(const Entity& insert, double unit) {
  const double sx = insert.number(41).value_or(1), sy = insert.number(42).value_or(1);
  const double angle = insert.number(50).value_or(0) * std::numbers::pi / 180;
  const double c = std::cos(angle), s = std::sin(angle);
  const Spot at = insert.vertices.empty() ? Spot{} : Spot{insert.vertices.front().x, insert.vertices.front().y};
  return {unit * c * sx, -unit * s * sy, unit * s * sx, unit * c * sy, {unit * at.x, unit * at.y}};
}

class PlainReader {
 public:
  PlainReader(const DxfDrawing& drawing, double unit, double tolerance)
      : drawing_{drawing}, unit_{unit}, tolerance_{tolerance / unit} {}

  std::vector<Run> read() {
    std::map<std::string_view, const Block*> blocks;
    for (const Block& block : drawing_.blocks) blocks.emplace(block.name, &block);
    const Insertion model{unit_, 0, 0, unit_, {}};
    for (const Entity& entity : drawing_.entities) {
      const auto block = entity.type == "INSERT" ? blocks.find(entity.text(2)) : blocks.end();
      if (block == blocks.end()) {
        add(entity, model);
        continue;
      }
      const Insertion insertion = insertion_of(entity, unit_);
      for (const Entity& inner : block->second->entities) add(inner, insertion);
    }
    return std::move(runs_);
  }

 private:
  void add(const Entity& entity, const Insertion& insertion) {
    auto run = run_of(entity, tolerance_);
    if (!run) return;
    insertion.apply(*run);
    runs_.push_back(*std::move(run));
  }

  const DxfDrawing& drawing_;
  double unit_, tolerance_;
  std::vector<Run> runs_;
};

}  // namespace

Result<Style> read_plain(std::string_view text, const ReadingOptions& options) {
  const auto tags = read_tags(text);
  if (!tags) return tags.error();
  const auto drawing = read_drawing(*tags);
  if (!drawing) return drawing.error();
  Style style;
  const auto unit = settle_unit({}, drawing->insert_units, options.unit, style.notes);
  if (!unit) return unit.error();
  Loops loops = joined(PlainReader{*drawing, *unit, options.tolerance}.read(), kReach);
  std::vector<NestedLoop> outlines = nested(std::move(loops.closed));
  if (outlines.empty()) return Error{ErrorCode::kUnknownFormat, "the DXF has no closed outline", ""};
  std::vector<document::Annotations> open_lines(outlines.size());
  for (Run& open : loops.open) {
    const NestedLoop* const around = around_of(outlines, open.points);
    if (!around) continue;
    open_lines[static_cast<std::size_t>(around - outlines.data())].lines.push_back(
        {document::LineKind::kInternal, false, std::move(open.points)});
  }
  for (std::size_t k = 0; k < outlines.size(); ++k) {
    PatternPiece piece;
    piece.name = "piece " + std::to_string(style.pieces.size() + 1);
    piece.line = outlines[k].loop.line;
    std::size_t dropped = 0;
    for (const Spot& point : without_repeats(containing_outline(outlines[k].loop), dropped)) {
      piece.outline.push_back(rounded(point));
    }
    piece.annotations = std::move(open_lines[k]);
    for (Loop& inner : outlines[k].inner) {
      piece.annotations.lines.push_back({document::LineKind::kCutOut, true, std::move(inner.points)});
    }
    piece.annotations = rounded(std::move(piece.annotations));
    if (piece.outline.size() > 2) style.pieces.push_back(std::move(piece));
  }
  style.notes.push_back({"", "a drawing does not say how often a piece is needed: once each"});
  return style;
}

}  // namespace selvage::protocol::trade::dxf
