#include "protocol/trade/aama/blocks/loose_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "protocol/json/json_text.h"
#include "protocol/trade/aama/blocks/block_roles.h"
#include "protocol/trade/dxf/text_lines.h"

namespace selvage::protocol::trade::aama::blocks {
namespace {

constexpr double kReach = 0.01;    // millimetres, between the ends of lines
constexpr double kWidestGap = 1;   // millimetres, of an outline that is closed nevertheless
constexpr double kBesideLine = 1;  // millimetres: what lies so near to an outline belongs to it

double distance_to_edge(Spot point, Spot a, Spot b) {
  const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
  const double part = squared > 0 ? ((point.x - a.x) * dx + (point.y - a.y) * dy) / squared : 0;
  const double t = std::clamp(part, 0.0, 1.0);
  return distance(point, {a.x + t * dx, a.y + t * dy});
}

double distance_to_outline(Spot point, const std::vector<Spot>& outline) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < outline.size(); ++k) {
    least = std::min(least, distance_to_edge(point, outline[k], outline[(k + 1) % outline.size()]));
  }
  return least;
}

double distance_to_box(Spot point, const NestedLoop& loop) {
  const double dx = std::max({loop.low.x - point.x, 0.0, point.x - loop.high.x});
  const double dy = std::max({loop.low.y - point.y, 0.0, point.y - loop.high.y});
  return std::hypot(dx, dy);
}

// The points by which an entity is assigned to a piece; of a block, where it is inserted.
std::vector<Spot> points_of(const dxf::Entity& entity) {
  std::vector<Spot> points;
  for (const dxf::DxfVertex& vertex : entity.vertices) points.push_back({vertex.x, vertex.y});
  if (points.empty()) {  // a spline of fit points
    const auto x = entity.number(11), y = entity.number(21);
    if (x && y) points.push_back({*x, *y});
  }
  return points;
}

// The keys that say something about one piece, not about the style.
bool is_of_piece(const std::string& key) {
  constexpr std::array<std::string_view, 11> kKeys{"PIECE NAME", "SIZE",     "SIZE NAME", "QUANTITY",
                                                   "ANNOTATION", "CATEGORY", "MATERIAL",  "ROTATION",
                                                   "FLIP",       "TILT",     "FOLD"};
  return std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end();
}

class LooseReader {
 public:
  LooseReader(const dxf::DxfDrawing& drawing, double millimetre, BlockReading& reading)
      : drawing_{drawing}, millimetre_{millimetre}, reading_{reading} {}

  std::vector<PatternBlock> read() {
    find_outlines();
    if (outlines_.empty()) return {};
    belongings_.resize(outlines_.size());
    for (const dxf::Entity& entity : drawing_.entities) {
      if (!draws_boundary(entity)) assign(entity);
    }
    if (outside_ > 0) {
      note(first_outside_, std::to_string(outside_) + " entities outside of all outlines are left out");
    }
    std::vector<PatternBlock> pieces;
    for (std::size_t k = 0; k < outlines_.size(); ++k) pieces.push_back(piece(k));
    return pieces;
  }

 private:
  void note(std::size_t line, const std::string& what) { reading_.notes.push_back(note_at(line, what)); }

  void find_outlines() {
    dxf::Block boundaries;
    for (const dxf::Entity& entity : drawing_.entities) {
      if (draws_boundary(entity)) boundaries.entities.push_back(entity);
    }
    Loops loops = joined(read_pattern_block(boundaries, reading_).boundary, kReach * millimetre_);
    outlines_ = nested(std::move(loops.closed));
    for (const NestedLoop& outline : outlines_) {
      if (outline.repeats > 0) note(outline.loop.line, "an outline is drawn again; read once");
      if (!outline.inner.empty()) {
        note(outline.inner.front().line,
             std::to_string(outline.inner.size()) + " closed lines on layer 1 inside of an outline are left out");
      }
      runs_.push_back({Run{outline.loop.points, outline.loop.edges, true, outline.loop.line}});
      if (outline.loop.runs > 1) {
        note(outline.loop.line, "the outline is joined of " + std::to_string(outline.loop.runs) + " runs");
      }
    }
    add_outlines_with_gaps(std::move(loops.open));
    sort_by_line();
  }

  // Open lines that only gaps of up to a millimetre separate; whether they close is seen when the piece is finished.
  void add_outlines_with_gaps(std::vector<Run> open) {
    std::erase_if(open, [&](const Run& run) {
      const bool inside = around_of(outlines_, run.points) != nullptr;
      if (inside) note(run.line, "an open line on layer 1 inside of an outline is left out");
      return inside;
    });
    Loops loops = joined(open, kWidestGap * millimetre_);
    const auto add = [&](Loop loop, std::vector<Run> runs) {
      NestedLoop outline;
      outline.low = outline.high = loop.points.front();
      for (const Spot& point : loop.points) {
        outline.low = {std::min(outline.low.x, point.x), std::min(outline.low.y, point.y)};
        outline.high = {std::max(outline.high.x, point.x), std::max(outline.high.y, point.y)};
      }
      outline.loop = std::move(loop);
      outlines_.push_back(std::move(outline));
      runs_.push_back(std::move(runs));
    };
    const auto near = [&](Spot spot, const std::vector<Spot>& points) {
      return std::any_of(points.begin(), points.end(),
                         [&](const Spot& point) { return distance(point, spot) <= kWidestGap * millimetre_; });
    };
    for (Loop& loop : loops.closed) {
      std::vector<Run> parts;
      for (const Run& run : open) {
        if (near(run.points.front(), loop.points) && near(run.points.back(), loop.points)) parts.push_back(run);
      }
      add(std::move(loop), std::move(parts));
    }
    for (Run& run : loops.open) {
      if (run.points.size() < 3) {
        note(run.line, "a line on layer 1 that meets no other is left out");
        continue;
      }
      Loop loop{run.points, {}, run.line, 1};
      add(std::move(loop), {std::move(run)});
    }
  }

  void sort_by_line() {
    std::vector<std::size_t> order(outlines_.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return outlines_[a].loop.line < outlines_[b].loop.line; });
    std::vector<NestedLoop> outlines;
    std::vector<std::vector<Run>> runs;
    for (const std::size_t k : order) {
      outlines.push_back(std::move(outlines_[k]));
      runs.push_back(std::move(runs_[k]));
    }
    outlines_ = std::move(outlines);
    runs_ = std::move(runs);
  }

  void assign(const dxf::Entity& entity) {
    const std::vector<Spot> points = points_of(entity);
    if (points.empty()) return;
    if (const NestedLoop* const around = around_of(outlines_, points)) return give(entity, *around);
    if (const NestedLoop* const beside = beside_of(points)) return give(entity, *beside);
    if (entity.type == "TEXT" || entity.type == "MTEXT") {
      assign_text_outside(entity, points.front());
    } else if (outside_++ == 0) {
      first_outside_ = entity.line;
    }
  }

  void give(const dxf::Entity& entity, const NestedLoop& outline) {
    belongings_[static_cast<std::size_t>(&outline - outlines_.data())].push_back(entity);
  }

  // The outline that all of the points lie beside, such as a notch or the ends of a mirror line; null if there is none.
  [[nodiscard]] const NestedLoop* beside_of(const std::vector<Spot>& points) const {
    const double reach = kBesideLine * millimetre_;
    const auto found = std::find_if(outlines_.begin(), outlines_.end(), [&](const NestedLoop& outline) {
      return std::all_of(points.begin(), points.end(), [&](const Spot& point) {
        return distance_to_box(point, outline) <= reach &&
               (distance_to_outline(point, outline.loop.points) <= reach || contains(outline.loop.points, point));
      });
    });
    return found == outlines_.end() ? nullptr : &*found;
  }

  // Other texts outside of all outlines concern the style.
  void assign_text_outside(const dxf::Entity& text, Spot at) {
    const auto lines = dxf::text_lines(text, reading_.encoding);
    const auto of_piece = [](const std::string& line) {
      const auto pair = key_and_value(line);
      return pair && is_of_piece(pair->first);
    };
    const auto said = std::find_if(lines.begin(), lines.end(), of_piece);
    if (said == lines.end()) return;
    const auto nearest = std::min_element(
        outlines_.begin(), outlines_.end(),
        [&](const NestedLoop& a, const NestedLoop& b) { return distance_to_box(at, a) < distance_to_box(at, b); });
    give(text, *nearest);
    note(text.line, json::shortened(Json(*said)) + " lies outside of all outlines; it is taken for the nearest one");
  }

  PatternBlock piece(std::size_t k) {
    dxf::Block drawn;
    drawn.line = static_cast<std::uint32_t>(outlines_[k].loop.line);
    drawn.entities = std::move(belongings_[k]);
    PatternBlock block = read_pattern_block(drawn, reading_);
    block.name = "piece " + std::to_string(k + 1);
    block.boundary = std::move(runs_[k]);
    if (!block.text("PIECE NAME") && !block.annotations.texts.empty()) {
      block.texts["PIECE NAME"] = block.annotations.texts.front().text;
      note(block.line, "no Piece Name: the first text in the outline is taken, " +
                           json::shortened(Json(block.texts["PIECE NAME"])));
    }
    return block;
  }

  const dxf::DxfDrawing& drawing_;
  double millimetre_;
  BlockReading& reading_;
  std::vector<NestedLoop> outlines_;
  std::vector<std::vector<Run>> runs_;                // of each outline
  std::vector<std::vector<dxf::Entity>> belongings_;  // of each outline
  std::size_t outside_{}, first_outside_{};
};

}  // namespace

std::vector<PatternBlock> read_loose_pieces(const dxf::DxfDrawing& drawing, double millimetre, BlockReading& reading) {
  return LooseReader{drawing, millimetre, reading}.read();
}

}  // namespace selvage::protocol::trade::aama::blocks
