#include "core/motion/heal.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/lp/solve.h"
#include "core/marker/validity.h"
#include "core/model/position_model.h"
#include "core/model/snap.h"
#include "core/motion/separation_target.h"

namespace selvage {
namespace {

constexpr int kRounds = 12;
constexpr int kNamed = 5;            // of the offending pairs, so many are named in a message
constexpr double kReach = 20;        // rows within so many healing limits of a pair's position are modelled
constexpr double kLengthCost = 1e3;  // of the marker growing, beside a piece moving by as much

struct Conflict {
  PiecePair pair;
  double depth{};  // how far they must part; lattice units
};

class Healer {
 public:
  Healer(Scene& scene, const Observer& observer)
      : scene_{scene},
        observer_{observer},
        limit_{kHealingLimit * static_cast<double>(scene.marker.strip.width)},
        unit_{static_cast<double>(scene.marker.strip.width) / 1000} {}

  Result<Healing> run(std::stop_token stop) {
    const std::vector<Vec> start = scene_.pieces.positions();
    const Coord length = scene_.pieces.length();
    Healing healing;
    auto found = find_conflicts();
    if (const auto refusal = refuse_deep(found, healing)) return *refusal;
    for (int round = 0; round < kRounds && !(found.empty() && protrusions() == 0); ++round) {
      if (!part(found, stop)) break;
      found = find_conflicts();
    }
    if (!found.empty() || protrusions() > 0) {
      scene_.pieces.place(start);
      if (stop.stop_requested()) {
        return Error{ErrorCode::kStoppedEarly, "stopped before the overlaps of the input were parted", "/pieces"};
      }
      return unparted(found);
    }
    for (std::size_t i = 0; i < start.size(); ++i) {
      const Vec move = scene_.pieces.at(i) - start[i];
      healing.farthest_move = std::max({healing.farthest_move, std::abs(move.x), std::abs(move.y)});
    }
    healing.lengthened = std::max(Coord{0}, scene_.pieces.length() - length);
    return healing;
  }

 private:
  std::vector<Conflict> find_conflicts() {
    observer_.on_stage(Stage::kVerify);
    std::vector<Conflict> found;
    for (const PiecePair& pair : conflicts(scene_.pieces, *observer_.crew)) found.push_back({pair, target(pair).depth});
    return found;
  }
  [[nodiscard]] SeparationTarget target(PiecePair pair) const {
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

  std::optional<Error> refuse_deep(const std::vector<Conflict>& found, Healing& healing) {
    for (std::size_t i = 0; i < scene_.pieces.size(); ++i) {
      const Coord by = protrusion(i);
      healing.deepest = std::max(healing.deepest, static_cast<double>(by));
      healing.protruding += by > 0;
      if (static_cast<double>(by) <= limit_) continue;
      return Error{ErrorCode::kOutsideStrip,
                   "piece \"" + scene_.marker.pieces[i].id + "\" leaves the strip by " +
                       decimal(static_cast<double>(by)) + "; at most " + decimal(limit_) + " is mended",
                   "/pieces/" + std::to_string(i) + "/at"};
    }
    healing.pairs = found.size();
    std::vector<Conflict> deep;
    for (const Conflict& c : found) {
      healing.deepest = std::max(healing.deepest, c.depth);
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
      return {ErrorCode::kHealingFailed,
              "small overlaps could not be parted: " + named(found) +
                  "; there is no room for them where they are, or the pieces are locked or of one group",
              "/pieces"};
    }
    std::size_t piece = 0;
    while (piece + 1 < scene_.pieces.size() && protrusion(piece) == 0) ++piece;
    return {ErrorCode::kHealingFailed,
            "piece \"" + scene_.marker.pieces[piece].id + "\" leaves the strip by " +
                decimal(static_cast<double>(protrusion(piece))) +
                " and could not be put back; there is no room for it, or it is locked",
            "/pieces/" + std::to_string(piece) + "/at"};
  }

  // One program: every near pair keeps apart, every conflict is parted, all with the least motion.  First within the
  // marker's length, then beyond it.
  bool part(const std::vector<Conflict>& found, const std::stop_token& stop) {
    observer_.on_stage(Stage::kRows);
    const std::vector<PairRow> rows = rows_for(found);
    for (const double lengthen : {1e-2 * unit_, kReach * limit_}) {
      observer_.on_stage(Stage::kRows);
      PositionModel model = model_with(rows, lengthen);
      observer_.on_stage(Stage::kSolve);
      const LpSolution solution = solve(model.program(), SolverChoice::kAutomatic, {}, stop);
      if (solution.status != LpStatus::kOptimal) continue;
      std::vector<Vec> positions = snapped(model.displacements(solution.x));
      for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = positions[i] + scene_.pieces.at(i);
      scene_.pieces.place(std::move(positions));
      return true;
    }
    return false;
  }

  [[nodiscard]] std::vector<PairRow> rows_for(const std::vector<Conflict>& found) const {
    std::vector<PairRow> rows;
    auto conflict = found.begin();  // both lists are sorted by pair
    const auto near = pairs_within(scene_.pieces, std::llround(kReach * limit_) + scene_.pieces.widest_spacing());
    const auto obstacles = scene_.obstacles(near, *observer_.crew);
    for (std::size_t k = 0; k < near.size(); ++k) {
      const PiecePair pair = near[k];
      const bool apart = conflict == found.end() || conflict->pair != pair;
      if (!apart) ++conflict;
      const Vec r = scene_.relative_position(pair);
      const Vec about = apart ? r : target(pair).about;
      const Coord spacing = scene_.pieces.spacing(pair);
      const RegionSettings region{RegionRule::kGreedy, kReach * limit_ + static_cast<double>(spacing), spacing};
      for (const HalfPlane& side : free_region(obstacles[k], about, region)) {
        rows.push_back(row_of(pair, side, r, spacing, unit_, TightRows::kRestore));
      }
    }
    return rows;
  }

  [[nodiscard]] PositionModel model_with(const std::vector<PairRow>& rows, double lengthen) const {
    PositionModel model{scene_.pieces, scene_.marker.strip, scene_.ties};
    model.add_length(kLengthCost, 0, lengthen);
    for (std::size_t i = 0; i < scene_.pieces.size(); ++i) model.add_right_wall(i);
    for (const PairRow& row : rows) model.add(row);
    model.add_stillness(1);
    return model;
  }

  Scene& scene_;
  const Observer& observer_;
  double limit_;
  double unit_;
};

}  // namespace

Result<Healing> heal(Scene& scene, std::stop_token stop, const Observer& observer) {
  return Healer{scene, observer}.run(std::move(stop));
}

}  // namespace selvage
