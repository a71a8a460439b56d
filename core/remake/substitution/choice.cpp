#include "core/remake/substitution/choice.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/matching/signature.h"
#include "core/remake/substitution/area.h"

namespace selvage::remake::substitution {
namespace {

// The most slots with which the order's pieces can be compared.  The comparisons of all ways in which its shapes may
// lie count as well, as if no two slots were alike.
std::size_t most_slots(const Marker& order, std::size_t most_compared) {
  std::size_t ways = 0;
  for (const Shape& shape : order.shapes) ways += matching::orientations_of(shape, {}).size();
  return most_compared / std::max({std::size_t{1}, ways, order.pieces.size() + order.unplaced.size()});
}

// Stored markers in a unit, width and spacing like the order's.
std::vector<Arrangement> comparable(const Marker& order, std::span<const matching::LabelledMarker> stored,
                                    const std::stop_token& stop) {
  const matching::Signature wanted = matching::signature_of(order);
  std::vector<Arrangement> arrangements;
  for (std::size_t k = 0; k < stored.size() && !stop.stop_requested(); ++k) {
    const Marker& marker = stored[k].marker;
    if (marker.pieces.empty() || !std::isfinite(distance_between(wanted, matching::signature_of(marker)))) continue;
    if (auto arrangement = arrangement_of(stored[k], k, order.resolution)) {
      arrangements.push_back(*std::move(arrangement));
    }
  }
  return arrangements;
}

}  // namespace

std::vector<Candidate> candidates_for(const matching::LabelledMarker& labelled,
                                      std::span<const matching::LabelledMarker> stored, bool concatenate,
                                      const RemakeTuning& tuning, const Executor& executor,
                                      const std::stop_token& stop) {
  const Marker& order = labelled.marker;
  const double area = whole_area(order);
  const auto as_large = [&](double stored_area) {
    return stored_area >= tuning.least_area * area && stored_area <= tuning.most_area * area;
  };
  const std::size_t most = most_slots(order, tuning.most_compared);
  const std::vector<Arrangement> parts = comparable(order, stored, stop);
  std::vector<Candidate> candidates;
  for (const Arrangement& part : parts) {
    if (as_large(part.area) && part.slots.size() <= most) candidates.push_back({part, {}, 0, 0, 0});
  }
  for (std::size_t first = 0; concatenate && first < parts.size(); ++first) {
    for (std::size_t second = first; second < parts.size(); ++second) {
      if (stop.stop_requested()) return {};
      if (!as_large(parts[first].area + parts[second].area)) continue;
      if (parts[first].slots.size() + parts[second].slots.size() > most) continue;
      if (auto both = concatenated(parts[first], parts[second])) candidates.push_back({*std::move(both), {}, 0, 0, 0});
    }
  }
  const auto width = static_cast<double>(order.strip.room(0).height());
  executor.for_each(candidates.size(), [&](std::size_t k) {
    if (stop.stop_requested()) return;
    Candidate& candidate = candidates[k];
    const Arrangement& arrangement = candidate.arrangement;
    candidate.pairing = matching::pair_pieces(labelled, arrangement.slots, tuning.labels, stop);
    candidate.difference = candidate.pairing.difference / area;
    candidate.used = arrangement.area / width / static_cast<double>(arrangement.length);
    const double smaller = std::min(1.0, area / arrangement.area);  // a smaller order leaves cloth unused
    candidate.predicted = candidate.used * (1 + smaller) / 2 - tuning.difference_price * candidate.difference;
  });
  if (stop.stop_requested()) return {};
  std::erase_if(candidates, [&](const Candidate& candidate) { return candidate.difference > tuning.farthest; });
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.predicted > b.predicted; });
  return candidates;
}

}  // namespace selvage::remake::substitution
