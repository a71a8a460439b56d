#include "core/motion/piece/bump.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "core/marker/clearance.h"
#include "core/minkowski/inner_fit.h"
#include "core/model/pair_rows.h"
#include "core/motion/piece/slide.h"

namespace selvage::motion::piece {
namespace {

constexpr double kRounding = 1e-6;   // lattice units: rounding of a slack
constexpr double kFarther = 4;       // by which the reach grows
constexpr double kNarrowest = 1e-6;  // least value of 1 + the cosine between the normals of a corner's sides

// Lattice units by which a point at a corner backs away from its sides until a lattice point fits: there is always one
// within 0.71, so more is needed only where a third side is near.
constexpr std::array kBacks{0.0, 0.25, 0.5, 0.71, 1.0, 2.0, 4.0, 16.0, 64.0};

// Directions at an angle to the wanted one, as (cosine, sine) of 25, 50, 75 and 89 degrees, to one side and to the
// other.
constexpr std::array<std::pair<double, double>, 8> kSlants{{{0.906, 0.423},
                                                            {0.906, -0.423},
                                                            {0.643, 0.766},
                                                            {0.643, -0.766},
                                                            {0.259, 0.966},
                                                            {0.259, -0.966},
                                                            {0.017, 1.0},
                                                            {0.017, -1.0}}};

// One side of the cell, and the piece that it belongs to.
struct Bound {
  model::HalfPlane side;  // of the relative position; unused for the strip's edges
  std::uint32_t piece{};  // kEdge for the strip's edges and the cell's reach
  Vec offset;             // from the bumped piece to the one of its body that is bounded
  bool touching{};        // the two may touch, and not overlap: the half-plane is exact
};
constexpr std::uint32_t kEdge = UINT32_MAX;

// A piece that moves: the bumped one, or another of its group.
struct Member {
  std::uint32_t piece{};
  Vec offset;  // from the bumped one; constant
};

// The obstacle that a piece that stays is to a piece of the body.
struct Met {
  Member member;
  std::uint32_t other{};
  Coord spacing{};
  minkowski::Obstacle obstacle;
};

class Bumper {
 public:
  Bumper(const scene::Scene& scene, std::uint32_t piece, double ux, double uy, const std::stop_token& stop,
         const BumpTuning& tuning)
      : scene_{scene},
        stop_{stop},
        tuning_{tuning},
        piece_{piece},
        ux_{ux},
        uy_{uy},
        at_{scene.pieces.at(piece)},
        first_reach_{tuning.first_reach * static_cast<double>(scene.marker.strip.width)},
        reach_{first_reach_} {
    moves_.resize(scene.pieces.size());
    for (std::uint32_t i = 0; i < scene.pieces.size(); ++i) moves_[i] = scene.ties.joined(i, piece);
    const Coord end = scene.marker.strip.last().value_or(scene.pieces.length());
    for (std::uint32_t i = 0; i < scene.pieces.size(); ++i) {
      if (!moves_[i]) continue;
      body_.push_back({i, scene.pieces.at(i) - at_});
      const Box room = scene.pieces.room_among(i, moves_, scene.marker.strip, end);
      const Box fit = minkowski::inner_fit(scene.pieces[i].box, room).moved(-body_.back().offset);
      fit_.low = {std::max(fit_.low.x, fit.low.x), std::max(fit_.low.y, fit.low.y)};
      fit_.high = {std::min(fit_.high.x, fit.high.x), std::min(fit_.high.y, fit.high.y)};
    }
    if (scene.ties.x[piece] == model::Ties::kFixed) fit_.low.x = fit_.high.x = at_.x;
    if (scene.ties.y[piece] == model::Ties::kFixed) fit_.low.y = fit_.high.y = at_.y;
  }

  Bump run() {
    int step = 0;
    while (step < tuning_.steps && (advance(ux_, uy_) || advance_round_corners())) ++step;
    return {reason_after(step), at_, gain(at_ - scene_.pieces.at(piece_)), touching()};
  }

 private:
  [[nodiscard]] scene::StopReason reason_after(int steps) const {
    if (stop_.stop_requested()) return scene::StopReason::kCancelled;
    return steps < tuning_.steps ? scene::StopReason::kConverged : scene::StopReason::kWorkLimit;
  }

  [[nodiscard]] double gain(Vec by) const { return ux_ * static_cast<double>(by.x) + uy_ * static_cast<double>(by.y); }

  // At a corner the piece may pass a neighbour on either side; the cell chose the sides that obstruct the direct way
  // least.  A way around the corner, if there is one, starts along some contact: try the cells that keep those ways
  // open, and some ways at an angle, which reveal the contacts behind corners.
  bool advance_round_corners() {
    std::vector<std::pair<double, double>> ways;
    const double side = first_side();
    for (const auto& [c, s] : kSlants) ways.emplace_back(c * ux_ - side * s * uy_, side * s * ux_ + c * uy_);
    for (std::size_t k = 0; k < ways.size() && k < tuning_.ways; ++k) {
      if (advance(ways[k].first, ways[k].second)) return true;
      for (const CellSide& met : cell_) {
        if (met.slack > tuning_.contact) continue;
        const double ahead = -met.ny * ux_ + met.nx * uy_;
        const std::pair along{ahead > 0 ? -met.ny : met.ny, ahead > 0 ? met.nx : -met.nx};
        const bool known = std::any_of(ways.begin(), ways.end(), [&](const auto& way) {
          return std::abs(way.first * along.second - way.second * along.first) < 1e-9;
        });
        if (!known && ahead != 0) ways.push_back(along);
      }
    }
    return false;
  }

  // The side that is tried first, +1 for the left of the wanted direction: leftwards in the strip, and for a bump along
  // the strip the side with more room, so that a mirrored marker gives the mirrored answer.
  [[nodiscard]] double first_side() const {
    if (uy_ != 0) return uy_ > 0 ? 1 : -1;
    return (fit_.high.y - at_.y >= at_.y - fit_.low.y) == (ux_ > 0) ? 1 : -1;
  }

  // Builds the cell about the present position, slides in it and takes the part that is proved.  False if nothing is
  // gained, or when cancelled.
  bool advance(double towards_x, double towards_y) {
    if (!build_cell(towards_x, towards_y)) return false;
    last_ = slide(cell_, ux_, uy_);
    if (ux_ * last_.to.x + uy_ * last_.to.y < tuning_.least_gain) return false;
    for (double part = 1; part > 1e-3; part /= 4) {
      const auto target = lattice_point(last_.to.x * part, last_.to.y * part);
      if (!target || gain(*target - at_) < tuning_.least_gain ||
          !are_clear(scene_.pieces, moves_, *target - scene_.pieces.at(piece_))) {
        continue;
      }
      const bool reached_limit = std::any_of(last_.blocking.begin(), last_.blocking.end(),
                                             [&](std::size_t k) { return k >= cell_.size() - 4; });
      if (reached_limit) {
        reach_ *= kFarther;  // only the reach was in the way: look farther next time
      } else if (neighbours_.size() > tuning_.many_neighbours) {
        reach_ = first_reach_;
      }
      at_ = *target;
      return true;
    }
    return false;
  }

  // False when cancelled; then there is no cell.
  bool build_cell(double towards_x, double towards_y) {
    cell_.clear();
    bounds_.clear();
    last_.blocking.clear();
    find_neighbours();
    for (const std::size_t k : neighbours_) {
      if (stop_.stop_requested()) break;
      add_sides(met_[k], towards_x, towards_y);
    }
    if (stop_.stop_requested()) return false;
    const auto room = [](Coord from, Coord to) { return static_cast<double>(std::max(Coord{0}, to - from)); };
    add_edge(1, 0, room(fit_.low.x, at_.x));
    add_edge(-1, 0, room(at_.x, fit_.high.x));
    add_edge(0, 1, room(fit_.low.y, at_.y));
    add_edge(0, -1, room(at_.y, fit_.high.y));
    for (const auto& [nx, ny] : {std::pair{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}}) add_edge(nx, ny, reach_);
    return true;
  }
  // The pieces within reach; found again when the position or the reach has changed since.  Some of them when
  // cancelled.
  void find_neighbours() {
    if (looked_from_ == std::pair{at_, reach_}) return;
    looked_from_ = {at_, reach_};
    neighbours_.clear();
    for (const Member& member : body_) {
      if (stop_.stop_requested()) return;
      const Box own = scene_.pieces[member.piece].box.moved(at_ + member.offset).grown(std::llround(reach_) + spacing_);
      for (std::uint32_t other = 0; other < scene_.pieces.size(); ++other) {
        if (moves_[other] || scene_.pieces.may_share_cloth(member.piece, other)) continue;
        if (own.overlaps(scene_.pieces.box(other))) {
          const auto found = met(member, other);
          if (!found) return;
          neighbours_.push_back(*found);
        }
      }
    }
  }
  // Its place in met_; nothing when cancelled.  Kept because every position needs it, and the cache of sums would be
  // locked each time.
  std::optional<std::size_t> met(const Member& member, std::uint32_t other) {
    const std::uint64_t key = std::uint64_t{member.piece} << 32 | other;
    if (const auto known = met_at_.find(key); known != met_at_.end()) return known->second;
    auto obstacle = scene_.obstacle({other, member.piece}, stop_);
    if (!obstacle) return {};
    met_.push_back({member, other, scene_.pieces.spacing({member.piece, other}), *std::move(obstacle)});
    return met_at_.emplace(key, met_.size() - 1).first->second;
  }
  void add_sides(const Met& met, double towards_x, double towards_y) {
    const Vec r = at_ + met.member.offset - scene_.pieces.at(met.other);
    const auto region = model::region_within(1.5 * reach_, met.spacing, {towards_x, towards_y});
    for (const model::FreeSide& side : model::free_sides({met.obstacle, r, r, met.spacing}, region)) {
      cell_.push_back({side.normal.x, side.normal.y, std::max(0.0, side.slack)});
      bounds_.push_back({side.line, met.other, met.member.offset, met.spacing == 0});
    }
  }
  void add_edge(double nx, double ny, double slack) {
    cell_.push_back({nx, ny, slack});
    bounds_.push_back({{}, kEdge, {}, false});
  }

  // The best lattice position near the cell's point that satisfies every half-plane.
  [[nodiscard]] std::optional<Vec> lattice_point(double x, double y) const {
    const auto about = [](double v) {
      return std::pair{static_cast<Coord>(std::floor(v)), static_cast<Coord>(std::ceil(v))};
    };
    const RealVec into = into_cell();
    for (const double back : kBacks) {
      const auto [low_x, high_x] = about(x + back * into.x);
      const auto [low_y, high_y] = about(y + back * into.y);
      std::optional<Vec> best;
      for (const Vec by : {Vec{low_x, low_y}, {high_x, low_y}, {low_x, high_y}, {high_x, high_y}}) {
        if (admitted(at_ + by) && (!best || preferred(by, *best))) best = by;
      }
      if (best) return at_ + *best;
    }
    return std::nullopt;
  }
  // The direction away from a point on the blocking sides in which each of them gains one unit of room per unit.
  [[nodiscard]] RealVec into_cell() const {
    if (last_.blocking.empty()) return {-ux_, -uy_};
    const CellSide& first = cell_[last_.blocking.front()];
    const CellSide& last = cell_[last_.blocking.back()];
    const double room = std::max(kNarrowest, 1 + first.nx * last.nx + first.ny * last.ny);
    return {(first.nx + last.nx) / room, (first.ny + last.ny) / room};
  }
  // Farther in the direction; of equally far moves the shorter one.
  [[nodiscard]] bool preferred(Vec a, Vec b) const {
    const auto rank = [&](Vec by) { return std::tuple{-gain(by), std::abs(by.x) + std::abs(by.y), std::abs(by.y)}; };
    return rank(a) < rank(b);
  }
  [[nodiscard]] bool admitted(Vec candidate) const {
    if (candidate.x < fit_.low.x || candidate.x > fit_.high.x || candidate.y < fit_.low.y ||
        candidate.y > fit_.high.y) {
      return false;
    }
    for (std::size_t k = 0; k < bounds_.size(); ++k) {
      const Bound& bound = bounds_[k];
      if (bound.piece == kEdge) continue;
      const Vec by = candidate - at_;
      const double room =
          cell_[k].slack + cell_[k].nx * static_cast<double>(by.x) + cell_[k].ny * static_cast<double>(by.y);
      if (!bound.touching) {  // approximate: the proof decides
        if (room < -kRounding) return false;
      } else if (cross(bound.side.direction,
                       candidate + bound.offset - scene_.pieces.at(bound.piece) - bound.side.anchor) > 0) {
        return false;
      }
    }
    return true;
  }
  [[nodiscard]] std::vector<PieceId> touching() const {
    std::vector<PieceId> pieces;
    for (const std::size_t k : last_.blocking) {
      if (bounds_[k].piece != kEdge) pieces.push_back(PieceId{bounds_[k].piece});
    }
    std::sort(pieces.begin(), pieces.end());
    pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
    return pieces;
  }

  const scene::Scene& scene_;
  const std::stop_token& stop_;
  const BumpTuning& tuning_;
  std::uint32_t piece_;
  double ux_, uy_;
  Coord spacing_{scene_.pieces.widest_spacing()};
  std::vector<Member> body_;
  std::vector<bool> moves_;                                                    // whether a piece is of the body
  Box fit_{{-kLatticeLimit, -kLatticeLimit}, {kLatticeLimit, kLatticeLimit}};  // positions within the strip
  Vec at_;
  double first_reach_;
  double reach_;
  std::vector<Met> met_;
  std::unordered_map<std::uint64_t, std::size_t> met_at_;  // by the numbers of the two pieces, the moving one first
  std::optional<std::pair<Vec, double>> looked_from_;      // the position and the reach that `neighbours_` is for
  std::vector<std::size_t> neighbours_;                    // in met_
  std::vector<CellSide> cell_;
  std::vector<Bound> bounds_;
  Slide last_;
};

}  // namespace

Bump bump(const scene::Scene& scene, PieceId piece, double dx, double dy, const std::stop_token& stop,
          const BumpTuning& tuning) {
  const double length = std::hypot(dx, dy);
  if (scene.fixed(piece.value) || !(length > 0))
    return {scene::StopReason::kConverged, scene.pieces.at(piece.value), 0, {}};
  return Bumper{scene, piece.value, dx / length, dy / length, stop, tuning}.run();
}

Result<BumpedMarker> repair_and_bump(const Marker& start, PieceId piece, double dx, double dy, const scene::Run& run) {
  return repair_and_bump(start, scene::LaidOut{start, run}, piece, dx, dy, run);
}

Result<BumpedMarker> repair_and_bump(const Marker& start, const scene::LaidOut& laid_out, PieceId piece, double dx,
                                     double dy, const scene::Run& run) {
  run.observer.on_stage(scene::Stage::kOther);
  scene::Scene scene{start, laid_out, run.sums};
  const auto repairing = [&] {
    return laid_out.figures.valid ? Result<repair::Repair>{repair::Repair{}} : repair::repair_overlaps(scene, run);
  };
  return repair::repaired_and<BumpedMarker>(scene, repairing, [&](BumpedMarker& bumped) {
    run.observer.on_stage(scene::Stage::kSolve);
    bumped.bump = bump(scene, piece, dx, dy, run.stop);
    bumped.reason = bumped.bump.reason;
    scene.shift(piece, bumped.bump.at - scene.pieces.at(piece.value));
    run.observer.on_stage(scene::Stage::kOther);
  });
}

}  // namespace selvage::motion::piece
