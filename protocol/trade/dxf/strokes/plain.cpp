#include "protocol/trade/dxf/strokes/plain.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "protocol/json/json_text.h"
#include "protocol/trade/dxf/strokes/curves.h"
#include "protocol/trade/dxf/strokes/fitted_spline.h"
#include "protocol/trade/dxf/strokes/insertion.h"
#include "protocol/trade/dxf/units.h"
#include "protocol/trade/loops.h"
#include "protocol/trade/text.h"

namespace selvage::protocol::trade::dxf::strokes {
namespace {

constexpr double kReach = 0.01;  // millimetres, between the ends of lines

class PlainReader {
 public:
  PlainReader(const DxfDrawing& drawing, double unit, Flattening flattening, std::vector<Note>& notes)
      : drawing_{drawing}, unit_{unit}, flattening_{flattening}, notes_{notes} {}

  Result<std::vector<Run>> read() {
    const Insertion model{unit_, 0, 0, unit_, {}};
    for (const Entity& entity : drawing_.entities) add(entity, model, nullptr, 0);
    if (blocks_.error()) return *blocks_.error();
    if (const auto error = flattening_.error()) return *error;
    for (const auto& [what, line] : passed_over_) notes_.push_back(note_at(line, what));
    return std::move(runs_);
  }

 private:
  // `insert`: the one that inserts the entity; null for an entity of the drawing itself.
  void add(const Entity& entity, const Insertion& outer, const Entity* insert, int depth) {
    if (blocks_.error()) return;
    if (drawing_.hidden_layers.contains(entity.layer)) {
      return pass_over("layer " + json::shortened(Json(printable(entity.layer))) + " is frozen or off and is not read",
                       entity);
    }
    const Insertion insertion = from_behind(entity) ? outer.after(kSeenFromBehind) : outer;
    if (entity.type == "INSERT") return add_block(entity, insertion, depth);
    const Flattening::Enlarged enlarged{flattening_, insertion.scale() / unit_};
    auto run = run_of(entity, flattening_);
    if (!run) {
      if (entity.type != "ATTRIB" && entity.type != "ATTDEF")
        pass_over(std::string{entity.type} + " is not read", entity);
      return;
    }
    if (is_fitted(entity)) pass_over(std::string{kFittedNote}, entity);
    insertion.apply(*run);
    if (insert) blocks_.take(run->points.size(), *insert, depth - 1);
    runs_.push_back(*std::move(run));
  }

  void add_block(const Entity& insert, const Insertion& outer, int depth) {
    if (!blocks_.of(insert)) {
      return pass_over(
          "INSERT of block " + json::shortened(Json(printable(insert.text(2)))) + ", which is not in the file", insert);
    }
    blocks_.insert(insert, outer, depth, [&](const Block& block, const Insertion& insertion) {
      for (const Entity& inner : block.entities) add(inner, insertion, &insert, depth + 1);
    });
  }

  void pass_over(const std::string& what, const Entity& entity) { passed_over_.emplace(what, entity.line); }

  const DxfDrawing& drawing_;
  double unit_;
  Flattening flattening_;  // in the file's unit
  std::vector<Note>& notes_;
  Blocks blocks_{drawing_};
  std::map<std::string, std::size_t> passed_over_;  // what is not read, or not for certain -> the first line of it
  std::vector<Run> runs_;
};

// The open lines within each outline; the others are left out, with a note.
std::vector<document::Annotations> lines_within(std::vector<NestedLoop>& outlines, std::vector<Run> open,
                                                std::vector<Note>& notes) {
  std::vector<document::Annotations> within(outlines.size());
  for (Run& run : open) {
    const NestedLoop* const around = around_of(outlines, run.points);
    if (!around) {
      notes.push_back(note_at(run.line, "an open line outside of all pieces left out"));
      continue;
    }
    within[static_cast<std::size_t>(around - outlines.data())].lines.push_back(
        {document::LineKind::kInternal, false, std::move(run.points)});
  }
  return within;
}

PatternPiece piece_of(NestedLoop outline, document::Annotations open_lines, std::size_t number) {
  PatternPiece piece;
  piece.name = "piece " + std::to_string(number);
  piece.line = outline.loop.line;
  std::size_t dropped = 0;
  for (const Spot& point : without_repeats(containing_outline(outline.loop), dropped)) {
    piece.outline.push_back(rounded(point));
  }
  piece.annotations = std::move(open_lines);
  for (Loop& inner : outline.inner) {
    piece.annotations.lines.push_back({document::LineKind::kCutOut, true, std::move(inner.points)});
  }
  piece.annotations = rounded(std::move(piece.annotations));
  return piece;
}

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
  std::vector<document::Annotations> open_lines = lines_within(outlines, std::move(loops.open), style.notes);
  for (const NestedLoop& outline : outlines) {
    if (outline.repeats > 0) style.notes.push_back(note_at(outline.loop.line, "an outline is drawn again; read once"));
  }
  for (std::size_t k = 0; k < outlines.size(); ++k) {
    PatternPiece piece = piece_of(std::move(outlines[k]), std::move(open_lines[k]), style.pieces.size() + 1);
    if (piece.outline.size() > 2) style.pieces.push_back(std::move(piece));
  }
  style.notes.push_back({"", "a drawing does not say how often a piece is needed: once each"});
  return style;
}

}  // namespace selvage::protocol::trade::dxf::strokes
