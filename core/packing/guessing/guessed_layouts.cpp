#include "core/packing/guessing/guessed_layouts.h"

#include <algorithm>
#include <utility>

#include "core/geometry/lattice.h"
#include "core/packing/branching/search.h"

namespace selvage::packing::guessing {
namespace {

constexpr std::uint64_t kFirstNodes = 300;  // most searches are over before
constexpr std::int64_t kMovesOfANode = 1;   // these take less than half as long as the node
constexpr int kStarts = 4;                  // guesses that begin at given positions
constexpr std::int64_t kMovesOfAStart = 100;
constexpr double kReach = 0.05;           // a part of the largest range
constexpr std::uint64_t kNodesNear = 32;  // of the search near a guess

}  // namespace

GuessedLayouts::GuessedLayouts(const Problem& problem, const branching::SearchTuning& tuning,
                               branching::PlaceLeaf place_leaf, std::stop_token stop)
    : problem_{&problem}, tuning_{tuning}, place_leaf_{std::move(place_leaf)}, stop_{std::move(stop)} {
  for (const branching::Body& body : problem.bodies) {
    for (const branching::BodyVariant& variant : body.variants) {
      reach_ = std::max({reach_, kReach * variant.range.width(), kReach * variant.range.height()});
    }
  }
}

// With a guesser of its own, so that the guesses at the pace of the search stay as they are.
bool GuessedLayouts::begin_at(const std::vector<RealVec>& positions) {
  Guesser guesser{*problem_};
  guesser.begin_at(positions);
  for (int start = 0; start < kStarts && !found_ && !stop_.stop_requested(); ++start) {
    std::int64_t moves = kMovesOfAStart;
    found_ = near(guesser.next(moves, stop_), work_);
  }
  return found_.has_value();
}

std::optional<branching::Leaf> GuessedLayouts::next(branching::Work& work) {
  work += std::exchange(work_, {});
  if (found_) return std::exchange(found_, std::nullopt);
  if (work.nodes < kFirstNodes) return std::nullopt;
  if (!guesser_) guesser_.emplace(*problem_);
  std::int64_t moves = kMovesOfANode * static_cast<std::int64_t>(work.nodes - paid_);
  while (moves > 0 && !stop_.stop_requested()) {
    if (auto layout = near(guesser_->next(moves, stop_), work)) return layout;
  }
  paid_ = work.nodes;
  return std::nullopt;
}

std::optional<branching::Leaf> GuessedLayouts::near(Guess guess, branching::Work& work) const {
  const branching::Vicinity vicinity{std::move(guess.positions), std::move(guess.variant), reach_};
  std::optional<branching::Leaf> found;
  branching::SearchCalls calls;
  calls.place_leaf = place_leaf_;
  calls.on_leaf = [&](const branching::Leaf& leaf) { found = leaf; };
  calls.stop = stop_;
  constexpr auto kAnyLength = static_cast<double>(kLatticeLimit);
  const auto outcome = branching::search(*problem_, kAnyLength, 0, {.nodes = kNodesNear}, tuning_, calls, &vicinity);
  work += outcome.work;
  return found;
}

}  // namespace selvage::packing::guessing
