#include "protocol/trade/svg/svg_pattern.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <pugixml.hpp>
#include <string>
#include <utility>

#include "protocol/document/frame.h"
#include "protocol/json/json_text.h"
#include "protocol/trade/aama/finishing.h"
#include "protocol/trade/aama/unfolding.h"
#include "protocol/trade/loops.h"
#include "protocol/trade/svg/svg_drawing.h"
#include "protocol/trade/text.h"

namespace selvage::protocol::trade::svg {
namespace {

constexpr double kReach = 0.01;     // millimetres
constexpr double kLeastUsed = 100;  // square millimetres: what <use> draws smaller than that is a mark, not a piece

class PatternMaker {
 public:
  PatternMaker(const std::vector<Drawn>& drawn, const ReadingOptions& options, Style& style)
      : drawn_{drawn}, options_{options}, style_{style} {}

  std::optional<Error> make() {
    find_outlines();
    if (outlines_.empty()) return Error{ErrorCode::kUnknownFormat, "the drawing has no closed outline", ""};
    share_out();
    for (std::size_t k = 0; k < outlines_.size(); ++k) finish(k);
    if (outside_ > 0) {
      style_.notes.push_back(
          {"", std::to_string(outside_) + " open lines and marks outside of all pieces are left out"});
    }
    style_.notes.push_back({"", "a drawing does not say how often a piece is needed: once each"});
    return std::nullopt;
  }

 private:
  // The index of the drawn element is stored as the line of a loop or run.
  void find_outlines() {
    std::vector<Loop> closed;
    std::map<std::string_view, std::vector<Run>> pieced;  // by their classes: lines that may form an outline together
    for (std::size_t k = 0; k < drawn_.size(); ++k) {
      Loops loops = joined(drawn_[k].runs, kReach);
      for (Loop& loop : loops.closed) {
        loop.line = k;
        if (drawn_[k].used && std::abs(doubled_area(loop.points)) / 2 < kLeastUsed) {
          open_.push_back({std::move(loop.points), {}, true, k});
          continue;
        }
        closed.push_back(std::move(loop));
      }
      for (Run& run : loops.open) {
        run.line = k;
        const bool mark = drawn_[k].used || drawn_[k].grain || drawn_[k].fold;
        (mark ? open_ : pieced[drawn_[k].classes]).push_back(std::move(run));
      }
    }
    for (auto& [classes, runs] : pieced) {
      Loops loops = joined(std::move(runs), kReach);
      std::move(loops.closed.begin(), loops.closed.end(), std::back_inserter(closed));
      std::move(loops.open.begin(), loops.open.end(), std::back_inserter(open_));
    }
    outlines_ = nested(std::move(closed));
    blocks_.resize(outlines_.size());
    for (std::size_t k = 0; k < outlines_.size(); ++k) {
      for (Loop& inner : outlines_[k].inner) {
        blocks_[k].annotations.lines.push_back({kind_of(drawn_[inner.line]), true, std::move(inner.points)});
      }
    }
  }

  static document::LineKind kind_of(const Drawn& drawn) {
    const bool cloth = has_word(drawn.classes, "fabric") || has_word(drawn.classes, "lining") ||
                       has_word(drawn.classes, "interfacing") || has_word(drawn.classes, "canvas");
    return cloth && !has_word(drawn.classes, "sa") ? document::LineKind::kSew : document::LineKind::kInternal;
  }

  // Open lines and marks are added to the piece in which they lie.
  void share_out() {
    for (Run& run : open_) {
      const Drawn& drawn = drawn_[run.line];
      const NestedLoop* around = around_of(outlines_, run.points);
      // The bracket of a fold begins and ends on the edge of its piece.
      if (!around && drawn.fold) around = around_of(outlines_, {run.points[run.points.size() / 2]});
      // A mark on the edge belongs to the piece that a part of it lies in.
      for (std::size_t k = 0; drawn.used && !around && k < run.points.size(); ++k) {
        around = around_of(outlines_, {run.points[k]});
      }
      if (!around) {
        ++outside_;
        continue;
      }
      aama::PatternBlock& block = blocks_[static_cast<std::size_t>(around - outlines_.data())];
      const std::pair<Spot, Spot> ends{run.points.front(), run.points.back()};
      if (drawn.fold && ends.first != ends.second) block.mirror_lines.push_back(ends);
      if (drawn.grain && ends.first != ends.second) block.grains.push_back(ends);
      if (!drawn.fold && !drawn.grain) {
        block.annotations.lines.push_back({kind_of(drawn), run.closed, std::move(run.points)});
      }
    }
  }

  void finish(std::size_t k) {
    std::vector<Note> notes;
    aama::PatternBlock& block = blocks_[k];
    const Drawn& drawn = drawn_[outlines_[k].loop.line];
    block.mirrored.assign(block.annotations.lines.size(), true);
    std::size_t dropped = 0;
    std::vector<Spot> points = without_repeats(containing_outline(outlines_[k].loop), dropped);
    if (outlines_[k].repeats > 0) notes.push_back({"", "its outline is drawn again; read once"});
    const bool half = options_.fold == FoldRule::kLay && aama::may_lie_on_fold(block, points, notes);
    if (options_.fold != FoldRule::kKeep && !half) aama::unfold(block, points, notes);
    if (!block.grains.empty()) {
      const auto& [from, to] = block.grains.front();
      block.annotations.lines.push_back({document::LineKind::kGrain, false, {from, to}});
    }
    const document::Frame turn{false, aama::turn_of_grain(block, notes), {}};
    if (doubled_area(points) < 0) std::reverse(points.begin(), points.end());
    PatternPiece piece;
    piece.name = drawn.name.empty() ? "piece" : drawn.name;
    for (const Spot& point : points) piece.outline.push_back(rounded(turn.apply(point)));
    piece.annotations = rounded(placed(block.annotations, turn));
    if (half) aama::lay_on_fold(block, turn, piece);
    for (const std::string_view material : {"fabric", "lining", "interfacing", "canvas"}) {
      if (has_word(drawn.classes, material)) piece.material = material;
    }
    for (const Note& note : notes) {
      style_.notes.push_back({"", "piece " + json::shortened(Json(piece.name)) + ": " + note.text});
    }
    if (piece.outline.size() > 2) style_.pieces.push_back(std::move(piece));
  }

  const std::vector<Drawn>& drawn_;
  const ReadingOptions& options_;
  Style& style_;
  std::vector<NestedLoop> outlines_;
  std::vector<aama::PatternBlock> blocks_;  // of the outlines: what lies in them
  std::vector<Run> open_;
  std::size_t outside_{};  // open lines in no piece
};

}  // namespace

bool looks_like_svg(std::string_view text) {
  const std::string_view begun = trimmed(text.substr(0, 4096));
  return begun.starts_with('<') && begun.find("<svg") != std::string_view::npos;
}

Result<Style> read_svg_pattern(std::string_view text, const ReadingOptions& options) {
  pugi::xml_document document;
  const auto parsed = document.load_buffer(text.data(), text.size());
  const pugi::xml_node svg = document.child("svg");
  if (!parsed || !svg) {
    return Error{
        ErrorCode::kSyntax,
        "no well-formed SVG: " + std::string{parsed.description()} + " at byte " + std::to_string(parsed.offset), ""};
  }
  if (svg.find_child_by_attribute("rect", "class", "page") && svg.find_child_by_attribute("rect", "class", "cloth")) {
    return Error{ErrorCode::kUnknownFormat,
                 "this is a drawing of a marker, which is not to scale; read the marker from which it was made", ""};
  }
  Style style;
  const auto drawn = drawn_lines(svg, text.size(), options, style.notes);
  if (!drawn) return drawn.error();
  if (const auto error = PatternMaker{*drawn, options, style}.make()) return *error;
  return style;
}

}  // namespace selvage::protocol::trade::svg
