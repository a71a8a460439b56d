#include "protocol/trade/svg/svg_drawing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "protocol/json/json_text.h"
#include "protocol/trade/path.h"
#include "protocol/trade/svg/svg_path.h"
#include "protocol/trade/text.h"

namespace selvage::protocol::trade::svg {
namespace {

constexpr double kMillimetresPerPixel = 25.4 / 96;
constexpr int kDeepest = 200;               // nested groups
constexpr std::size_t kMostUsed = 200'000;  // elements and points: a few that use one another can ask for billions

std::optional<double> millimetres_of(std::string_view unit) {
  for (const auto& [word, factor] : {std::pair{"mm", 1.0},
                                     {"cm", 10.0},
                                     {"in", 25.4},
                                     {"pt", 25.4 / 72},
                                     {"pc", 25.4 / 6},
                                     {"px", kMillimetresPerPixel},
                                     {"", kMillimetresPerPixel}}) {
    if (unit == word) return factor;
  }
  return std::nullopt;
}

std::optional<double> millimetres_in(const pugi::xml_attribute& attribute) {
  const auto length = length_in(attribute.value());
  const auto unit = length && length->value > 0 ? millimetres_of(length->unit) : std::nullopt;
  return unit ? std::optional{length->value * *unit} : std::nullopt;
}

// Whether the declarations of a style, without blanks, hide what they apply to.
bool hides(std::string_view declarations) {
  return declarations.find("display:none") != std::string_view::npos ||
         declarations.find("visibility:hidden") != std::string_view::npos;
}

// The classes that the drawing's style sheets hide: .name { display: none }.
std::set<std::string, std::less<>> hidden_classes(std::string_view css) {
  std::set<std::string, std::less<>> hidden;
  while (true) {
    const std::size_t open = css.find('{'), close = css.find('}');
    if (close == std::string_view::npos || open > close) return hidden;
    std::string declarations{css.substr(open + 1, close - open - 1)};
    std::erase(declarations, ' ');
    std::string_view selectors = css.substr(0, open);
    while (hides(declarations) && !selectors.empty()) {  // .a, path.b
      const std::size_t comma = std::min(selectors.find(','), selectors.size());
      const std::string_view selector = trimmed(selectors.substr(0, comma));
      const std::size_t dot = selector.find('.');
      const bool simple =
          dot != std::string_view::npos && selector.find_first_of(" >+~:[.", dot + 1) == std::string_view::npos;
      if (simple) hidden.emplace(selector.substr(dot + 1));
      selectors.remove_prefix(std::min(comma + 1, selectors.size()));
    }
    css.remove_prefix(close + 1);
  }
}

Run run_of_rectangle(Spot low, Spot high, Spot radii, const Matrix& matrix, Flattening& flattening) {
  constexpr double kQuarter = std::numbers::pi / 2;
  const bool round = radii.x > 0 && radii.y > 0;
  if (!round) radii = {};
  const Spot centres[] = {{high.x - radii.x, low.y + radii.y},
                          {high.x - radii.x, high.y - radii.y},
                          {low.x + radii.x, high.y - radii.y},
                          {low.x + radii.x, low.y + radii.y}};
  Path path{matrix.apply({low.x + radii.x, low.y}), flattening, 0};
  for (int corner = 0; corner < 4; ++corner) {
    const double from = (corner - 1) * kQuarter;
    const Spot centre = centres[corner];
    path.line_to(matrix.apply({centre.x + radii.x * std::cos(from), centre.y + radii.y * std::sin(from)}));
    if (round) path.arc(matrix.apply(centre), matrix.turn({radii.x, 0}), matrix.turn({0, radii.y}), from, kQuarter);
  }
  return path.take(true);
}

class DrawingReader {
 public:
  DrawingReader(const ReadingOptions& options, std::size_t bytes, std::vector<Note>& notes)
      : options_{options}, flattening_{options.tolerance, bytes}, notes_{notes} {}

  Result<std::vector<Drawn>> read(const pugi::xml_node& svg) {
    index(svg, 0);
    const double unit = settle_unit(svg);
    visit_children(svg, {unit, 0, 0, -unit, 0, 0}, "", 0);
    if (used_ > kMostUsed) {
      return Error{ErrorCode::kOutOfRange,
                   "<use> draws more than " + std::to_string(kMostUsed) + " elements and points", ""};
    }
    if (const auto error = flattening_.error()) return *error;
    for (const auto& [what, count] : unread_) {
      notes_.push_back({"", what + " is not read" + (count > 1 ? " (" + std::to_string(count) + " times)" : "")});
    }
    return std::move(drawn_);
  }

 private:
  void index(const pugi::xml_node& node, int depth) {
    if (depth > kDeepest) return;
    if (const auto id = node.attribute("id")) by_id_.emplace(id.value(), node);
    if (std::string_view{node.name()} == "style") hidden_.merge(hidden_classes(node.child_value()));
    for (const pugi::xml_node& child : node.children()) index(child, depth + 1);
  }

  // Millimetres of a unit of the drawing.
  double settle_unit(const pugi::xml_node& svg) {
    if (options_.unit) return in_millimetres(*options_.unit);
    const auto width = millimetres_in(svg.attribute("width")), height = millimetres_in(svg.attribute("height"));
    const std::vector<double> box = numbers_in(svg.attribute("viewBox").value());
    const bool boxed = box.size() == 4 && box[2] > 0 && box[3] > 0;
    if (width && boxed) {
      const auto length = length_in(svg.attribute("width").value());
      if (length->unit.empty() || length->unit == "px") {
        notes_.push_back({"", "the drawing says its size in pixels: 1/96 in each"});
      }
      return std::min(*width / box[2], height.value_or(*width / box[2] * box[3]) / box[3]);
    }
    notes_.push_back({"", "the drawing does not say how large it is: a unit is taken for 1/96 in"});
    return kMillimetresPerPixel;
  }

  [[nodiscard]] bool hidden(const pugi::xml_node& node) const {
    static constexpr std::string_view kUnseen[] = {"defs",   "symbol",  "clipPath", "mask",
                                                   "marker", "pattern", "style",    "metadata"};
    const std::string_view name = node.name(), classes = node.attribute("class").value();
    std::string style = node.attribute("style").value();
    std::erase(style, ' ');
    return std::find(std::begin(kUnseen), std::end(kUnseen), name) != std::end(kUnseen) ||
           std::string_view{node.attribute("display").value()} == "none" ||
           std::string_view{node.attribute("visibility").value()} == "hidden" || hides(style) ||
           has_word(classes, "hidden") ||
           std::any_of(hidden_.begin(), hidden_.end(), [&](const auto& one) { return has_word(classes, one); });
  }

  void visit(const pugi::xml_node& node, const Matrix& outer, const std::string& name, int depth) {
    if (depth > kDeepest || used_ > kMostUsed || hidden(node)) return;
    if (in_use_ > 0) ++used_;
    const std::string_view element = node.name();
    Matrix matrix = outer.after(own_transform(node));
    const std::string own = name_of(node);
    const std::string& inherited = (element == "g" || element == "use") && !own.empty() ? own : name;
    if (element == "use") return visit_used(node, matrix, inherited, depth);
    if (element == "svg") matrix = matrix.after(view_of(node, node));
    if (element == "text" || element == "image" || element == "foreignObject") {
      ++unread_["<" + std::string{element} + ">"];
    } else {
      add(node, element, matrix, inherited);
    }
    visit_children(node, matrix, inherited, depth);
  }

  void visit_children(const pugi::xml_node& node, const Matrix& matrix, const std::string& name, int depth) {
    for (const pugi::xml_node& child : node.children()) visit(child, matrix, name, depth + 1);
  }

  void visit_used(const pugi::xml_node& use, const Matrix& matrix, const std::string& name, int depth) {
    std::string_view target = use.attribute("href").value();
    if (target.empty()) target = use.attribute("xlink:href").value();
    const auto found = target.starts_with('#') ? by_id_.find(target.substr(1)) : by_id_.end();
    if (found == by_id_.end()) {
      ++unread_["<use> of " + json::shortened(Json(std::string{printable(target)}))];
      return;
    }
    const pugi::xml_node& used = found->second;
    const Matrix placed = matrix.after({1, 0, 0, 1, length(use, "x"), length(use, "y")});
    ++in_use_;
    if (std::string_view{used.name()} != "symbol")
      visit(used, placed, name, depth + 1);
    else
      visit_children(used, placed.after(view_of(used, use)), name, depth + 1);
    --in_use_;
  }

  // How the viewBox of a symbol or of an inner <svg> fits into the width and height that are given for it.
  Matrix view_of(const pugi::xml_node& view, const pugi::xml_node& place) {
    const Matrix moved = &view == &place ? Matrix{1, 0, 0, 1, length(view, "x"), length(view, "y")} : Matrix{};
    const std::vector<double> box = numbers_in(view.attribute("viewBox").value());
    const double width = length(place, "width"), height = length(place, "height");
    if (box.size() != 4 || !(box[2] > 0) || !(box[3] > 0) || !(width > 0) || !(height > 0)) return moved;
    const double scale = std::min(width / box[2], height / box[3]);
    const Matrix fitted{scale,
                        0,
                        0,
                        scale,
                        (width - scale * box[2]) / 2 - scale * box[0],
                        (height - scale * box[3]) / 2 - scale * box[1]};
    return moved.after(fitted);
  }

  Matrix own_transform(const pugi::xml_node& node) {
    const char* const text = node.attribute("transform").value();
    const auto matrix = transform_in(text);
    if (!matrix) ++unread_["the transform " + json::shortened(Json(printable(text)))];
    return matrix.value_or(Matrix{});
  }

  static std::string name_of(const pugi::xml_node& node) {
    if (const auto label = node.attribute("inkscape:label")) return printable(label.value());
    const std::string id = printable(node.attribute("id").value());
    const std::size_t part = id.find("-part-");  // FreeSewing: fs-stack-NAME-part-NAME
    return part == std::string::npos ? id : id.substr(part + 6);
  }

  // In units of the drawing: a millimetre is 96/25.4 of them wherever the view has not been scaled.
  double length(const pugi::xml_node& node, const char* key) {
    const auto read = length_in(node.attribute(key).value());
    if (!read) return 0;
    if (read->unit.empty()) return read->value;
    const auto unit = millimetres_of(read->unit);
    if (!unit) ++unread_[std::string{"the length "} + json::shortened(Json(printable(node.attribute(key).value())))];
    return unit ? read->value * *unit / kMillimetresPerPixel : 0;
  }

  std::vector<Run> runs_of(const pugi::xml_node& node, std::string_view element, const Matrix& matrix) {
    const auto at = [&](const char* key) { return length(node, key); };
    if (element == "path") return runs_of_path(node.attribute("d").value(), matrix, flattening_);
    if (element == "polygon" || element == "polyline") {
      return runs_of_points(node.attribute("points").value(), element == "polygon", matrix);
    }
    if (element == "line") {
      return {Run{{matrix.apply({at("x1"), at("y1")}), matrix.apply({at("x2"), at("y2")})}}};
    }
    if (element == "rect") {
      const double x = at("x"), y = at("y"), w = at("width"), h = at("height");
      if (!(w > 0) || !(h > 0)) return {};
      Spot radii{at(node.attribute("rx") ? "rx" : "ry"), at(node.attribute("ry") ? "ry" : "rx")};
      radii = {std::min(radii.x, w / 2), std::min(radii.y, h / 2)};
      return {run_of_rectangle({x, y}, {x + w, y + h}, radii, matrix, flattening_)};
    }
    if (element == "circle" || element == "ellipse") {
      const double rx = at(element == "circle" ? "r" : "rx"), ry = at(element == "circle" ? "r" : "ry");
      if (rx > 0 && ry > 0) return {run_of_ellipse({at("cx"), at("cy")}, rx, ry, matrix, flattening_)};
    }
    return {};
  }

  void add(const pugi::xml_node& node, std::string_view element, const Matrix& matrix, const std::string& name) {
    Drawn drawn{node.attribute("class").value(), name, runs_of(node, element, matrix)};
    if (drawn.runs.empty()) return;
    for (const Run& run : drawn.runs) {
      if (in_use_ > 0) used_ += run.points.size();
      if (within_reach(run.points)) continue;
      ++unread_["a <" + std::string{element} + "> that reaches farther than 1e8 mm"];
      return;
    }
    drawn.used = in_use_ > 0;
    const std::string start = in_capitals(node.attribute("marker-start").value());
    const std::string id = in_capitals(node.attribute("id").value());
    drawn.fold = start.find("CUTONFOLD") != std::string::npos;
    drawn.grain = start.find("GRAINLINE") != std::string::npos || drawn.fold ||
                  id.find("GRAINLINE") != std::string::npos || has_word(drawn.classes, "grainline");
    if (drawn.fold) drawn.grain = in_capitals(node.attribute("data-text").value()).find("GRAIN") != std::string::npos;
    drawn_.push_back(std::move(drawn));
  }

  const ReadingOptions& options_;
  Flattening flattening_;
  std::vector<Note>& notes_;
  std::map<std::string, pugi::xml_node, std::less<>> by_id_;
  std::set<std::string, std::less<>> hidden_;  // classes
  std::map<std::string, int> unread_;          // what is not read, and how often
  int in_use_{};                               // how many <use> there are around the element
  std::size_t used_{};                         // elements and points inside of <use> so far
  std::vector<Drawn> drawn_;
};

}  // namespace

bool has_word(std::string_view text, std::string_view word) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    if (text.substr(0, end) == word) return true;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return false;
}

Result<std::vector<Drawn>> drawn_lines(const pugi::xml_node& svg, std::size_t bytes, const ReadingOptions& options,
                                       std::vector<Note>& notes) {
  return DrawingReader{options, bytes, notes}.read(svg);
}

}  // namespace selvage::protocol::trade::svg
