#include "core/remake/substitution/columns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace selvage::remake::substitution {
namespace {

constexpr double kNotAbove = -std::numeric_limits<double>::infinity();

}  // namespace

void Columns::set(std::size_t piece, const Polygon& placed) {
  const Box box = box_of(placed);
  Profile profile;
  profile.lowest = static_cast<double>(box.low.y);
  profile.highest = static_cast<double>(box.high.y);
  profile.first = std::llround(std::ceil(static_cast<double>(box.low.x) / sampling_.cell));
  const std::int64_t last = std::llround(std::floor(static_cast<double>(box.high.x) / sampling_.cell));
  const auto count = static_cast<std::size_t>(std::max<std::int64_t>(0, last - profile.first + 1));
  profile.low.assign(count, std::numeric_limits<double>::infinity());
  profile.high.assign(count, -std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < placed.size(); ++k) {
    Vec a = placed[k];
    Vec b = placed[(k + 1) % placed.size()];
    if (a.x > b.x) std::swap(a, b);
    if (a.x == b.x) continue;
    const double slope = static_cast<double>(b.y - a.y) / static_cast<double>(b.x - a.x);
    const std::int64_t from = std::llround(std::ceil(static_cast<double>(a.x) / sampling_.cell));
    const std::int64_t to = std::llround(std::floor(static_cast<double>(b.x) / sampling_.cell));
    for (std::int64_t sample = from; sample <= to; ++sample) {
      const double y =
          static_cast<double>(a.y) + slope * (static_cast<double>(sample) * sampling_.cell - static_cast<double>(a.x));
      const auto index = static_cast<std::size_t>(sample - profile.first);
      profile.low[index] = std::min(profile.low[index], y);
      profile.high[index] = std::max(profile.high[index], y);
    }
  }
  if (piece >= profiles_.size()) {
    profiles_.resize(piece + 1);
    demands_.resize(piece + 1);
  }
  profiles_[piece] = std::move(profile);
  for (std::size_t other = 0; other < profiles_.size(); ++other) {
    if (other == piece) continue;
    set_demand(piece, other, demand(profiles_[piece], profiles_[other]));
    set_demand(other, piece, demand(profiles_[other], profiles_[piece]));
  }
}

double Columns::demand(const Profile& lower, const Profile& upper) const {
  const std::int64_t from = std::max(lower.first, upper.first);
  const std::int64_t to = std::min(lower.first + static_cast<std::int64_t>(lower.low.size()),
                                   upper.first + static_cast<std::int64_t>(upper.low.size()));
  if (from >= to || static_cast<double>(to - from - 1) * sampling_.cell < sampling_.slip) return kNotAbove;
  double by = kNotAbove;
  double higher = 0;
  for (std::int64_t sample = from; sample < to; ++sample) {
    const auto p = static_cast<std::size_t>(sample - lower.first);
    const auto q = static_cast<std::size_t>(sample - upper.first);
    by = std::max(by, lower.high[p] - upper.low[q]);
    higher += upper.low[q] + upper.high[q] - lower.low[p] - lower.high[p];
  }
  return higher > 0 ? by + static_cast<double>(spacing_) : kNotAbove;
}

void Columns::set_demand(std::size_t lower, std::size_t upper, double demand) {
  std::vector<Demand>& demands = demands_[upper];
  const auto at = std::ranges::lower_bound(demands, lower, {}, &Demand::lower);
  const bool known = at != demands.end() && at->lower == lower;
  if (demand == kNotAbove) {
    if (known) demands.erase(at);
  } else if (known) {
    at->by = demand;
  } else {
    demands.insert(at, {lower, demand});
  }
}

Columns::Excess Columns::excess() const {
  const std::size_t count = profiles_.size();
  std::vector<std::size_t> upwards(count);
  std::iota(upwards.begin(), upwards.end(), std::size_t{0});
  std::stable_sort(upwards.begin(), upwards.end(), [this](std::size_t a, std::size_t b) {
    return profiles_[a].lowest + profiles_[a].highest < profiles_[b].lowest + profiles_[b].highest;
  });
  std::vector<std::size_t> rank(count);
  for (std::size_t k = 0; k < count; ++k) rank[upwards[k]] = k;
  std::vector<double> raised(count);  // how far each piece must move up at least
  std::vector<std::size_t> under(count, count);
  const auto bottom = static_cast<double>(strip_.margin);
  const auto top = static_cast<double>(strip_.width - strip_.margin);
  Excess excess;
  double longest = 0;
  std::size_t last = count;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t upper = upwards[k];
    raised[upper] = bottom - profiles_[upper].lowest;
    for (const auto& [lower, by] : demands_[upper]) {
      if (rank[lower] > k) continue;
      const double at_least = raised[lower] + by;
      const bool first = at_least == raised[upper] && under[upper] < count && rank[lower] < rank[under[upper]];
      if (at_least < raised[upper] || (at_least == raised[upper] && !first)) continue;
      raised[upper] = at_least;
      under[upper] = lower;
    }
    const double beyond = raised[upper] + profiles_[upper].highest - top;
    if (beyond <= 0) continue;
    excess.total += beyond;
    if (beyond <= longest) continue;
    longest = beyond;
    last = upper;
  }
  for (; last < count; last = under[last]) excess.longest.push_back(last);
  std::reverse(excess.longest.begin(), excess.longest.end());
  return excess;
}

}  // namespace selvage::remake::substitution
