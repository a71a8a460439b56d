// Lines across the room.  On each of them, the least chords that the bodies have in their present ranges must fit side
// by side.  A body cannot lie where its chord would be longer than what the others leave free, which narrows its range.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/packing/branching/relaxation.h"

namespace selvage::packing::branching {
namespace {

// The least chord for u between `low` and `high`.
double least_between(const lines::Chords& chords, double part, double low, double high) {
  if (low < 0) return 0;
  const auto last = static_cast<std::size_t>(high / part);
  if (last >= chords.least.size()) return 0;
  double least = chords.least[last];
  for (auto k = static_cast<std::size_t>(low / part); k < last && least > 0; ++k) {
    least = std::min(least, chords.least[k]);
  }
  return std::max(least, 0.0);
}

}  // namespace

// Computes the least chords of the bodies on every line, and their sums.  False when no body has to cross any line.
bool Relaxation::sum_chords(const Node& node, const Lines& lines, const DifferenceBounds& bounds) {
  const std::uint32_t world = problem_->world();
  on_lines_.sums.assign(lines.at.size(), 0.0);
  on_lines_.own.assign(lines.at.size() * world, 0.0);
  bool any = false;
  for (std::uint32_t body = 0; body < world; ++body) {
    const lines::Chords& chords = chords_in(node, lines, body);
    const double low = bounds.lower(world, body);
    const double high = bounds.upper(world, body);
    const double end = low + static_cast<double>(chords.least.size()) * lines.part;
    if (high >= end) continue;
    auto line = static_cast<std::size_t>(std::ranges::lower_bound(lines.at, high) - lines.at.begin());
    for (; line < lines.at.size() && lines.at[line] < end; ++line) {
      const double least = least_between(chords, lines.part, lines.at[line] - high, lines.at[line] - low);
      on_lines_.own[line * world + body] = least;
      on_lines_.sums[line] += least;
      any = any || least > 0;
    }
  }
  return any;
}

// Why the bodies other than `besides` cover all but `spare` of what they cover of a line: the longest chords suffice.
Reasons Relaxation::why_covered(const Node& node, const DifferenceBounds& bounds, std::size_t line,
                                std::uint32_t besides, double spare) const {
  const std::uint32_t world = problem_->world();
  std::vector<std::pair<double, std::uint32_t>> order;
  for (std::uint32_t body = 0; body < world; ++body) {
    const double chord = on_lines_.own[line * world + body];
    if (body != besides && chord > 0) order.emplace_back(chord, body);
  }
  std::sort(order.begin(), order.end());
  Reasons why = programs::kUnconditional;
  for (const auto& [chord, body] : order) {
    spare -= chord;
    if (spare > 0) continue;
    why |= node.why_variant[body] | bounds.why_lower(world, body) | bounds.why_upper(world, body);
  }
  return why;
}

// Moves the ends of a body's range away from positions where its chord on the line would be longer than `room`.
bool Relaxation::keep_beside_line(const Node& node, const Lines& lines, DifferenceBounds& bounds, std::size_t line,
                                  std::uint32_t body, double room) {
  const std::uint32_t world = problem_->world();
  const std::vector<double>& least = chords_in(node, lines, body).least;
  const double size = static_cast<double>(least.size()) * lines.part;
  double excess = std::numeric_limits<double>::infinity();
  const auto is_excluded = [&](std::size_t part) {
    if (least[part] <= room) return false;
    excess = std::min(excess, least[part] - room);
    return true;
  };
  constexpr double kUnit = 1;  // more than products with `part` are rounded by
  if (const double u = lines.at[line] - bounds.lower(world, body); u > 0 && u < size) {
    auto end = static_cast<std::size_t>(u / lines.part) + 1;
    while (end > 0 && is_excluded(end - 1)) --end;
    const double bound = std::ceil(lines.at[line] - static_cast<double>(end) * lines.part - kUnit);
    if (bound > bounds.lower(world, body) &&
        !raise(bounds, world, body, bound,
               why_covered(node, bounds, line, body, excess) | node.why_variant[body] | bounds.why_lower(world, body)))
      return false;
  }
  excess = std::numeric_limits<double>::infinity();
  if (const double u = lines.at[line] - bounds.upper(world, body); u > 0 && u < size) {
    auto begin = static_cast<std::size_t>(u / lines.part);
    while (begin < least.size() && is_excluded(begin)) ++begin;
    const double bound = std::floor(lines.at[line] - static_cast<double>(begin) * lines.part + kUnit);
    if (bound < bounds.upper(world, body) &&
        !raise(bounds, body, world, -bound,
               why_covered(node, bounds, line, body, excess) | node.why_variant[body] | bounds.why_upper(world, body)))
      return false;
  }
  return true;
}

bool Relaxation::fit_on(Node& node, const Lines& lines, DifferenceBounds& bounds) {
  if (lines.at.empty() || !sum_chords(node, lines, bounds)) return true;
  const std::uint32_t world = problem_->world();
  const bool ends_at_ceiling = problem_->minimises_length && &bounds == &node.y;
  const double longest = ends_at_ceiling ? ceiling_ - lines.low + lines::kChordSlack : lines.room.front();
  double most = 0;  // of all chords
  for (std::uint32_t body = 0; body < world; ++body) most = std::max(most, chords_in(node, lines, body).most);
  for (std::size_t line = 0; line < lines.at.size(); ++line) {
    if (on_lines_.sums[line] <= 0) continue;
    const double room = ends_at_ceiling ? std::min(lines.room[line], longest) : lines.room[line];
    const double spare = room - on_lines_.sums[line];
    if (spare < 0) {
      conflict_ = why_covered(node, bounds, line, world, -spare);
      return false;
    }
    for (std::uint32_t body = 0; body < world && spare < most; ++body) {
      const double own = on_lines_.own[line * world + body];
      if (chords_in(node, lines, body).most <= spare + own) continue;
      if (!keep_beside_line(node, lines, bounds, line, body, spare + own)) return false;
    }
  }
  return true;
}

bool Relaxation::fit_on_lines(Node& node) {
  return fit_on(node, problem_->lines[0], node.x) && fit_on(node, problem_->lines[1], node.y);
}

}  // namespace selvage::packing::branching
