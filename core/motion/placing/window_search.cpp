#include "core/motion/placing/window_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace selvage::motion::placing {
namespace {

// A part of the window, with the borders that enter it.
struct Cell {
  RealBox box;
  double squared_distance{};         // from the wanted position
  std::vector<std::uint32_t> lines;  // sorted by obstacle
};

// The nearest free position inside one window.  The window is divided, nearest part first, until few borders are left
// in a part; parts entirely inside an obstacle are dropped.  The nearest position is then the point of a border or of
// the part that is nearest to the wanted position, or a crossing of two borders.
class WindowSearch {
 public:
  WindowSearch(const scene::Scene& scene, const Body& body, const Box& window, Vec wanted, Vec origin,
               std::optional<Vec> best, const PlaceTuning& tuning, const std::stop_token& stop)
      : tuning_{tuning},
        stop_{stop},
        around_{scene, body, window, origin, stop},
        window_{window},
        wanted_{wanted},
        origin_{origin},
        from_{static_cast<double>(wanted.x - origin.x), static_cast<double>(wanted.y - origin.y)},
        best_{best},
        least_{best ? distance_between(*best, wanted) : std::numeric_limits<double>::infinity()} {}

  std::optional<Vec> run() {
    if (!around_.complete()) return {};
    push_window();
    while (!heap_.empty()) {
      if (stop_.stop_requested()) return {};
      std::pop_heap(heap_.begin(), heap_.end(), farther);
      const Cell cell = std::move(heap_.back());
      heap_.pop_back();
      if (std::sqrt(cell.squared_distance) >= least_) break;
      const double size = std::max(cell.box.width(), cell.box.height());
      if (cell.lines.size() <= tuning_.few_lines || size <= tuning_.small) {
        search(cell);
      } else {
        divide(cell);
      }
    }
    return best_;
  }

 private:
  static bool farther(const Cell& a, const Cell& b) {
    if (a.squared_distance != b.squared_distance) return a.squared_distance > b.squared_distance;
    return std::pair{a.box.low_x, a.box.low_y} > std::pair{b.box.low_x, b.box.low_y};
  }
  void push(Cell cell) {
    cell.squared_distance = squared_distance(nearest_in(cell.box, from_), from_);
    if (std::sqrt(cell.squared_distance) >= least_) return;
    heap_.push_back(std::move(cell));
    std::push_heap(heap_.begin(), heap_.end(), farther);
  }
  static RealVec middle(const RealBox& box) { return {box.middle_x(), box.middle_y()}; }

  void push_window() {
    Cell cell;
    const RealVec low = real(window_.low - origin_);
    const RealVec high = real(window_.high - origin_);
    cell.box = {low.x, low.y, high.x, high.y};
    for (std::size_t k = 0; k < around_.obstacles(); ++k) {
      if (!append_entering(k, around_.first_line(k), around_.first_line(k + 1), cell)) return;
    }
    push(std::move(cell));
  }
  // Appends those of these lines, all of one obstacle, that enter the cell.  False when the obstacle covers the whole
  // cell.
  bool append_entering(std::size_t obstacle, std::uint32_t first, std::uint32_t last, Cell& cell) {
    const std::size_t before = cell.lines.size();
    for (std::uint32_t k = first; k < last; ++k) {
      if (enters(around_.lines()[k], cell.box)) cell.lines.push_back(k);
    }
    return cell.lines.size() > before || !around_.forbids(obstacle, middle(cell.box));
  }

  void divide(const Cell& cell) {
    const RealVec mid = middle(cell.box);
    const bool across = cell.box.width() >= cell.box.height();
    for (const bool upper : {false, true}) {
      Cell half;
      half.box = cell.box;
      double& side = across ? (upper ? half.box.low_x : half.box.high_x) : (upper ? half.box.low_y : half.box.high_y);
      side = across ? mid.x : mid.y;
      if (fill_from(cell, half)) push(std::move(half));
    }
  }
  bool fill_from(const Cell& whole, Cell& half) {
    const std::vector<BorderLine>& lines = around_.lines();
    for (std::size_t k = 0; k < whole.lines.size();) {
      const std::uint32_t obstacle = lines[whole.lines[k]].obstacle;
      const std::size_t before = half.lines.size();
      for (; k < whole.lines.size() && lines[whole.lines[k]].obstacle == obstacle; ++k) {
        if (enters(lines[whole.lines[k]], half.box)) half.lines.push_back(whole.lines[k]);
      }
      if (half.lines.size() == before && around_.forbids(obstacle, middle(half.box))) return false;
    }
    return true;
  }

  // A point that may be the nearest free one, and the borders that it lies on.
  struct Candidate {
    RealVec at;
    double squared_distance{};
    std::array<const BorderLine*, 2> on{};
  };
  void search(const Cell& cell) {
    candidates_.clear();
    sides_ = sides_of(cell.box);
    const auto consider = [&](RealVec point, const BorderLine* p, const BorderLine* q) {
      if (!holds(cell.box, point, 1)) return;
      const double square = squared_distance(point, from_);
      if (std::sqrt(square) < least_) candidates_.push_back({point, square, {p, q}});
    };
    consider(nearest_in(cell.box, from_), nullptr, nullptr);
    for (std::size_t k = 0; k < cell.lines.size(); ++k) {
      const BorderLine& line = around_.lines()[cell.lines[k]];
      consider(nearest_on(line, from_), &line, nullptr);
      for (std::size_t m = 0; m < k; ++m) {
        const BorderLine& other = around_.lines()[cell.lines[m]];
        crossings_.clear();
        append_crossings(line, other, crossings_);
        for (const RealVec point : crossings_) consider(point, &line, &other);
      }
      consider_sides(line, consider);
    }
    std::stable_sort(candidates_.begin(), candidates_.end(),
                     [](const auto& a, const auto& b) { return a.squared_distance < b.squared_distance; });
    for (const Candidate& candidate : candidates_) {
      if (std::sqrt(candidate.squared_distance) >= least_) break;
      if (!buried(cell, candidate)) take_near(candidate);
    }
  }
  // The crossings of a border with the cell's sides, which may be the strip's.
  template <class Consider>
  void consider_sides(const BorderLine& line, const Consider& consider) {
    for (const BorderLine& side : sides_) {
      if (squared_distance(side.a, side.b) == 0) continue;
      crossings_.clear();
      append_crossings(side, line, crossings_);
      for (const RealVec point : crossings_) consider(point, &line, &side);
    }
  }
  // The sides of a box as borders of what lies outside of it.
  static std::array<BorderLine, 4> sides_of(const RealBox& box) {
    const RealVec low{box.low_x, box.low_y};
    const RealVec high{box.high_x, box.high_y};
    const auto side = [](RealVec a, RealVec b) { return BorderLine{a, b, 0, 0, {}, {}}; };
    return {side({high.x, low.y}, low), side(high, {high.x, low.y}), side({low.x, high.y}, high),
            side(low, {low.x, high.y})};
  }

  // True when the candidate lies deep inside an obstacle that has a border in this cell.
  [[nodiscard]] bool buried(const Cell& cell, const Candidate& candidate) const {
    const std::vector<BorderLine>& lines = around_.lines();
    for (std::size_t k = 0; k < cell.lines.size();) {
      const std::uint32_t obstacle = lines[cell.lines[k]].obstacle;
      double nearest = std::numeric_limits<double>::infinity();
      for (; k < cell.lines.size() && lines[cell.lines[k]].obstacle == obstacle; ++k) {
        const BorderLine& line = lines[cell.lines[k]];
        nearest = std::min(nearest, squared_distance(nearest_on(line, candidate.at), candidate.at));
      }
      if (nearest > tuning_.clear * tuning_.clear && around_.forbids(obstacle, candidate.at)) return true;
    }
    return false;
  }

  // The shortest way from the candidate that leaves each of its borders by one unit; of two borders that run nearly
  // parallel, the way from one.
  [[nodiscard]] RealVec one_unit_out(const Candidate& candidate) const {
    std::array<RealVec, 2> normals{};
    std::array<RealVec, 2> ways{};
    for (std::size_t k = 0; k < 2; ++k) {
      if (candidate.on[k] == nullptr) continue;
      normals[k] = outwards(*candidate.on[k], candidate.at);
      if (window_.width() == 0) normals[k].x = 0;  // fixed on this axis
      if (window_.height() == 0) normals[k].y = 0;
      const double square = squared_distance(normals[k], {});
      if (square > 0) ways[k] = {normals[k].x / square, normals[k].y / square};
    }
    const auto& [p, q] = normals;
    const double turn = p.x * q.y - p.y * q.x;
    if (std::abs(turn) > 1e-6) return {(q.y - p.y) / turn, (p.x - q.x) / turn};
    return squared_distance(ways[0], {}) >= squared_distance(ways[1], {}) ? ways[0] : ways[1];
  }

  // The nearest lattice position about the candidate that is proved, moved outwards a little where rounding needs room.
  void take_near(const Candidate& candidate) {
    const RealVec out = one_unit_out(candidate);
    int proofs = 0;
    for (const double back : {0.0, 1.0, 2.0, 4.0, 8.0, 16.0, 64.0, 256.0}) {
      if (back > 0 && candidate.on[0] == nullptr) return;
      for (const Vec& position : lattice_about({candidate.at.x + back * out.x, candidate.at.y + back * out.y})) {
        if (distance_between(position, wanted_) >= least_ || !admitted(position, candidate)) continue;
        if (++proofs > tuning_.proofs) return;
        if (!around_.free(position)) continue;
        best_ = position;
        least_ = distance_between(position, wanted_);
        return;
      }
    }
  }
  // The four lattice positions about a point, nearest to the wanted one first.
  [[nodiscard]] std::array<Vec, 4> lattice_about(RealVec point) const {
    const Vec base{origin_.x + static_cast<Coord>(std::floor(point.x)),
                   origin_.y + static_cast<Coord>(std::floor(point.y))};
    std::array<Vec, 4> about{base, base + Vec{1, 0}, base + Vec{0, 1}, base + Vec{1, 1}};
    std::stable_sort(about.begin(), about.end(),
                     [&](Vec a, Vec b) { return distance_between(a, wanted_) < distance_between(b, wanted_); });
    return about;
  }
  [[nodiscard]] bool admitted(Vec position, const Candidate& candidate) const {
    return window_.contains({position, position}) &&
           std::all_of(candidate.on.begin(), candidate.on.end(), [&](const auto* line) {
             return line == nullptr || line->direction == Vec{} ||
                    cross(line->direction, position - origin_ - line->anchor) <= 0;
           });
  }

  const PlaceTuning& tuning_;
  const std::stop_token& stop_;
  Surroundings around_;
  Box window_;  // of positions, inside the strip
  Vec wanted_, origin_;
  RealVec from_;  // the wanted position
  std::optional<Vec> best_;
  double least_;  // its distance from the wanted position
  std::vector<Cell> heap_;
  std::vector<Candidate> candidates_;
  std::array<BorderLine, 4> sides_;  // of the cell that is searched
  std::vector<RealVec> crossings_;
};

}  // namespace

std::optional<Vec> nearest_in_window(const scene::Scene& scene, const Body& body, const Box& window, Vec wanted,
                                     Vec origin, std::optional<Vec> best, const PlaceTuning& tuning,
                                     const std::stop_token& stop) {
  return WindowSearch{scene, body, window, wanted, origin, best, tuning, stop}.run();
}

}  // namespace selvage::motion::placing
