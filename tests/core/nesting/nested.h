// Nesting, as its tests call it.
#pragma once

#include <set>
#include <stdexcept>
#include <string>

#include "core/base/executor.h"
#include "core/nesting/nest.h"

namespace selvage::test {

// Epochs and shares of a race are so short that a search of few moves has several of each.
[[nodiscard]] inline nesting::NestSettings settings_of(std::uint64_t moves) {
  nesting::NestSettings settings;
  settings.moves = moves;
  settings.tuning.first_epoch = 40;
  settings.tuning.raced_moves = 50;
  return settings;
}

// REQUIRES: the marker can be nested.
[[nodiscard]] inline nesting::Nesting nested(const Marker& marker, const nesting::NestSettings& settings,
                                             const Executor& executor = serial()) {
  SumCache sums;
  auto done = nest(marker, settings, {sums, {}, {}, &executor});
  if (!done) throw std::runtime_error{done.error().message};
  return *std::move(done);
}

// Of all its pieces, whether they lie or not.
[[nodiscard]] inline std::multiset<std::string> ids_of(const Marker& marker) {
  std::multiset<std::string> ids;
  for (const auto* pieces : {&marker.pieces, &marker.unplaced}) {
    for (const Piece& piece : *pieces) ids.insert(piece.id);
  }
  return ids;
}

}  // namespace selvage::test
