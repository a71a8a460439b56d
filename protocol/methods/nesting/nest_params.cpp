#include "protocol/methods/nesting/nest_params.h"

#include <algorithm>
#include <chrono>
#include <set>

#include "protocol/execution/time_limit.h"
#include "protocol/formats/decimal_marker.h"

namespace selvage::protocol::methods::nesting {
namespace {

constexpr std::uint64_t kStandardMoves = 20'000;

double seconds_of(motion::compaction::Accuracy accuracy) {
  switch (accuracy) {
    case motion::compaction::Accuracy::kDraft: return 2;
    case motion::compaction::Accuracy::kStandard: return 20;
    case motion::compaction::Accuracy::kFine: return 120;
  }
  return 0;
}

}  // namespace

Result<NestBudget> budget_of(const NestEffort& effort) {
  if (effort.accuracy && effort.seconds) {
    return Error{ErrorCode::kOutOfRange,
                 "an accuracy is given, and " + json::number_text(*effort.seconds) +
                     " seconds, too; at most one of them is allowed",
                 "/seconds"};
  }
  const std::optional<double> seconds = effort.accuracy ? std::optional{seconds_of(*effort.accuracy)} : effort.seconds;
  NestBudget budget;
  budget.moves = effort.moves.value_or(seconds ? static_cast<std::uint64_t>(kMostMoves) : kStandardMoves);
  if (seconds) budget.elapsed = execution::elapsed_within(std::chrono::duration<double>{*seconds});
  return budget;
}

calls::StopCause cause_of_end(scene::StopReason reason, bool out_of_time, const calls::MethodContext& context) {
  if (reason == scene::StopReason::kWorkLimit && out_of_time) return calls::StopCause::kDeadline;
  return stop_cause(reason, context);
}

Result<std::map<std::string, double, std::less<>>> values_of(const std::optional<std::vector<PieceValue>>& values,
                                                             const Marker& marker) {
  std::map<std::string, double, std::less<>> by_id;
  if (!values) return by_id;
  std::set<std::string_view> ids;
  for (const auto* pieces : {&marker.pieces, &marker.unplaced}) {
    for (const Piece& piece : *pieces) ids.insert(piece.id);
  }
  const double unit = formats::in_unit(1, marker.resolution);
  for (const PieceValue& value : *values) {
    if (!ids.contains(value.piece.text)) {
      return Error{ErrorCode::kOutOfRange,
                   json::shortened(Json(value.piece.text)) + " is not a piece of this marker; the id of one of its " +
                       std::to_string(ids.size()) + " pieces is allowed",
                   "/values/" + std::to_string(by_id.size()) + "/piece"};
    }
    if (!by_id.emplace(value.piece.text, value.value / (unit * unit)).second) {
      return Error{ErrorCode::kOutOfRange,
                   json::shortened(Json(value.piece.text)) + " is listed twice; every piece is allowed once",
                   "/values/" + std::to_string(by_id.size()) + "/piece"};
    }
  }
  return by_id;
}

}  // namespace selvage::protocol::methods::nesting
