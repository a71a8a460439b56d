#include "core/motion/placing/place.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/motion/placing/repeats.h"
#include "core/motion/placing/surroundings.h"

namespace selvage::motion::placing {
namespace {

double distance_between(Vec a, Vec b) {
  return std::hypot(static_cast<double>(a.x - b.x), static_cast<double>(a.y - b.y));
}
bool within(const Box& box, Vec p) {
  return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y;
}

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
               std::optional<Vec> best, const PlaceTuning& tuning)
      : tuning_{tuning},
        around_{scene, body, window, origin},
        window_{window},
        wanted_{wanted},
        origin_{origin},
        from_{static_cast<double>(wanted.x - origin.x), static_cast<double>(wanted.y - origin.y)},
        best_{best},
        least_{best ? distance_between(*best, wanted) : std::numeric_limits<double>::infinity()} {}

  std::optional<Vec> run() {
    push_window();
    while (!heap_.empty()) {
      std::pop_heap(heap_.begin(), heap_.end(), farther);
      const Cell cell = std::move(heap_.back());
      heap_.pop_back();
      if (std::sqrt(cell.squared_distance) >= least_) break;
      const double size = std::max(cell.box.high.x - cell.box.low.x, cell.box.high.y - cell.box.low.y);
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
    return std::pair{a.box.low.x, a.box.low.y} > std::pair{b.box.low.x, b.box.low.y};
  }
  void push(Cell cell) {
    cell.squared_distance = squared_distance(cell.box.nearest_to(from_), from_);
    if (std::sqrt(cell.squared_distance) >= least_) return;
    heap_.push_back(std::move(cell));
    std::push_heap(heap_.begin(), heap_.end(), farther);
  }
  static RealVec middle(const RealBox& box) { return {(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2}; }

  void push_window() {
    Cell cell;
    cell.box = {{static_cast<double>(window_.low.x - origin_.x), static_cast<double>(window_.low.y - origin_.y)},
                {static_cast<double>(window_.high.x - origin_.x), static_cast<double>(window_.high.y - origin_.y)}};
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
    const bool across = cell.box.high.x - cell.box.low.x >= cell.box.high.y - cell.box.low.y;
    for (const bool upper : {false, true}) {
      Cell half;
      half.box = cell.box;
      double& side = across ? (upper ? half.box.low.x : half.box.high.x) : (upper ? half.box.low.y : half.box.high.y);
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
    const auto consider = [&](RealVec point, const BorderLine* p, const BorderLine* q) {
      if (!cell.box.holds(point, 1)) return;
      const double square = squared_distance(point, from_);
      if (std::sqrt(square) < least_) candidates_.push_back({point, square, {p, q}});
    };
    consider(cell.box.nearest_to(from_), nullptr, nullptr);
    for (std::size_t k = 0; k < cell.lines.size(); ++k) {
      const BorderLine& line = around_.lines()[cell.lines[k]];
      consider(nearest_on(line, from_), &line, nullptr);
      for (std::size_t m = 0; m < k; ++m) {
        const BorderLine& other = around_.lines()[cell.lines[m]];
        crossings_.clear();
        append_crossings(line, other, crossings_);
        for (const RealVec point : crossings_) consider(point, &line, &other);
      }
      consider_sides(cell, line, consider);
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
  void consider_sides(const Cell& cell, const BorderLine& line, const Consider& consider) {
    const auto& [low, high] = cell.box;
    const std::array<std::pair<RealVec, RealVec>, 4> sides{
        {{low, {high.x, low.y}}, {{high.x, low.y}, high}, {high, {low.x, high.y}}, {{low.x, high.y}, low}}};
    crossings_.clear();
    for (const auto& [a, b] : sides) {
      if (squared_distance(a, b) > 0) append_crossings({a, b, 0, 0, {}, {}}, line, crossings_);
    }
    for (const RealVec point : crossings_) consider(point, &line, nullptr);
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

  // The nearest lattice position about the candidate that is proved, moved outwards a little where rounding needs room.
  void take_near(const Candidate& candidate) {
    RealVec out;
    for (const BorderLine* line : candidate.on) {
      if (line == nullptr) continue;
      const RealVec normal = outwards(*line, candidate.at);
      out = {out.x + normal.x, out.y + normal.y};
    }
    if (window_.width() == 0) out.x = 0;  // fixed on this axis
    if (window_.height() == 0) out.y = 0;
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
    return within(window_, position) && std::all_of(candidate.on.begin(), candidate.on.end(), [&](const auto* line) {
             return line == nullptr || line->direction == Vec{} ||
                    cross(line->direction, position - origin_ - line->anchor) <= 0;
           });
  }

  const PlaceTuning& tuning_;
  Surroundings around_;
  Box window_;  // of positions, inside the strip
  Vec wanted_, origin_;
  RealVec from_;  // the wanted position
  std::optional<Vec> best_;
  double least_;  // its distance from the wanted position
  std::vector<Cell> heap_;
  std::vector<Candidate> candidates_;
  std::vector<RealVec> crossings_;
};

// The nearest free position in `fit`; `present`: a position known to be free, if any.
std::optional<Vec> nearest_free(const scene::Scene& scene, const Body& body, Vec wanted, const Box& fit,
                                std::optional<Vec> present, const PlaceTuning& tuning) {
  if (fit.high.x < fit.low.x || fit.high.y < fit.low.y) return std::nullopt;
  const Vec origin{std::clamp(wanted.x, fit.low.x, fit.high.x), std::clamp(wanted.y, fit.low.y, fit.high.y)};
  std::optional<Vec> best = present;
  for (double reach = tuning.first_reach * static_cast<double>(scene.marker.strip.width);; reach *= tuning.farther) {
    const double enough = best ? std::min(reach, distance_between(*best, wanted) + 1) : reach;
    const Box about =
        Box{origin, origin}.grown(std::llround(std::min(enough, 4.0 * static_cast<double>(kLatticeLimit))));
    const Box window{{std::max(about.low.x, fit.low.x), std::max(about.low.y, fit.low.y)},
                     {std::min(about.high.x, fit.high.x), std::min(about.high.y, fit.high.y)}};
    best = WindowSearch{scene, body, window, wanted, origin, best, tuning}.run();
    // Outside the window everything is farther from the origin than it reaches, and no nearer to the wanted position.
    const bool final = best && distance_between(*best, wanted) <= std::hypot(enough, distance_between(origin, wanted));
    if (final || window == fit) return best;
  }
}

// Where a marker of this length ends when the body lies behind all other pieces.
Coord end_with_room(const scene::Scene& scene, const Body& body, Coord length) {
  Coord reach = 0;  // of the body, from the position of the piece it is named after
  for (const auto& [member, offset] : body.members) {
    const Box box = scene.pieces[member].box.moved(offset);
    reach = std::max({reach, std::abs(box.low.x), std::abs(box.high.x)});
  }
  return length + 2 * reach + scene.pieces.widest_spacing();
}

}  // namespace

namespace {

// The nearest free position without changing to another repeat of the cloth, where the piece is matched to it, in a
// marker of this length.
std::optional<Place> place_in_repeat(const scene::Scene& scene, PieceId piece, Vec wanted, Coord length,
                                     const PlaceSettings& settings) {
  const Body body{scene, piece};
  if (scene.fixed(piece.value)) return Place{body.at, distance_between(body.at, wanted), false};
  const Strip& strip = scene.marker.strip;
  const Box fit = body.fit(scene, strip.last().value_or(length));
  const auto free = [&](Vec at) { return within(fit, at) && Surroundings{scene, body, {at, at}, at}.free(at); };
  if (free(wanted)) return Place{wanted, 0, false};
  const auto found =
      nearest_free(scene, body, wanted, fit, free(body.at) ? std::optional{body.at} : std::nullopt, settings.tuning);
  if (found) return Place{*found, distance_between(*found, wanted), false};
  if (!settings.may_grow || strip.longest) return std::nullopt;
  const Box longer = body.fit(scene, std::min(end_with_room(scene, body, length), kLatticeLimit - 1));
  const auto beyond = nearest_free(scene, body, wanted, longer, std::nullopt, settings.tuning);
  if (!beyond) return std::nullopt;
  return Place{*beyond, distance_between(*beyond, wanted), true};
}

// The nearest of the free positions in the repeats that these jumps lead to; the jumps are ordered as jumps_towards
// does.
std::optional<Place> nearest_of(const scene::Scene& scene, PieceId piece, Vec wanted, Coord length,
                                const std::vector<Vec>& jumps, const PlaceSettings& settings) {
  const Vec repeat = scene.pieces.repeat_of(piece.value, scene.marker.strip);
  const Vec from = scene.pieces.at(piece.value);
  std::optional<Place> best;
  for (const Vec by : jumps) {
    if (best && best->distance <= least_distance(from + by, wanted, repeat)) break;
    scene::Scene there = scene;
    there.shift(piece, by);
    const auto found = place_in_repeat(there, piece, wanted, length, settings);
    if (found && (!best || found->distance < best->distance)) best = found;
  }
  return best;
}

}  // namespace

std::optional<Place> place(const scene::Scene& scene, PieceId piece, Vec wanted, const PlaceSettings& settings) {
  Vec repeat = scene.pieces.repeat_of(piece.value, scene.marker.strip);
  if (scene.ties.x[piece.value] == model::Ties::kFixed) repeat.x = 0;
  if (scene.ties.y[piece.value] == model::Ties::kFixed) repeat.y = 0;
  const Coord length = scene.pieces.length();
  if (repeat == Vec{}) return place_in_repeat(scene, piece, wanted, length, settings);
  const std::vector<Vec> jumps = jumps_towards(scene.pieces.at(piece.value), wanted, repeat, settings.tuning.repeats);
  std::optional<Place> best =
      nearest_of(scene, piece, wanted, length, jumps, {.may_grow = false, .tuning = settings.tuning});
  if (!best && settings.may_grow) best = nearest_of(scene, piece, wanted, length, jumps, settings);
  return best;
}

namespace {

// Repairs the overlaps of all pieces but one; where that one lies does not matter.
Result<repair::Repair> repair_others(scene::Scene& scene, std::uint32_t piece, const scene::Run& run) {
  Marker others = scene.result();
  others.pieces.erase(others.pieces.begin() + piece);
  if (others.pieces.empty()) return repair::Repair{};
  scene::Scene rest{std::move(others), run.sums};
  auto repair = repair::repair_overlaps(rest, run);
  std::vector<Vec> positions = rest.pieces.positions();
  positions.insert(positions.begin() + piece, scene.pieces.at(piece));
  scene.pieces.place(std::move(positions));
  return repair;
}

}  // namespace

Result<PlacedMarker> repair_and_place(const Marker& start, PieceId piece, Vec wanted, const PlaceSettings& settings,
                                      const scene::Run& run) {
  run.observer.on_stage(scene::Stage::kOther);
  scene::Scene scene{start, run};
  const auto repairing = [&] {
    const bool alone = scene.ties.free(piece.value);
    return alone ? repair_others(scene, piece.value, run) : repair::repair_overlaps(scene, run);
  };
  return repair::repaired_and<PlacedMarker>(scene, repairing, [&](PlacedMarker& placed) {
    run.observer.on_stage(scene::Stage::kSolve);
    placed.place = place(scene, piece, wanted, settings);
    run.observer.on_stage(scene::Stage::kOther);
    const bool could_grow = settings.may_grow && !start.strip.longest;
    if (!placed.place && could_grow &&
        end_with_room(scene, Body{scene, piece}, scene.pieces.length()) >= kLatticeLimit) {
      placed.reason = scene::StopReason::kLatticeEnd;
    }
    if (placed.place) scene.shift(piece, placed.place->at - scene.pieces.at(piece.value));
  });
}

}  // namespace selvage::motion::placing
