#include "protocol/trade/dxf/plain.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "protocol/json/json_text.h"
#include "protocol/trade/dxf/curves.h"
#include "protocol/trade/dxf/units.h"
#include "protocol/trade/loops.h"
#include "protocol/trade/text.h"

namespace selvage::protocol::trade::dxf {
namespace {

constexpr double kReach = 0.01;  // millimetres, between the ends of lines

// How an INSERT, and the INSERTs around it, scale, rotate and move a block; then the conversion of the unit.
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
  // First `inner`, then this one.
  [[nodiscard]] Insertion after(const Insertion& inner) const {
    return {xx * inner.xx + xy * inner.yx, xx * inner.xy + xy * inner.yy, yx * inner.xx + yy * inner.yx,
            yx * inner.xy + yy * inner.yy, apply(inner.at)};
  }
};

// An entity that is seen from behind, with the extrusion direction 0, 0, -1, has the coordinate -x for x.
bool from_behind(const Entity& entity) {
  return entity.number(230).value_or(1) < 0 && entity.type != "LINE" && entity.type != "SPLINE" &&
         entity.type != "ELLIPSE";
}
constexpr Insertion kMirrored{-1, 0, 0, 1, {}};

// The copy in this column and row of an INSERT, which may be an array.
Insertion insertion_of(const Entity& insert, const Block& block, int column, int row) {
  const double sx = insert.number(41).value_or(1), sy = insert.number(42).value_or(1);
  const double angle = insert.number(50).value_or(0) * std::numbers::pi / 180;
  const double c = std::cos(angle), s = std::sin(angle);
  const Spot at = insert.vertices.empty() ? Spot{} : Spot{insert.vertices.front().x, insert.vertices.front().y};
  const Spot step{column * insert.number(44).value_or(0), row * insert.number(45).value_or(0)};
  Insertion placed{c * sx, -s * sy, s * sx, c * sy, {at.x + c * step.x - s * step.y, at.y + s * step.x + c * step.y}};
  placed.at = placed.apply({-block.base_x, -block.base_y});
  return placed;
}

class PlainReader {
 public:
  PlainReader(const DxfDrawing& drawing, double unit, Flattening flattening, std::vector<Note>& notes)
      : drawing_{drawing}, unit_{unit}, flattening_{flattening}, notes_{notes} {}

  Result<std::vector<Run>> read() {
    for (const Block& block : drawing_.blocks) blocks_.emplace(block.name, &block);
    const Insertion model{unit_, 0, 0, unit_, {}};
    for (const Entity& entity : drawing_.entities) add(entity, model, 0);
    if (too_many_) return *too_many_;
    if (const auto error = flattening_.error()) return *error;
    for (const auto& [what, line] : passed_over_) notes_.push_back(note_at(line, what));
    return std::move(runs_);
  }

 private:
  void add(const Entity& entity, const Insertion& outer, int depth) {
    if (too_many_) return;
    if (drawing_.hidden_layers.contains(entity.layer)) {
      return pass_over("layer " + json::shortened(Json(printable(entity.layer))) + " is frozen or off and is not read",
                       entity);
    }
    const Insertion insertion = from_behind(entity) ? outer.after(kMirrored) : outer;
    if (entity.type == "INSERT") return add_block(entity, insertion, depth);
    auto run = run_of(entity, flattening_);
    if (!run) {
      if (entity.type != "ATTRIB" && entity.type != "ATTDEF")
        pass_over(std::string{entity.type} + " is not read", entity);
      return;
    }
    insertion.apply(*run);
    if (depth > 0) inserted_ += run->points.size();
    runs_.push_back(*std::move(run));
  }

  void add_block(const Entity& insert, const Insertion& outer, int depth) {
    constexpr int kDeepest = 16, kMostSteps = 1000;
    constexpr std::size_t kMostInserted = 500'000;  // a few blocks that insert one another can ask for billions
    const auto block = blocks_.find(insert.text(2));
    const std::string name = json::shortened(Json(printable(insert.text(2))));
    if (block == blocks_.end()) return pass_over("INSERT of block " + name + ", which is not in the file", insert);
    const auto steps = [&](int code) {
      return static_cast<int>(std::clamp(insert.number(code).value_or(1), 1.0, 1.0 * kMostSteps));
    };
    for (int column = 0; column < steps(70) && !too_many_; ++column) {
      for (int row = 0; row < steps(71) && !too_many_; ++row) {
        inserted_ += block->second->entities.size() + 1;
        if (depth == kDeepest || inserted_ > kMostInserted) {
          too_many_ =
              error_at(insert.line, ErrorCode::kOutOfRange,
                       "INSERT of block " + name +
                           ": blocks are nested more than 16 deep, or insert more than 500,000 entities and points");
          return;
        }
        const Insertion insertion = outer.after(insertion_of(insert, *block->second, column, row));
        for (const Entity& inner : block->second->entities) add(inner, insertion, depth + 1);
      }
    }
  }

  void pass_over(const std::string& what, const Entity& entity) { passed_over_.emplace(what, entity.line); }

  const DxfDrawing& drawing_;
  double unit_;
  Flattening flattening_;  // in the file's unit
  std::vector<Note>& notes_;
  std::map<std::string_view, const Block*> blocks_;
  std::map<std::string, std::size_t> passed_over_;  // what is not read -> the first line of it
  std::size_t inserted_{};                          // entities and points of blocks so far
  std::optional<Error> too_many_;
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
  auto runs = PlainReader{*drawing, *unit, {options.tolerance / *unit, text.size()}, style.notes}.read();
  if (!runs) return runs.error();
  Loops loops = joined(*std::move(runs), kReach);
  std::vector<NestedLoop> outlines = nested(std::move(loops.closed));
  if (outlines.empty()) {
    return Error{ErrorCode::kUnknownFormat,
                 "the DXF has no closed outline: none of its " + std::to_string(loops.open.size()) +
                     " lines is closed, alone or joined to others",
                 ""};
  }
  std::vector<document::Annotations> open_lines(outlines.size());
  for (Run& open : loops.open) {
    const NestedLoop* const around = around_of(outlines, open.points);
    if (!around) {
      style.notes.push_back(note_at(open.line, "an open line outside of all pieces left out"));
      continue;
    }
    open_lines[static_cast<std::size_t>(around - outlines.data())].lines.push_back(
        {document::LineKind::kInternal, false, std::move(open.points)});
  }
  for (const NestedLoop& outline : outlines) {
    if (outline.repeats > 0) style.notes.push_back(note_at(outline.loop.line, "an outline is drawn again; read once"));
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
