#include "core/motion/compaction/open_gap.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "core/motion/compaction/push.h"
#include "core/scene/scene.h"

namespace selvage::motion::compaction {
namespace {

class Opening {
 public:
  Opening(scene::Scene& scene, const CompactionSettings& settings, const marker::UnoccupiedSettings& regions,
          const GapTuning& tuning, const scene::Run& run)
      : scene_{scene}, settings_{settings}, regions_{regions}, tuning_{tuning}, run_{run}, quiet_{run.quiet()} {}

  // Finds the gap; false when it does not exist, or when cancelled before it was found.
  bool choose(const GapChoice& choice) {
    if (const auto* outline = std::get_if<AwayFromOutline>(&choice)) {
      auto found = regions();
      if (outline->region >= found.size()) return false;
      gap_ = std::move(found[outline->region]);
      inside_ = point_inside(gap_.region);
      return true;
    }
    from_point_ = true;
    inside_ = std::get<AwayFromPoint>(choice).point;
    return find_again();
  }
  // Finds the gap about the same point again, with the pieces where they are now; false when it has closed, or when
  // cancelled.
  bool find_again() {
    auto found = regions();
    auto holding = holds(found);
    if (!holding) return false;
    gap_ = std::move(*holding);
    return true;
  }

  void run() {
    CompactionSettings one_round = settings_;
    one_round.rounds = 1;
    one_round.least_gain = 0;
    progress_.reason = scene::StopReason::kWorkLimit;
    for (int tries = 0; progress_.rounds < settings_.rounds;) {
      const std::vector<Vec> before = scene_.pieces.positions();
      const double area = gap_.area;
      const Progress step = improve(scene_, goal(), one_round, quiet_);
      progress_.programs += step.programs;
      const bool larger = step.rounds > 0 && take_larger();
      if (!larger) scene_.pieces.place(before);
      if (step.reason == scene::StopReason::kCancelled || step.reason == scene::StopReason::kSolverFailed) {
        progress_.reason = step.reason;
        return;
      }
      if (larger) {
        ++progress_.rounds;
        run_.observer.on_round({progress_.rounds, scene_.pieces.length()});
      }
      // The forces follow the area to first order only: a short step may gain where a long one overshoots.
      if (!larger || gap_.area - area < settings_.least_gain * area) {
        if (step.rounds == 0 || ++tries == tuning_.tries) {
          progress_.reason = scene::StopReason::kConverged;
          return;
        }
        one_round.trust /= tuning_.shorter;
      }
    }
  }

  [[nodiscard]] const Progress& progress() const { return progress_; }
  [[nodiscard]] const marker::UnoccupiedRegion& gap() const { return gap_; }
  [[nodiscard]] Vec inside() const { return inside_; }

 private:
  // Empty when cancelled.
  [[nodiscard]] std::vector<marker::UnoccupiedRegion> regions() const {
    auto found = unoccupied_regions(scene_.pieces, scene_.marker.strip, regions_, run_.stop);
    return found ? *std::move(found) : std::vector<marker::UnoccupiedRegion>{};
  }
  [[nodiscard]] std::optional<marker::UnoccupiedRegion> holds(std::vector<marker::UnoccupiedRegion>& found) const {
    const auto held = std::find_if(found.begin(), found.end(), [&](const marker::UnoccupiedRegion& candidate) {
      return locate(inside_, candidate.region) != geometry::Location::kOutside;
    });
    return held == found.end() ? std::nullopt : std::optional{std::move(*held)};
  }
  // Takes the gap as it is now; false, with nothing changed, when it is not known to have grown.
  bool take_larger() {
    auto found = regions();
    auto now = holds(found);
    if (!now || now->area <= gap_.area) return false;
    gap_ = std::move(*now);
    return true;
  }
  [[nodiscard]] step::Goal goal() const { return *pushing_goal(forces(), scene_.pieces.size()); }
  [[nodiscard]] std::vector<Force> forces() const {
    std::vector<Force> forces;
    for (const marker::Bordering& beside : gap_.around) {
      if (scene_.fixed(beside.piece.value)) continue;
      if (!from_point_) {
        forces.push_back({beside.piece, beside.x, beside.y});
        continue;
      }
      const Box box = scene_.pieces.box(beside.piece.value);
      const double x = static_cast<double>(box.low.x + box.high.x) / 2 - static_cast<double>(inside_.x);
      const double y = static_cast<double>(box.low.y + box.high.y) / 2 - static_cast<double>(inside_.y);
      const double length = std::hypot(x, y);
      if (length > 0) forces.push_back({beside.piece, x / length, y / length});
    }
    return forces;
  }

  scene::Scene& scene_;
  const CompactionSettings& settings_;
  const marker::UnoccupiedSettings& regions_;
  const GapTuning& tuning_;
  const scene::Run& run_;
  const scene::Run quiet_;  // for the rounds of compaction within a round
  bool from_point_{};
  Vec inside_;
  marker::UnoccupiedRegion gap_;
  Progress progress_;
};

Error not_found(const GapChoice& choice, const scene::Run& run) {
  if (run.stopped()) return {ErrorCode::kStoppedEarly, "stopped before the gap was found", ""};
  if (const auto* outline = std::get_if<AwayFromOutline>(&choice)) {
    return {ErrorCode::kOutOfRange,
            "region number " + std::to_string(outline->region) + " is not among the unoccupied regions", "/region"};
  }
  return {ErrorCode::kOutOfRange, "the point lies in no unoccupied region large enough to count", "/point"};
}

}  // namespace

Result<OpenedGap> open_gap(const Marker& start, const GapChoice& choice, const CompactionSettings& settings,
                           const marker::UnoccupiedSettings& regions, const scene::Run& run, const GapTuning& tuning) {
  run.observer.on_stage(scene::Stage::kOther);
  scene::Scene scene{start, run};
  Opening opening{scene, settings, regions, tuning, run};
  // A region's number is its place in the list of the marker as it came in; repair may change the list.
  const bool by_number = std::holds_alternative<AwayFromOutline>(choice);
  bool found = by_number && opening.choose(choice);
  const auto repairing = [&] { return repair::repair_overlaps(scene, run); };
  return repair::repaired_and<OpenedGap>(scene, repairing, [&](OpenedGap& opened) -> std::optional<Error> {
    if (!by_number) {
      found = opening.choose(choice);
    } else if (found && opened.repair.farthest_move > 0) {
      found = opening.find_again();
    }
    if (!found) return not_found(choice, run);
    opened.before = opening.gap();
    opening.run();
    record(opening.progress(), opened);
    opened.inside = opening.inside();
    opened.after = opening.gap();
    return std::nullopt;
  });
}

}  // namespace selvage::motion::compaction
