#include "core/motion/step/near_pairs.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace selvage::motion::step {
namespace {

constexpr std::size_t kBlock = 64;         // pairs whose rows one thread makes at a time
constexpr std::size_t kPairsAtOnce = 512;  // pairs whose sums are found together

Coord trust_radius(const scene::Scene& scene, const StepSettings& settings) {
  return std::llround(settings.trust * static_cast<double>(scene.marker.strip.width));
}

double motion_of(const scene::Scene& scene, const Goal& goal, const StepSettings& settings) {
  if (settings.extent == model::Extent::kWhole && !goal.fixes_length()) return static_cast<double>(kLatticeLimit);
  return settings.tuning.motion_per_trust * (settings.trust * static_cast<double>(scene.marker.strip.width));
}

}  // namespace

NearPairs::NearPairs(const scene::Scene& scene, const Goal& goal, const StepSettings& settings)
    : scene_{scene},
      goal_{goal},
      settings_{settings},
      obstacles_{scene, settings.simplification},
      motion_{motion_of(scene, goal, settings)},
      within_trust_{pairs_within(scene.pieces, trust_radius(scene, settings) + scene.pieces.widest_spacing())} {
  if (!goal.fixes_length() && settings.extent == model::Extent::kActiveSet) last_moves_ = settings.last_moves;
}

double NearPairs::motion(marker::PiecePair pair) const {
  if (last_moves_.empty()) return motion_;
  const Vec by = last_moves_[pair.second] - last_moves_[pair.first];
  const auto moved = static_cast<double>(std::max(std::abs(by.x), std::abs(by.y)));
  const StepTuning& tuning = settings_.tuning;
  return std::clamp(tuning.motion_ahead * moved, tuning.least_motion * motion_, motion_);
}

std::size_t NearPairs::extend(const model::ActiveSet& active, const PairSet& modelled, const scene::Run& run) {
  const std::size_t known = pairs_.size();
  for (const marker::PiecePair& pair : within_trust_) {
    if (!active.holds_any(pair) || active.ties().joined(pair.first, pair.second)) continue;
    if (!modelled.contains(pair)) pairs_.push_back(pair);
  }
  for (std::size_t done = known; done < pairs_.size(); done += kPairsAtOnce) {
    const std::size_t count = std::min(kPairsAtOnce, pairs_.size() - done);
    auto found = obstacles_.of(std::span{pairs_}.subspan(done, count), *run.executor, run.stop);
    if (found.size() < count) {
      pairs_.resize(done);
      break;
    }
    std::move(found.begin(), found.end(), std::back_inserter(obstacle_of_));
  }
  return known;
}

std::vector<model::PairRow> NearPairs::rows_from(std::size_t k, model::TightRows tight,
                                                 const Executor& executor) const {
  const auto append_rows_of = [&](std::size_t i, std::vector<model::PairRow>& rows) {
    append_rows(k + i, motion(pairs_[k + i]), tight, rows);
  };
  return gathered<model::PairRow>(executor, pairs_.size() - k, kBlock, append_rows_of);
}

void NearPairs::append_rows(std::size_t k, double motion, model::TightRows tight,
                            std::vector<model::PairRow>& rows) const {
  append(pairs_[k], obstacle_of_[k], motion, tight, rows);
}

void NearPairs::append_all_rows(marker::PiecePair pair, model::TightRows tight,
                                std::vector<model::PairRow>& rows) const {
  append(pair, obstacles_.of(pair), static_cast<double>(kLatticeLimit), tight, rows);
}

void NearPairs::append(marker::PiecePair pair, const minkowski::Obstacle& obstacle, double motion,
                       model::TightRows tight, std::vector<model::PairRow>& rows) const {
  const Vec r = scene_.relative_position(pair);
  const Coord spacing = scene_.pieces.spacing(pair);
  const RealVec& first = goal_.force[pair.first];
  const RealVec& second = goal_.force[pair.second];
  model::RegionSettings region =
      model::region_within(settings_.tuning.region_reach * motion, spacing, {second.x - first.x, second.y - first.y});
  region.rule = settings_.region;
  if (!goal_.fixes_length()) region.closing = {r.x > 0 ? -1.0 : 1.0, 0};
  const bool every_row = settings_.extent == model::Extent::kWhole;
  const model::RowSettings row{model::ModelUnit{scene_.marker.strip}, tight,
                               every_row ? std::numeric_limits<double>::infinity() : motion};
  append_pair_rows(pair, {obstacle, r, r, spacing}, region, row, rows);
}

}  // namespace selvage::motion::step
