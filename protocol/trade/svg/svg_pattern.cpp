#include "protocol/trade/svg/svg_pattern.h"

#include <algorithm>
#include <cmath>
#include <pugixml.hpp>
#include <string>
#include <utility>

#include "protocol/document/frame.h"
#include "protocol/json/json_text.h"
#include "protocol/trade/aama/finishing.h"
#include "protocol/trade/loops.h"
#include "protocol/trade/svg/svg_path.h"
#include "protocol/trade/text.h"

namespace selvage::protocol::trade::svg {
namespace {

constexpr double kMillimetresPerPixel = 25.4 / 96;
constexpr double kReach = 0.01;  // millimetres
constexpr int kDeepest = 200;    // nested groups

bool has_word(std::string_view text, std::string_view word) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (text.substr(0, end) == word) return true;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return false;
}

// A line of the drawing, in millimetres, y upwards.
struct Drawn {
  std::string classes, name;
  std::vector<Run> runs;
  bool grain{}, fold{};
};

std::optional<double> millimetres_of(std::string_view unit) {
  for (const auto& [word, factor] : {std::pair{"mm", 1.0},
                                     {"cm", 10.0},
                                     {"in", 25.4},
                                     {"pt", 25.4 / 72},
                                     {"pc", 25.4 / 6},
                                     {"px", kMillimetresPerPixel}}) {
    if (unit == word) return factor;
  }
  return std::nullopt;
}

class DrawingReader {
 public:
  explicit DrawingReader(const ReadingOptions& options) : options_{options} {}

  std::vector<Drawn> read(const pugi::xml_node& svg, std::vector<Note>& notes) {
    const double unit = settle_unit(svg, notes);
    visit(svg, {unit, 0, 0, -unit, 0, 0}, "", 0);
    if (used_) notes.push_back({"", "<use> is not read"});
    return std::move(drawn_);
  }

 private:
  double settle_unit(const pugi::xml_node& svg, std::vector<Note>& notes) const {
    if (options_.unit) return in_millimetres(*options_.unit);
    const auto width = length_in(svg.attribute("width").value());
    const std::vector<double> box = numbers_in(svg.attribute("viewBox").value());
    const auto unit = width ? millimetres_of(width->unit) : std::nullopt;
    if (unit && box.size() == 4 && box[2] > 0 && width->value > 0) return width->value * *unit / box[2];
    notes.push_back({"", "the drawing does not say how large it is: a unit is taken for 1/96 in"});
    return kMillimetresPerPixel;
  }

  static bool hidden(const pugi::xml_node& node) {
    static constexpr std::string_view kUnseen[] = {"defs",   "symbol",  "clipPath", "mask",
                                                   "marker", "pattern", "style",    "metadata"};
    const std::string_view name = node.name(), style = node.attribute("style").value();
    return std::find(std::begin(kUnseen), std::end(kUnseen), name) != std::end(kUnseen) ||
           std::string_view{node.attribute("display").value()} == "none" ||
           style.find("display:none") != std::string_view::npos ||
           style.find("display: none") != std::string_view::npos || has_word(node.attribute("class").value(), "hidden");
  }

  void visit(const pugi::xml_node& node, const Matrix& outer, const std::string& name, int depth) {
    if (depth > kDeepest || hidden(node)) return;
    const Matrix matrix = outer.after(transform_in(node.attribute("transform").value()).value_or(Matrix{}));
    const std::string_view element = node.name();
    const std::string own = name_of(node);
    const std::string& inherited = element == "g" && !own.empty() ? own : name;
    if (element == "use") used_ = true;
    add(node, element, matrix, inherited);
    for (const pugi::xml_node& child : node.children()) visit(child, matrix, inherited, depth + 1);
  }

  static std::string name_of(const pugi::xml_node& node) {
    if (const auto label = node.attribute("inkscape:label")) return label.value();
    std::string id = node.attribute("id").value();
    const std::size_t part = id.find("-part-");  // FreeSewing: fs-stack-NAME-part-NAME
    return part == std::string::npos ? id : id.substr(part + 6);
  }

  void add(const pugi::xml_node& node, std::string_view element, const Matrix& matrix, const std::string& name) {
    const auto number = [&](const char* key) { return node.attribute(key).as_double(0); };
    Drawn drawn{node.attribute("class").value(), name, {}};
    if (element == "path") {
      drawn.runs = runs_of_path(node.attribute("d").value(), matrix, options_.tolerance);
    } else if (element == "polygon" || element == "polyline") {
      drawn.runs = runs_of_points(node.attribute("points").value(), element == "polygon", matrix);
    } else if (element == "line") {
      drawn.runs = {Run{{matrix.apply({number("x1"), number("y1")}), matrix.apply({number("x2"), number("y2")})}}};
    } else if (element == "rect") {
      const double x = number("x"), y = number("y"), w = number("width"), h = number("height");
      if (w > 0 && h > 0) {
        drawn.runs = {Run{
            {matrix.apply({x, y}), matrix.apply({x + w, y}), matrix.apply({x + w, y + h}), matrix.apply({x, y + h})},
            {},
            true}};
      }
    } else if (element == "circle" || element == "ellipse") {
      const double rx = element == "circle" ? number("r") : number("rx"), ry = element == "circle" ? rx : number("ry");
      if (rx > 0 && ry > 0)
        drawn.runs = {run_of_ellipse({number("cx"), number("cy")}, rx, ry, matrix, options_.tolerance)};
    }
    if (drawn.runs.empty()) return;
    for (const Run& run : drawn.runs) {
      if (!within_reach(run.points)) return;
    }
    const std::string_view start = node.attribute("marker-start").value();
    const std::string id = in_capitals(node.attribute("id").value());
    drawn.fold = in_capitals(start).find("CUTONFOLD") != std::string::npos;
    drawn.grain = in_capitals(start).find("GRAINLINE") != std::string::npos || drawn.fold ||
                  id.find("GRAINLINE") != std::string::npos || has_word(drawn.classes, "grainline");
    if (drawn.fold) drawn.grain = in_capitals(node.attribute("data-text").value()).find("GRAIN") != std::string::npos;
    drawn_.push_back(std::move(drawn));
  }

  const ReadingOptions& options_;
  std::vector<Drawn> drawn_;
  bool used_{};
};

class PatternMaker {
 public:
  PatternMaker(const std::vector<Drawn>& drawn, const ReadingOptions& options, Style& style)
      : drawn_{drawn}, options_{options}, style_{style} {}

  std::optional<Error> make() {
    find_outlines();
    if (outlines_.empty()) return Error{ErrorCode::kUnknownFormat, "the drawing has no closed outline", ""};
    share_out();
    for (std::size_t k = 0; k < outlines_.size(); ++k) finish(k);
    style_.notes.push_back({"", "a drawing does not say how often a piece is needed: once each"});
    return std::nullopt;
  }

 private:
  // The index of the drawn element is stored as the line of a loop or run.
  void find_outlines() {
    std::vector<Loop> closed;
    for (std::size_t k = 0; k < drawn_.size(); ++k) {
      Loops loops = joined(drawn_[k].runs, kReach);
      for (Loop& loop : loops.closed) {
        loop.line = k;
        closed.push_back(std::move(loop));
      }
      for (Run& run : loops.open) {
        run.line = k;
        open_.push_back(std::move(run));
      }
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

  // Open lines are added to the piece in which they lie.
  void share_out() {
    for (Run& run : open_) {
      const Drawn& drawn = drawn_[run.line];
      const NestedLoop* around = around_of(outlines_, run.points);
      // The bracket of a fold begins and ends on the edge of its piece.
      if (!around && drawn.fold) around = around_of(outlines_, {run.points[run.points.size() / 2]});
      if (!around) continue;
      aama::PatternBlock& block = blocks_[static_cast<std::size_t>(around - outlines_.data())];
      const std::pair<Spot, Spot> ends{run.points.front(), run.points.back()};
      if (drawn.fold && ends.first != ends.second) block.mirror_lines.push_back(ends);
      if (drawn.grain && ends.first != ends.second) block.grains.push_back(ends);
      if (!drawn.fold && !drawn.grain) {
        block.annotations.lines.push_back({kind_of(drawn), false, std::move(run.points)});
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
  Style style;
  const auto drawn = DrawingReader{options}.read(svg, style.notes);
  if (const auto error = PatternMaker{drawn, options, style}.make()) return *error;
  return style;
}

}  // namespace selvage::protocol::trade::svg
