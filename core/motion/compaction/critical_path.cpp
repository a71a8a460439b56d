#include "core/motion/compaction/critical_path.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/lp/solver/solve.h"
#include "core/marker/clearance.h"
#include "core/marker/validity.h"
#include "core/model/contacts/contact.h"
#include "core/model/position_model.h"
#include "core/scene/scene.h"

namespace selvage::motion::compaction {
namespace {

// The loads on rows and bounds in one solution.
class Loads {
 public:
  Loads(const Marker& marker, const CriticalPathTuning& tuning, const scene::Run& run)
      : scene_{marker, run}, tuning_{tuning} {}

  Result<CriticalPath> run(const scene::Run& run) {
    find_rows(run);
    lp::LpSolution solution = solve_model(run);
    while (solution.status == lp::LpStatus::kOptimal && lift_unbacked(solution)) solution = solve_model(run);
    if (run.stopped()) {
      return Error{ErrorCode::kStoppedEarly, "stopped before the critical path was known", ""};
    }
    CriticalPath path;
    if (solution.status != lp::LpStatus::kOptimal) return path;  // empty: there is no solution to read
    for (std::size_t k = 0; k < rows_.size(); ++k) add_pair(rows_[k].row, load_on(k, solution), path);
    add_edges(solution, path);
    add_shades(solution, path);
    add_match_sets(path);
    add_locks(solution, path);
    merge(path);
    std::stable_sort(path.rules.begin(), path.rules.end(),
                     [](const RulePrice& a, const RulePrice& b) { return a.worth > b.worth; });
    for (const auto& [piece, per_degree] : tilts_) path.tilts.push_back({PieceId{piece}, per_degree});
    std::stable_sort(path.tilts.begin(), path.tilts.end(), [](const TiltWorth& a, const TiltWorth& b) {
      return std::abs(a.per_degree) > std::abs(b.per_degree);
    });
    return path;
  }

 private:
  // A row, and its number in the present program; none when the pieces never move against each other.
  struct Row {
    model::PairRow row;
    std::optional<int> in_program;
  };
  [[nodiscard]] double in_widths(double part) const { return part * static_cast<double>(scene_.marker.strip.width); }
  [[nodiscard]] static model::PairPosition position_of(const minkowski::Obstacle& obstacle, Vec r, Coord spacing) {
    return {obstacle, r, r, spacing};
  }

  void find_rows(const scene::Run& run) {
    run.observer.on_stage(scene::Stage::kRows);
    const double reach = in_widths(tuning_.reach);
    const model::ModelUnit unit{scene_.marker.strip};
    for (const marker::PiecePair& pair :
         pairs_within(scene_.pieces, std::llround(reach) + scene_.pieces.widest_spacing())) {
      if (run.stopped()) return;
      if (scene_.ties.joined(pair.first, pair.second)) continue;
      const Coord spacing = scene_.pieces.spacing(pair);
      const auto obstacle = scene_.obstacle(pair, run.stop);
      if (!obstacle) return;
      for (const model::PairRow& row : pair_rows(pair, position_of(*obstacle, scene_.relative_position(pair), spacing),
                                                 model::region_within(reach, spacing), {unit})) {
        rows_.push_back({row, {}});
      }
    }
  }

  lp::LpSolution solve_model(const scene::Run& run) {
    if (run.stopped()) return {};
    model_.emplace(scene_.pieces, scene_.marker.strip, scene_.ties);
    for (Row& row : rows_) row.in_program = model_->add(row.row);
    const auto length = static_cast<double>(scene_.pieces.length());
    model_->add_length(1, length, model_->unit().to_lattice(tuning_.spare));
    for (std::size_t i = 0; i < scene_.pieces.size(); ++i) model_->add_right_wall(i);
    run.observer.on_stage(scene::Stage::kSolve);
    run.observer.on_program(model_->program());
    return solve(model_->program(), lp::solver::SolverChoice::kSimplex, {}, run.stop);
  }

  [[nodiscard]] double load_on(std::size_t k, const lp::LpSolution& solution) const {
    const std::optional<int> row = rows_[k].in_program;
    return row ? solution.dual[static_cast<std::size_t>(*row)] : 0;
  }
  // Leaves out the rows that carry load although the pieces do not meet there: the line of an edge, beyond the edge.
  // True when there were any.
  bool lift_unbacked(const lp::LpSolution& solution) {
    std::vector<Row> kept;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      if (load_on(k, solution) < tuning_.least_worth || is_contact(rows_[k].row)) kept.push_back(rows_[k]);
    }
    const bool any = kept.size() < rows_.size();
    rows_ = std::move(kept);
    return any;
  }
  [[nodiscard]] bool is_contact(const model::PairRow& row) const {
    const minkowski::Obstacle obstacle = scene_.obstacle(row.pair);
    const double apart = std::max(0.0, -row.bound);
    const model::PairPosition position =
        position_of(obstacle, scene_.relative_position(row.pair), scene_.pieces.spacing(row.pair));
    return model::contacts::backing_of(row, position, in_widths(tuning_.touching) + tuning_.beside * apart) !=
           model::contacts::Backing::kNone;
  }

  void add_pair(const model::PairRow& row, double worth, CriticalPath& path) {
    if (worth < tuning_.least_worth) return;
    const auto [p, q] = row.pair;
    const Coord near = std::llround(in_widths(tuning_.contact)) + scene_.pieces.spacing(row.pair);
    const geometry::PlacedPolygon first = scene_.pieces.facing(p, q);
    const geometry::PlacedPolygon second = scene_.pieces.facing(q, p);
    const RealVec at = nearest_point(first, second);
    if (marker::collide(first, second, near)) {
      path.contacts.push_back({PieceId{p}, PieceId{q}, {}, worth, at});
    }
    path.per_spacing += worth;
    turn(q, worth, row.nx, row.ny, at);
    turn(p, worth, -row.nx, -row.ny, at);
  }

  // A small turn of a piece about its position moves the touching point perpendicular to the lever arm; its component
  // along the normal of the contact, which points at the piece, is the room gained.
  void turn(std::uint32_t piece, double worth, double nx, double ny, RealVec at) {
    forces_[piece].x += worth * nx;
    forces_[piece].y += worth * ny;
    if (scene_.fixed(piece)) return;
    const Vec pivot = scene_.pieces.at(piece);
    const double lever_x = at.x - static_cast<double>(pivot.x);
    const double lever_y = at.y - static_cast<double>(pivot.y);
    tilts_[piece] += worth * (ny * lever_x - nx * lever_y) * std::numbers::pi / 180;
  }

  // The edges of a room are rows (right) or bounds of columns (the others): a bound's load is its column's reduced
  // cost.
  void add_edges(const lp::LpSolution& solution, CriticalPath& path) {
    const lp::LinearProgram& program = model_->program();
    std::vector<double> reduced = program.cost;
    for (int r = 0; r < program.rows(); ++r) {
      for (const auto& [column, value] : program.row(r)) {
        reduced[static_cast<std::size_t>(column)] -= value * solution.dual[static_cast<std::size_t>(r)];
      }
    }
    for (std::uint32_t i = 0; i < scene_.pieces.size(); ++i) {
      const Box room = scene_.pieces.room(i, scene_.marker.strip, kLatticeLimit);
      const Box box = scene_.pieces.box(i);
      const bool matched = scene_.marker.pieces[i].rules.matched_to_cloth();
      const Vec repeat = matched ? scene_.pieces.repeat_of(i, scene_.marker.strip) : Vec{};
      if (const auto x = model_->x_column(i)) {
        const double load = reduced[static_cast<std::size_t>(*x)];
        const bool at_low = bounds(program.lower, *x, room.low.x - box.low.x);
        const bool at_high = bounds(program.upper, *x, room.high.x - box.high.x);
        if (repeat.x > 0) {
          if (at_low) add_price(Rule::kMatchX, PieceId{i}, std::abs(load), path);
        } else {
          if (at_low) add_edge(i, StripEdge::kLeft, load, 1, 0, path);
          if (at_high) {
            add_price(Rule::kTo, PieceId{i}, -load, path);
            forces_[i].x += load;
          }
        }
      }
      if (const auto y = model_->y_column(i)) {
        const double load = reduced[static_cast<std::size_t>(*y)];
        const bool at_low = bounds(program.lower, *y, room.low.y - box.low.y);
        const bool at_high = bounds(program.upper, *y, room.high.y - box.high.y);
        if (repeat.y > 0) {
          if (at_low) add_price(Rule::kMatchY, PieceId{i}, std::abs(load), path);
        } else {
          if (at_low) add_edge(i, StripEdge::kBottom, load, 0, 1, path);
          if (at_high) add_edge(i, StripEdge::kTop, -load, 0, -1, path);
        }
      }
      if (const auto wall = model_->right_wall_row(i)) {
        add_edge(i, StripEdge::kRight, solution.dual[static_cast<std::size_t>(*wall)], -1, 0, path);
      }
    }
  }
  // True when this piece, of those tied together, is the one whose room sets the column's bound.
  [[nodiscard]] bool bounds(const std::vector<double>& limits, int column, Coord room) const {
    return std::abs(model_->unit().to_lattice(limits[static_cast<std::size_t>(column)]) - static_cast<double>(room)) <
           0.5;
  }
  // `(nx, ny)`: from the edge into the strip.
  void add_edge(std::uint32_t piece, StripEdge edge, double worth, int nx, int ny, CriticalPath& path) {
    const marker::Rules& rules = scene_.marker.pieces[piece].rules;
    const marker::FoldEdge fold = fold_edge(rules, scene_.pieces[piece].vertices, scene_.marker.strip);
    if (edge == StripEdge::kBottom && rules.on_fold) add_price(Rule::kFold, PieceId{piece}, std::abs(worth), path);
    if (worth < tuning_.least_worth) return;
    const RealVec at = touching_point(piece, nx, ny);
    turn(piece, worth, nx, ny, at);
    if (edge == (fold == marker::FoldEdge::kUpper ? StripEdge::kBottom : StripEdge::kTop) && rules.on_fold)
      return;  // the fold holds the piece
    add_price_of_edge(piece, edge, worth, path);
    const bool in_band = edge == StripEdge::kLeft && rules.from && *rules.from > scene_.marker.strip.margin;
    if (!in_band && distance_to(edge, piece) <= in_widths(tuning_.contact)) {
      path.contacts.push_back({PieceId{piece}, std::nullopt, edge, worth, at});
    }
  }

  // The price of the rule, if any, that has put the edge of a room where it is.
  void add_price_of_edge(std::uint32_t piece, StripEdge edge, double worth, CriticalPath& path) const {
    const marker::Rules& rules = scene_.marker.pieces[piece].rules;
    const Strip& strip = scene_.marker.strip;
    const auto selvedge = [&](Rule rule, bool own, bool of_strip) {
      if (own) add_price(rule, PieceId{piece}, worth, path);
      if (!own && of_strip) add_price(rule, std::nullopt, worth, path);
    };
    if (edge == StripEdge::kLeft && rules.from && *rules.from > strip.margin) {
      add_price(Rule::kFrom, PieceId{piece}, worth, path);
    }
    if (edge == StripEdge::kBottom && !rules.on_fold)
      selvedge(Rule::kBelow, rules.below.has_value(), strip.below.has_value());
    if (edge == StripEdge::kTop && !rules.on_fold)
      selvedge(Rule::kAbove, rules.above.has_value(), strip.above.has_value());
  }
  // Adds to the price of the same rule of the same piece, or of the strip.
  void add_price(Rule rule, std::optional<PieceId> piece, double worth, CriticalPath& path) const {
    if (worth < tuning_.least_worth) return;
    const auto same = std::find_if(path.rules.begin(), path.rules.end(),
                                   [&](const RulePrice& price) { return price.rule == rule && price.piece == piece; });
    if (same == path.rules.end()) {
      path.rules.push_back({rule, piece, worth});
    } else {
      same->worth += worth;
    }
  }
  // A unit more of a shade's length eases the rows of all pieces at its right end.
  void add_shades(const lp::LpSolution& solution, CriticalPath& path) {
    for (const marker::Shade& shade : scene_.pieces.shades()) {
      double worth = 0;
      for (const model::ShadeRow& row : model_->shade_rows()) {
        const bool of_it = std::binary_search(shade.pieces.begin(), shade.pieces.end(), row.piece);
        if (!of_it) continue;
        const double load = solution.dual[static_cast<std::size_t>(row.in_program)];
        forces_[row.piece].x += load * row.nx;
        if (row.nx < 0) worth += load;
      }
      add_price(Rule::kShade, PieceId{shade.pieces.front()}, worth, path);
    }
  }
  // The pieces of a match set share a displacement: what presses on one of them alone is borne by the rule.
  void add_match_sets(CriticalPath& path) {
    for (const marker::MatchSet& set : scene_.pieces.match_sets()) {
      for (const std::uint32_t piece : set) {
        const auto found = forces_.find(piece);
        if (found == forces_.end() || !scene_.ties.free(piece)) continue;
        if (scene_.marker.strip.repeat.along > 0)
          add_price(Rule::kMatchX, PieceId{piece}, std::abs(found->second.x), path);
        if (scene_.marker.strip.repeat.across > 0)
          add_price(Rule::kMatchY, PieceId{piece}, std::abs(found->second.y), path);
      }
    }
  }
  [[nodiscard]] double distance_to(StripEdge edge, std::uint32_t piece) const {
    const Box room = scene_.pieces.room(piece, scene_.marker.strip, scene_.pieces.length());
    const Box box = scene_.pieces.box(piece);
    switch (edge) {
      case StripEdge::kLeft: return static_cast<double>(box.low.x - room.low.x);
      case StripEdge::kRight: return static_cast<double>(room.high.x - box.high.x);
      case StripEdge::kBottom: return static_cast<double>(box.low.y - room.low.y);
      case StripEdge::kTop: return static_cast<double>(room.high.y - box.high.y);
    }
    return 0;
  }
  // The mean of the vertices that lie farthest against the direction.
  [[nodiscard]] RealVec touching_point(std::uint32_t piece, int nx, int ny) const {
    const geometry::PlacedPolygon polygon = scene_.pieces[piece];
    const auto along = [&](Vec v) { return nx * v.x + ny * v.y; };
    Coord least = along(polygon.vertices.front());
    for (const Vec v : polygon.vertices) least = std::min(least, along(v));
    RealVec sum;
    double count = 0;
    for (const Vec v : polygon.vertices) {
      if (along(v) != least) continue;
      sum.x += static_cast<double>(v.x + polygon.at.x);
      sum.y += static_cast<double>(v.y + polygon.at.y);
      count += 1;
    }
    return {sum.x / count, sum.y / count};
  }

  // The loads on a piece that may move are in balance.  What is left over on a locked one, and on those tied to it, is
  // borne by its lock.
  void add_locks(const lp::LpSolution& solution, CriticalPath& path) {
    press_back(solution);
    const std::vector<Piece>& pieces = scene_.marker.pieces;
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
      if (!pieces[i].locked.x && !pieces[i].locked.y) continue;
      RealVec sum;
      for (const auto& [k, force] : forces_) {
        const bool tied = k == i || (!pieces[i].group.empty() && pieces[k].group == pieces[i].group);
        if (!tied) continue;
        sum.x += force.x;
        sum.y += force.y;
      }
      LockPrice price{PieceId{i}, {}, {}};
      if (pieces[i].locked.x && std::abs(sum.x) >= tuning_.least_worth) price.per_x = sum.x;
      if (pieces[i].locked.y && std::abs(sum.y) >= tuning_.least_worth) price.per_y = sum.y;
      if (price.per_x || price.per_y) path.locks.push_back(price);
    }
  }
  // A fixed piece at the end of the marker bounds its length, without a row: what the rows of the right edge do not
  // bear presses on it.  Of several such pieces no single one could move and shorten the marker.
  void press_back(const lp::LpSolution& solution) {
    std::vector<std::uint32_t> fixed;
    double borne = 0;
    for (std::uint32_t i = 0; i < scene_.pieces.size(); ++i) {
      if (const auto wall = model_->right_wall_row(i)) borne += solution.dual[static_cast<std::size_t>(*wall)];
      if (!model_->x_column(i) && scene_.pieces.end_of(i) == scene_.pieces.length()) fixed.push_back(i);
    }
    if (fixed.size() == 1) forces_[fixed.front()].x -= std::max(0.0, 1 - borne);
  }

  // A pair that touches along several lines is one contact; contacts are sorted from left to right.
  static void merge(CriticalPath& path) {
    auto& contacts = path.contacts;
    std::stable_sort(contacts.begin(), contacts.end(), [](const LoadedContact& a, const LoadedContact& b) {
      return std::tuple{a.at.x, a.at.y, a.first} < std::tuple{b.at.x, b.at.y, b.first};
    });
    std::vector<LoadedContact> merged;
    for (const LoadedContact& c : contacts) {
      const auto same = std::find_if(merged.begin(), merged.end(), [&](const LoadedContact& m) {
        return c.second && m.first == c.first && m.second == c.second;
      });
      if (same == merged.end()) {
        merged.push_back(c);
      } else {
        same->worth += c.worth;
      }
    }
    contacts = std::move(merged);
  }

  scene::Scene scene_;
  const CriticalPathTuning& tuning_;
  std::vector<Row> rows_;
  std::optional<model::PositionModel> model_;
  std::map<std::uint32_t, double> tilts_;
  std::map<std::uint32_t, RealVec> forces_;  // on each piece, by all its contacts; length per unit of displacement
};

}  // namespace

Result<CriticalPath> critical_path(const Marker& marker, const scene::Run& run, const CriticalPathTuning& tuning) {
  run.observer.on_stage(scene::Stage::kVerify);
  if (!is_valid(marker)) {
    return Error{ErrorCode::kMarkerOverlaps, "the marker is not valid: compact it or separate its pieces first",
                 "/pieces"};
  }
  return Loads{marker, tuning, run}.run(run);
}

}  // namespace selvage::motion::compaction
