#include "protocol/trade/aama/grading.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "protocol/document/frame.h"

namespace selvage::protocol::trade::aama {
namespace {

constexpr double kSamePoint = 0.02;

Spot sum(Spot a, Spot b) {
  return {a.x + b.x, a.y + b.y};
}

// How the points of one block move.
class Movements {
 public:
  Movements(const PatternBlock& block, const rules::RuleTable& table, std::size_t size, double unit,
            std::vector<Note>* notes) {
    double degrees = 0;
    if (!block.grade_references.empty()) {
      const auto& [from, to] = block.grade_references.front();
      if (from.y != to.y) degrees = std::atan2(to.y - from.y, to.x - from.x) * 180 / std::numbers::pi;
    }
    const document::Frame turned{false, degrees, {}};
    for (const blocks::GradedPoint& point : block.graded_points) {
      const auto rule = table.movements.find(point.rule);
      if (rule == table.movements.end()) {
        if (notes) {
          notes->push_back(
              note_at(point.line, "rule " + std::to_string(point.rule) + " is not in the rule table; left out"));
        }
        continue;
      }
      const Spot by = rule->second[size];
      points_.push_back({point.at, turned.apply({by.x * unit, by.y * unit})});
    }
    std::stable_sort(points_.begin(), points_.end(), [](const Moved& a, const Moved& b) { return a.at.x < b.at.x; });
  }

  // The movement of the graded point at this position.
  [[nodiscard]] std::optional<Spot> at(Spot spot) const {
    auto first = std::lower_bound(points_.begin(), points_.end(), spot.x - kSamePoint,
                                  [](const Moved& moved, double x) { return moved.at.x < x; });
    for (; first != points_.end() && first->at.x <= spot.x + kSamePoint; ++first) {
      if (distance(first->at, spot) <= kSamePoint) return first->by;
    }
    return std::nullopt;
  }

 private:
  struct Moved {
    Spot at, by;
  };
  std::vector<Moved> points_;  // by x
};

// The movement of every point of a line: those that are graded as their rules say, the others between them by arc
// length.  None when no point is graded.
std::optional<std::vector<Spot>> along(const std::vector<Spot>& points, bool closed, const Movements& movements) {
  std::vector<std::optional<Spot>> own;
  std::vector<std::size_t> graded;
  for (std::size_t k = 0; k < points.size(); ++k) {
    own.push_back(movements.at(points[k]));
    if (own.back()) graded.push_back(k);
  }
  if (graded.empty()) return std::nullopt;
  const std::size_t count = points.size();
  std::vector<Spot> by(count, *own[graded.front()]);
  for (std::size_t g = 0; g < graded.size(); ++g) {
    const bool last = g + 1 == graded.size();
    const std::size_t from = graded[g], to = last ? graded.front() + count : graded[g + 1];
    if (last && !closed) {
      for (std::size_t k = from; k < count; ++k) by[k] = *own[from];
      break;
    }
    double whole = 0, done = 0;
    for (std::size_t k = from; k < to; ++k) whole += distance(points[k % count], points[(k + 1) % count]);
    const Spot a = *own[from], b = *own[to % count];
    for (std::size_t k = from; k < to; ++k) {
      const double part = whole > 0 ? done / whole : 0;
      by[k % count] = {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
      done += distance(points[k % count], points[(k + 1) % count]);
    }
  }
  return by;
}

// Moves points that lie on no line as the nearest point of the outline moves, so that a notch between two vertices
// stays on its edge.
class Mover {
 public:
  Mover(const std::vector<Spot>& outline, const std::vector<Spot>& by, const Movements& movements)
      : outline_{outline}, by_{by}, movements_{movements} {}

  void move(Spot& spot) const {
    if (const auto own = movements_.at(spot)) {
      spot = sum(spot, *own);
      return;
    }
    double nearest = std::numeric_limits<double>::infinity();
    Spot by{};
    for (std::size_t k = 0, count = outline_.size(); k < count; ++k) {
      const Spot a = outline_[k], b = outline_[(k + 1) % count], along{b.x - a.x, b.y - a.y};
      const double squared = along.x * along.x + along.y * along.y;
      const double foot = ((spot.x - a.x) * along.x + (spot.y - a.y) * along.y) / squared;
      const double part = squared > 0 ? std::clamp(foot, 0.0, 1.0) : 0;
      const double far = distance(spot, {a.x + part * along.x, a.y + part * along.y});
      if (far >= nearest) continue;
      nearest = far;
      const Spot from = by_[k], to = by_[(k + 1) % count];
      by = {from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)};
    }
    spot = sum(spot, by);
  }

 private:
  const std::vector<Spot>& outline_;
  const std::vector<Spot>& by_;
  const Movements& movements_;
};

}  // namespace

void grade(PatternBlock& block, std::vector<Spot>& outline, const rules::RuleTable& table, std::size_t size,
           double unit, std::vector<Note>* notes) {
  const Movements movements{block, table, size, unit, notes};
  const auto by = along(outline, true, movements);
  if (!by) {
    if (notes) notes->push_back(note_at(block.line, "no point of the boundary is graded: the same in all sizes"));
    return;
  }
  const Mover mover{outline, *by, movements};
  for (document::Notch& notch : block.annotations.notches) mover.move(notch.at);
  for (Spot& drill : block.annotations.drills) mover.move(drill);
  for (document::DrawnText& text : block.annotations.texts) mover.move(text.at);
  for (document::DrawnLine& line : block.annotations.lines) {
    if (const auto moved = along(line.points, line.closed, movements)) {
      for (std::size_t k = 0; k < line.points.size(); ++k) line.points[k] = sum(line.points[k], (*moved)[k]);
    } else {
      for (Spot& point : line.points) mover.move(point);
    }
  }
  for (auto* lines : {&block.mirror_lines, &block.grains}) {
    for (auto& [from, to] : *lines) {
      // The direction of a grain line does not change, only its position.
      const Spot before = from;
      mover.move(from);
      if (lines == &block.grains)
        to = sum(to, {from.x - before.x, from.y - before.y});
      else
        mover.move(to);
    }
  }
  for (std::size_t k = 0; k < outline.size(); ++k) outline[k] = sum(outline[k], (*by)[k]);
}

}  // namespace selvage::protocol::trade::aama
