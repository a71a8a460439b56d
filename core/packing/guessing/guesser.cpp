#include "core/packing/guessing/guesser.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace selvage::packing::guessing {
namespace {

using branching::Chosen;
using cells::WedgeRing;

constexpr std::size_t kKept = 3;     // candidates of a move that are improved
constexpr int kSamples = 10;         // random positions in each variant
constexpr double kFirstStep = 0.05;  // of a descent: a part of the range
constexpr double kLastStep = 2e-4;   // the same
constexpr double kShorter = 0.5;     // the next step, after two ways without a gain
constexpr int kTurnRounds = 2;       // in which each body takes its best variant
constexpr int kPatience = 80;        // iterations without a gain
constexpr double kGain = 1e-3;       // the least one: a part of the overlap
constexpr double kLeastRaise = 1.2;  // of the weights of pairs that overlap [GVW25],
constexpr double kLargestRaise = 2;  // and of the pair that overlaps most
constexpr double kDecay = 0.95;      // of other weights

double size_of(const WedgeRing& ring) {
  return std::sqrt(ring.box().width() * ring.box().height());
}

}  // namespace

Guesser::Guesser(const Problem& problem) : problem_{&problem}, bodies_{problem.bodies.size()} {
  for (const branching::Body& body : problem.bodies) {
    first_.push_back(chosen_);
    chosen_ += body.variants.size();
  }
  first_.push_back(chosen_++);
  between_.resize(chosen_ * chosen_);
  for (const auto& [pair, rings] : problem.between) {
    const auto begin = static_cast<std::uint32_t>(rings_.size());
    for (const std::uint32_t ring : rings) rings_.push_back(&problem.rings[ring]);
    const Rings part{begin, static_cast<std::uint32_t>(rings_.size())};
    between_[chosen(pair.first.body, pair.first.variant) * chosen_ + chosen(pair.second.body, pair.second.variant)] =
        part;
  }
  for (const WedgeRing* ring : rings_) {
    boxes_.push_back(ring->box());
    sizes_.push_back(size_of(*ring));
  }
  for (std::uint32_t body = 0; body < bodies_; ++body) {
    for (std::uint32_t variant = 0; variant < problem.bodies[body].variants.size(); ++variant) {
      const Rings fixed = between(chosen_ - 1, chosen(body, variant));
      fixed_.emplace_back(problem.bodies[body].variants[variant].range,
                          std::span{boxes_}.subspan(fixed.first, fixed.end - fixed.first));
    }
  }
  ring_weights_.resize(rings_.size(), 1.0);
  pair_weights_.resize(bodies_ * bodies_, 1.0);
}

double Guesser::part(double low, double high) {
  const double share = static_cast<double>(random_() >> 11) * 0x1p-53;
  return low + share * (high - low);
}

// The part of the way from the ring's border to its centre, times the ring's size: unlike the depth below the line of
// an edge, it changes without leaps from wedge to wedge.
double Guesser::depth(std::uint32_t ring, RealVec way) const {
  if (cells::is_beside(boxes_[ring], way)) return 0;
  const WedgeRing& wedges = *rings_[ring];
  const std::uint32_t wedge = wedges.facing(way);
  const double own = wedges.depth(wedge, way);
  if (own <= 0) return 0;
  return sizes_[ring] * own / std::max(own, wedges.depth(wedge, wedges.centre()));
}

double Guesser::pair_depth(std::size_t a, std::size_t b, RealVec way) const {
  const Rings rings = between(a, b);
  double sum = 0;
  for (std::uint32_t k = rings.first; k < rings.end; ++k) sum += depth(k, way);
  return sum;
}

// Any value of at least `bound` when it is not below that.
double Guesser::loss(std::size_t body, const Placed& placed, double bound) const {
  const std::size_t own = chosen(body, placed.variant);
  double sum = 0;
  const std::uint32_t first = between(chosen_ - 1, own).first;
  for (const std::uint32_t near : fixed_[own].near(placed.at)) {
    const std::uint32_t k = first + near;
    const double found = depth(k, placed.at);
    if (found > 0) sum += ring_weights_[k] * found;
    if (sum >= bound) return sum;
  }
  for (std::size_t other = 0; other < bodies_; ++other) {
    if (other == body) continue;
    const Placed& there = placed_[other];
    const std::size_t theirs = chosen(other, there.variant);
    const double found = other < body ? pair_depth(theirs, own, {placed.at.x - there.at.x, placed.at.y - there.at.y})
                                      : pair_depth(own, theirs, {there.at.x - placed.at.x, there.at.y - placed.at.y});
    if (found > 0) sum += pair_weights_[std::min(body, other) * bodies_ + std::max(body, other)] * found;
    if (sum >= bound) return sum;
  }
  return sum;
}

void Guesser::scatter() {
  placed_.clear();
  for (const branching::Body& body : problem_->bodies) {
    const auto variant = static_cast<std::uint32_t>(random_() % body.variants.size());
    const auto& range = body.variants[variant].range;
    placed_.push_back({{part(range.low_x, range.high_x), part(range.low_y, range.high_y)}, variant});
  }
  std::fill(ring_weights_.begin(), ring_weights_.end(), 1.0);
  std::fill(pair_weights_.begin(), pair_weights_.end(), 1.0);
  least_ = std::numeric_limits<double>::infinity();
  idle_ = 0;
  fresh_ = false;
}

RealVec Guesser::nearest(std::size_t body, std::uint32_t variant, RealVec position) const {
  const auto& range = problem_->bodies[body].variants[variant].range;
  return {std::clamp(position.x, range.low_x, range.high_x), std::clamp(position.y, range.low_y, range.high_y)};
}

void Guesser::begin_at(const std::vector<RealVec>& positions) {
  scatter();
  for (std::size_t body = 0; body < bodies_; ++body) placed_[body] = {nearest(body, 0, positions[body]), 0};
  for (int round = 0; round < kTurnRounds; ++round) {
    for (std::size_t body = 0; body < bodies_; ++body) {
      Candidate best{placed_[body], loss(body, placed_[body], std::numeric_limits<double>::infinity())};
      for (std::uint32_t variant = 0; variant < problem_->bodies[body].variants.size(); ++variant) {
        const Placed turned{nearest(body, variant, positions[body]), variant};
        const double found = loss(body, turned, best.loss);
        if (found < best.loss) best = {turned, found};
      }
      placed_[body] = best.placed;
    }
  }
}

void Guesser::keep(const Candidate& candidate) {
  const auto worse = std::ranges::upper_bound(candidates_, candidate.loss, {}, &Candidate::loss);
  candidates_.insert(worse, candidate);
  if (candidates_.size() > kKept) candidates_.pop_back();
}

void Guesser::sample(std::size_t body, const Candidate& now) {
  candidates_.assign(1, now);
  const auto& variants = problem_->bodies[body].variants;
  for (std::uint32_t variant = 0; variant < variants.size(); ++variant) {
    const auto& range = variants[variant].range;
    for (int k = 0; k < kSamples; ++k) {
      const Placed placed{{part(range.low_x, range.high_x), part(range.low_y, range.high_y)}, variant};
      const double bound =
          candidates_.size() < kKept ? std::numeric_limits<double>::infinity() : candidates_.back().loss;
      const double found = loss(body, placed, bound);
      if (found < bound) keep({placed, found});
    }
  }
}

Guesser::Candidate Guesser::descended(std::size_t body, Candidate from) {
  constexpr double kDiagonal = 0.7071067811865476;
  constexpr RealVec kWays[]{{1, 0}, {0, 1}, {kDiagonal, kDiagonal}, {kDiagonal, -kDiagonal}};
  const auto& range = problem_->bodies[body].variants[from.placed.variant].range;
  const double extent = std::max({range.width(), range.height(), 1.0});
  double step = kFirstStep * extent;
  std::size_t way = random_() % 4;
  int failures = 0;
  while (from.loss > 0 && step > kLastStep * extent) {
    bool better = false;
    for (const double sign : {step, -step}) {
      Placed next = from.placed;
      next.at = nearest(body, next.variant, {next.at.x + sign * kWays[way].x, next.at.y + sign * kWays[way].y});
      const double found = loss(body, next, from.loss);
      if (found >= from.loss) continue;
      from = {next, found};
      better = true;
      break;
    }
    if (better) {
      failures = 0;
      continue;
    }
    way = (way + 1) % 4;
    if (++failures % 2 == 0) step *= kShorter;
  }
  return from;
}

void Guesser::move(std::size_t body) {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  const Candidate now{placed_[body], loss(body, placed_[body], kAny)};
  if (now.loss <= 0) return;
  sample(body, now);
  Candidate best{placed_[body], kAny};
  for (const Candidate& candidate : std::vector<Candidate>{candidates_}) {
    const Candidate reached = descended(body, candidate);
    if (reached.loss < best.loss) best = reached;
  }
  placed_[body] = best.placed;
}

double Guesser::raise_weights() {
  struct Overlap {
    double* weight;
    double depth;
  };
  std::vector<Overlap> found;
  double sum = 0;
  double deepest = 0;
  const auto take = [&](double& weight, double depth) {
    found.push_back({&weight, depth});
    sum += depth;
    deepest = std::max(deepest, depth);
  };
  for (std::size_t body = 0; body < bodies_; ++body) {
    const std::size_t own = chosen(body, placed_[body].variant);
    const Rings fixed = between(chosen_ - 1, own);
    for (std::uint32_t k = fixed.first; k < fixed.end; ++k) {
      take(ring_weights_[k], depth(k, placed_[body].at));
    }
    for (std::size_t other = body + 1; other < bodies_; ++other) {
      const RealVec way{placed_[other].at.x - placed_[body].at.x, placed_[other].at.y - placed_[body].at.y};
      take(pair_weights_[body * bodies_ + other], pair_depth(own, chosen(other, placed_[other].variant), way));
    }
  }
  for (const Overlap& overlap : found) {
    *overlap.weight = overlap.depth > 0
                          ? *overlap.weight * (kLeastRaise + (kLargestRaise - kLeastRaise) * overlap.depth / deepest)
                          : std::max(1.0, *overlap.weight * kDecay);
  }
  return sum;
}

// Bodies of one kind change places until they are in the order that the search keeps them in.
Guess Guesser::in_order(std::vector<Placed> placed) const {
  for (std::size_t body = 0; body < bodies_; ++body) {
    for (std::size_t other = body + 1; other < bodies_; ++other) {
      const bool alike = problem_->bodies[other].kind == problem_->bodies[body].kind;
      const auto rank = [&](const Placed& one) {
        const bool by_y = problem_->is_ordered_by_y(static_cast<std::uint32_t>(body), one.variant);
        return std::tuple{one.variant, by_y ? one.at.y : one.at.x, by_y ? one.at.x : one.at.y};
      };
      if (alike && rank(placed[other]) < rank(placed[body])) std::swap(placed[other], placed[body]);
    }
  }
  Guess guess;
  for (const Placed& one : placed) {
    guess.positions.push_back(one.at);
    guess.variant.push_back(one.variant);
  }
  return guess;
}

Guess Guesser::next(std::int64_t& moves, const std::stop_token& stop) {
  if (fresh_) scatter();
  std::vector<std::size_t> order(bodies_);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<Placed> best = placed_;
  double overlap = std::numeric_limits<double>::infinity();
  while (moves > 0 && overlap > 0 && idle_ < kPatience && !stop.stop_requested()) {
    for (std::size_t k = bodies_; k > 1; --k) std::swap(order[k - 1], order[random_() % k]);
    for (const std::size_t body : order) move(body);
    moves -= static_cast<std::int64_t>(bodies_);
    const double sum = raise_weights();
    ++idle_;
    if (sum < overlap) {
      overlap = sum;
      best = placed_;
    }
    if (sum < least_ * (1 - kGain)) {
      least_ = sum;
      idle_ = 0;
    }
  }
  fresh_ = idle_ >= kPatience || overlap <= 0;
  return in_order(std::move(best));
}

}  // namespace selvage::packing::guessing
