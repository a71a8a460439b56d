#include "core/motion/repair/repair.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <utility>

#include "core/lp/solver/solve.h"
#include "core/marker/validity.h"
#include "core/model/active_set.h"
#include "core/model/position_model.h"
#include "core/model/snap.h"
#include "core/motion/repair/separation_target.h"

namespace selvage::motion::repair {
namespace {

constexpr int kRounds = 12;
constexpr int kNamed = 5;            // of the offending pairs, so many are named in a message
constexpr double kReach = 20;        // rows within so many healing limits of a pair's position are modelled
constexpr double kLengthCost = 1e3;  // of the marker growing, beside a piece moving by as much
constexpr double kStillness = 1;     // of a piece moving

struct Conflict {
  marker::PiecePair pair;
  double depth{};  // how far they must part; lattice units
};

class Healer {
 public:
  Healer(scene::Scene& scene, const scene::Run& run)
      : scene_{scene},
        run_{run},
        limit_{kHealingLimit * static_cast<double>(scene.marker.strip.width)},
        unit_{scene.marker.strip} {}

  Result<Repair> run() {
    const std::vector<Vec> start = scene_.pieces.positions();
    const Coord length = scene_.pieces.length();
    Repair repair;
    auto found = find_conflicts();
    const auto refusal = refuse_deep(found, repair);
    if (refusal && !run_.stopped()) return *refusal;
    for (int round = 0; round < kRounds && !(found.empty() && protrusions() == 0); ++round) {
      if (!part(found)) break;
      found = find_conflicts();
    }
    const bool parted =
        run_.stopped() ? is_valid(scene_.pieces, scene_.marker.strip) : found.empty() && protrusions() == 0;
    if (!parted) {
      scene_.pieces.place(start);
      if (!run_.stopped()) return unparted(found);
      return Error{ErrorCode::kStoppedEarly, "stopped before the overlaps of the input were parted", "/pieces"};
    }
    for (std::size_t i = 0; i < start.size(); ++i) {
      const Vec move = scene_.pieces.at(i) - start[i];
      repair.farthest_move = std::max({repair.farthest_move, std::abs(move.x), std::abs(move.y)});
    }
    repair.lengthened = std::max(Coord{0}, scene_.pieces.length() - length);
    return repair;
  }

 private:
  // Asked to stop, only some.
  std::vector<Conflict> find_conflicts() {
    run_.observer.on_stage(scene::Stage::kVerify);
    std::vector<Conflict> found;
    for (const marker::PiecePair& pair : conflicts(scene_.pieces, *run_.executor, run_.stop)) {
      if (run_.stopped()) break;
      found.push_back({pair, target(pair).depth});
    }
    return found;
  }
  [[nodiscard]] SeparationTarget target(marker::PiecePair pair) const {
    return separation_target(scene_, pair, TargetRule::kNearest);
  }
  [[nodiscard]] Coord protrusion(std::size_t piece) const {
    return std::max(protrusion_of(scene_.pieces.box(piece), scene_.marker.strip), Coord{0});
  }
  [[nodiscard]] std::size_t protrusions() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < scene_.pieces.size(); ++i) count += protrusion(i) > 0;
    return count;
  }

  std::optional<Error> refuse_deep(const std::vector<Conflict>& found, Repair& repair) {
    for (std::size_t i = 0; i < scene_.pieces.size(); ++i) {
      const Coord by = protrusion(i);
      repair.deepest = std::max(repair.deepest, static_cast<double>(by));
      repair.protruding += by > 0;
      if (static_cast<double>(by) <= limit_) continue;
      return Error{ErrorCode::kOutsideStrip,
                   "piece \"" + scene_.marker.pieces[i].id + "\" leaves the strip by " +
                       decimal(static_cast<double>(by)) + "; at most " + decimal(limit_) + " is mended",
                   "/pieces/" + std::to_string(i) + "/at"};
    }
    repair.pairs = found.size();
    std::vector<Conflict> deep;
    for (const Conflict& c : found) {
      repair.deepest = std::max(repair.deepest, c.depth);
      if (c.depth > limit_) deep.push_back(c);
    }
    if (deep.empty()) return std::nullopt;
    return Error{ErrorCode::kMarkerOverlaps,
                 std::to_string(deep.size()) +
                     (deep.size() == 1 ? " pair of pieces overlaps" : " pairs of pieces overlap") +
                     (scene_.pieces.widest_spacing() > 0 ? ", or come closer than the spacing," : "") +
                     " by more than the " + decimal(limit_) + " that is mended: " + named(deep),
                 "/pieces"};
  }
  [[nodiscard]] std::string decimal(double lattice_units) const {
    std::ostringstream text;
    text.precision(6);
    text << lattice_units * to_decimal(1, scene_.marker.resolution) << ' ' << scene_.marker.unit;
    return text.str();
  }
  [[nodiscard]] std::string named(const std::vector<Conflict>& list) const {
    std::string text;
    for (std::size_t k = 0; k < list.size() && k < kNamed; ++k) {
      const auto& [pair, depth] = list[k];
      text += (k > 0 ? ", \"" : "\"") + scene_.marker.pieces[pair.first].id + "\" and \"" +
              scene_.marker.pieces[pair.second].id + "\" by " + decimal(depth);
    }
    return list.size() > kNamed ? text + " and " + std::to_string(list.size() - kNamed) + " more" : text;
  }

  // REQUIRES: the pieces are where they came.
  [[nodiscard]] Error unparted(const std::vector<Conflict>& found) const {
    if (!found.empty()) {
      return {ErrorCode::kRepairFailed,
              "small overlaps could not be parted: " + named(found) +
                  "; there is no room for them where they are, or the pieces are locked or of one group",
              "/pieces"};
    }
    std::size_t piece = 0;
    while (piece + 1 < scene_.pieces.size() && protrusion(piece) == 0) ++piece;
    return {ErrorCode::kRepairFailed,
            "piece \"" + scene_.marker.pieces[piece].id + "\" leaves the strip by " +
                decimal(static_cast<double>(protrusion(piece))) +
                " and could not be put back; there is no room for it, or it is locked",
            "/pieces/" + std::to_string(piece) + "/at"};
  }

  // One program: every near pair keeps apart, every conflict is parted, all with the least motion.  First within the
  // marker's length, then beyond it.
  bool part(const std::vector<Conflict>& found) {
    run_.observer.on_stage(scene::Stage::kRows);
    const auto near = pairs_within(scene_.pieces, std::llround(kReach * limit_) + scene_.pieces.widest_spacing());
    model::ActiveSet reached = to_be_moved(found);
    for (const double lengthen : {unit_.to_lattice(1e-2), kReach * limit_}) {
      if (part_within(lengthen, found, near, reached)) return true;
      if (run_.stopped()) return false;
    }
    return false;
  }

  [[nodiscard]] model::ActiveSet to_be_moved(const std::vector<Conflict>& found) const {
    model::ActiveSet reached{scene_.ties};
    for (const Conflict& conflict : found) {
      reached.add(conflict.pair.first);
      reached.add(conflict.pair.second);
    }
    for (std::size_t i = 0; i < scene_.pieces.size(); ++i) {
      if (protrusion(i) > 0) reached.add(i);
    }
    return reached;
  }

  // With columns for what is reached, and for more until nothing is missed.
  bool part_within(double lengthen, const std::vector<Conflict>& found, const std::vector<marker::PiecePair>& near,
                   model::ActiveSet& reached) {
    for (;;) {
      run_.observer.on_stage(scene::Stage::kRows);
      model::PositionModel model{scene_.pieces, scene_.marker.strip, reached.with_others_fixed()};
      model.add_length(kLengthCost, 0, lengthen);
      for (std::size_t i = 0; i < scene_.pieces.size(); ++i) model.add_right_wall(i);
      std::vector<std::pair<int, model::PairRow>> modelled;
      for (const model::PairRow& row : rows_for(found, near, reached)) {
        if (const auto added = model.add(row)) modelled.emplace_back(*added, row);
      }
      model.add_displacement_penalty(kStillness);
      run_.observer.on_stage(scene::Stage::kSolve);
      run_.observer.on_program(model.program());
      const lp::LpSolution solution = solve(model.program(), lp::solver::SolverChoice::kAutomatic, {}, run_.stop);
      std::vector<std::uint32_t> missed;
      if (solution.status == lp::LpStatus::kOptimal) {
        missed = missed_in(solution, modelled, reached);
        if (missed.empty()) {
          take(model.displacements(solution.x));
          return true;
        }
      } else if (!run_.stopped()) {
        missed = beside(reached, near);
      }
      if (missed.empty()) return false;
      reached.grow(std::move(missed), near);
    }
  }

  void take(const std::vector<RealVec>& displacements) {
    std::vector<Vec> positions = model::snapped(displacements);
    for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = positions[i] + scene_.pieces.at(i);
    scene_.pieces.place(std::move(positions));
  }

  [[nodiscard]] std::vector<std::uint32_t> missed_in(const lp::LpSolution& solution,
                                                     const std::vector<std::pair<int, model::PairRow>>& modelled,
                                                     const model::ActiveSet& reached) const {
    model::Pressure pressure{scene_.pieces.size()};
    for (const auto& [row, pair_row] : modelled) pressure.add(pair_row, solution.dual[static_cast<std::size_t>(row)]);
    const Box room = scene_.marker.strip.room(scene_.marker.strip.last().value_or(kLatticeLimit));
    return reached.missed(scene_.pieces, pressure.load(), kStillness, room);
  }
  // Whose motion might help where there is no room.
  [[nodiscard]] static std::vector<std::uint32_t> beside(const model::ActiveSet& reached,
                                                         const std::vector<marker::PiecePair>& near) {
    std::vector<std::uint32_t> neighbours;
    for (const auto& [p, q] : near) {
      if (reached.holds(p) && reached.may_hold(q)) neighbours.push_back(q);
      if (reached.holds(q) && reached.may_hold(p)) neighbours.push_back(p);
    }
    return neighbours;
  }

  // Of the pairs that something reached is of.
  [[nodiscard]] std::vector<model::PairRow> rows_for(const std::vector<Conflict>& found,
                                                     const std::vector<marker::PiecePair>& near,
                                                     const model::ActiveSet& reached) const {
    std::vector<marker::PiecePair> held;
    std::copy_if(near.begin(), near.end(), std::back_inserter(held),
                 [&](const marker::PiecePair& pair) { return reached.holds_any(pair); });
    const auto obstacles = scene_.obstacles(held, *run_.executor);
    std::vector<model::PairRow> rows;
    auto conflict = found.begin();  // both lists are sorted by pair
    for (std::size_t k = 0; k < held.size(); ++k) {
      const marker::PiecePair pair = held[k];
      while (conflict != found.end() && conflict->pair < pair) ++conflict;
      const bool apart = conflict == found.end() || conflict->pair != pair;
      const Vec r = scene_.relative_position(pair);
      const Vec about = apart ? r : target(pair).about;
      const Coord spacing = scene_.pieces.spacing(pair);
      append_pair_rows(pair, {obstacles[k], r, about, spacing}, model::region_within(kReach * limit_, spacing), {unit_},
                       rows);
    }
    return rows;
  }

  scene::Scene& scene_;
  const scene::Run& run_;
  double limit_;
  model::ModelUnit unit_;
};

}  // namespace

Result<Repair> repair_overlaps(scene::Scene& scene, const scene::Run& run) {
  return Healer{scene, run}.run();
}

}  // namespace selvage::motion::repair
