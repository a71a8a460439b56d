#include "core/packing/roomiest.h"

#include <algorithm>
#include <utility>

namespace selvage::packing {
namespace {

constexpr Coord kPrecision = 64;  // bisection ends when the interval is this part of the clearance found
constexpr Coord kLeastStep = 4;   // lattice units
constexpr Coord kFirstPart = 64;  // the first clearance tried, a part of the container's narrower side

Coord even(Coord clearance) {
  return clearance - clearance % 2;
}

class Bisection {
 public:
  Bisection(const Marker& start, std::span<const PieceId> pieces, const Container& container,
            const ContainSettings& settings, const scene::Run& run)
      : start_{start}, pieces_{pieces}, container_{container}, settings_{settings}, run_{run} {}

  RoomyContainment run() {
    const Coord first = settings_.clearance;
    if (!fits(first)) return std::move(best_);
    Coord step = std::max(kLeastStep, std::min(container_.box.width(), container_.box.height()) / kFirstPart);
    while (!ended_ && fits(even(best_.clearance + step))) step *= 2;
    // Everything above `without` is left out: it is impossible, or was not found.
    Coord without = even(best_.clearance + step);
    while (!ended_) {
      const Coord interval = without - best_.clearance;
      if (interval <= std::max(kLeastStep, best_.clearance / kPrecision)) break;
      const Coord middle = even(best_.clearance + interval / 2);
      if (!fits(middle)) without = middle;
    }
    return std::move(best_);
  }

 private:
  bool fits(Coord clearance) {
    const branching::Work work = best_.work;
    ContainSettings settings = settings_;
    settings.clearance = clearance;
    settings.limits.nodes -= std::min(settings.limits.nodes, work.nodes);
    settings.limits.pivots -= std::min(settings.limits.pivots, work.pivots);
    const int rounds = best_.rounds;
    Containment tried = contain(start_, pieces_, container_, settings, run_);
    const bool first = clearance == settings_.clearance;
    const bool found = tried.verdict == Verdict::kFound;
    if (tried.verdict == Verdict::kImpossible && !first)
      best_.clearance_bound = std::min(best_.clearance_bound.value_or(clearance), clearance);
    ended_ = tried.reason != scene::StopReason::kConverged;
    const scene::StopReason reason = tried.reason;
    const branching::Work spent = tried.work;
    const int done = tried.rounds;
    if (first || found) static_cast<Containment&>(best_) = std::move(tried);
    if (found) best_.clearance = clearance;
    best_.reason = reason;
    best_.work = work;
    best_.work += spent;
    best_.rounds = rounds + done;
    return found;
  }

  const Marker& start_;
  std::span<const PieceId> pieces_;
  const Container& container_;
  const ContainSettings& settings_;
  const scene::Run& run_;
  RoomyContainment best_;
  bool ended_{};
};

}  // namespace

RoomyContainment contain_with_most_room(const Marker& start, std::span<const PieceId> pieces,
                                        const Container& container, const ContainSettings& settings,
                                        const scene::Run& run) {
  return Bisection{start, pieces, container, settings, run}.run();
}

}  // namespace selvage::packing
