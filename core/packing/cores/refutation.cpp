#include "core/packing/cores/refutation.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "core/geometry/lattice.h"
#include "core/packing/cores/coarsening.h"

namespace selvage::packing::cores {
namespace {

using branching::SearchEnd;

constexpr std::array kShares{0.9, 0.92, 0.95};  // of a piece's area that its core has; from small cores to large ones
constexpr std::uint64_t kFirstNodes = 300;      // most searches are over before
constexpr std::uint64_t kNodesOfANode = 4;      // of the search for the pieces, from then on
constexpr std::uint64_t kMostNodes = 500;       // of all searches for cores
constexpr auto kAnyLength = static_cast<double>(kLatticeLimit);

branching::SearchCalls calls_of(const scene::Run& run, std::vector<RealVec>& found) {
  branching::SearchCalls calls;
  calls.place_leaf = [](branching::Leaf&) { return true; };  // a layout up to rounding is as good as one
  calls.on_leaf = [&found](const branching::Leaf& leaf) { found = leaf.positions; };
  calls.stop = run.stop;
  calls.executor = run.executor;
  return calls;
}

}  // namespace

Refutation::Level::Level(const Marker& marker, const Refutation& refutation)
    : bodies{bodies_of(marker, refutation.freedom_, refutation.run_)},
      search{bodies.problem, kAnyLength, 0, refutation.tuning_, calls_of(refutation.run_, found)} {}

Refutation::Refutation(const Marker& marker, const bodies::Freedom& freedom, const branching::SearchTuning& tuning,
                       const scene::Run& run, OnCores on_cores)
    : marker_{marker}, freedom_{freedom}, tuning_{tuning}, run_{run}, on_cores_{std::move(on_cores)} {}

bool Refutation::begin() {
  while (next_share_ < kShares.size() && !run_.stopped()) {
    auto cores = coarsened(marker_, freedom_.moving, freedom_.turns, kShares[next_share_++], run_.stop);
    if (!cores || cores == cores_) continue;
    cores_ = std::move(cores);
    level_.emplace(*cores_, *this);
    if (level_->bodies.complete) return true;
    level_.reset();
  }
  return false;
}

bool Refutation::next(const branching::Work& searched, branching::Work& own) {
  if (searched.nodes < kFirstNodes) return false;
  const std::uint64_t due = std::min(kMostNodes, kNodesOfANode * (searched.nodes - kFirstNodes));
  while (own.nodes < due && !run_.stopped()) {
    if (!level_ && !begin()) break;
    const auto outcome = level_->search.run({.nodes = due - finished_.nodes});
    own = finished_;
    own += outcome.work;
    if (outcome.end == SearchEnd::kExhausted && !outcome.undecided) return true;
    if (outcome.end != SearchEnd::kAnswered) break;
    finished_ = own;
    const bool ends = on_cores_(level_->found);
    level_.reset();
    if (ends) break;
  }
  return false;
}

}  // namespace selvage::packing::cores
