// Parameters that the calls of many methods share.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/motion/compaction/compact.h"
#include "protocol/calls/choices.h"
#include "protocol/calls/values.h"
#include "protocol/schema/visitors.h"

namespace selvage::protocol::calls {

using Revision = std::uint64_t;  // 1 when a marker is opened, increased by one with every change

inline constexpr schema::Limits kRevisions{.range = {{1, 9007199254740992.0}}};  // to 2^53: exact in every client
inline constexpr schema::Limits kOpIds{.bytes = {{1, 128}}};
inline constexpr double kMostSeed = 9007199254740991.0;  // 2^53 - 1: JSON numbers are exact up to it
inline constexpr schema::Limits kDeadlines{.range = {{1, 24.0 * 3'600'000}}};  // milliseconds
inline constexpr int kMaxRounds = 100'000;
inline constexpr double kMostSimplification = 1;
inline constexpr schema::Limits kRoundLimits{.range = {{0, kMaxRounds}}};

inline constexpr std::string_view kMarkerIdMeaning = "The marker's id.";
inline constexpr std::string_view kBaseRevisionMeaning = "Refuse the call when the marker is at another revision.";
inline constexpr std::string_view kOpIdMeaning =
    "A name for this call; a retry with the same name gets the same result.";
inline constexpr std::string_view kReadDeadlineMeaning =
    "After this many milliseconds the call is refused if it has no result; 1 to 86,400,000.";

// Parameters of every motion.  The server handles revisions, retries, deadlines and progress.
struct CommonParams {
  static constexpr std::string_view kGroup = "call";

  std::string marker_id;
  std::optional<Revision> base_revision;        // refuse the call if the marker is at another revision
  bool commit{true};                            // false: return the result without changing the marker
  bool timing{};                                // also return times and cache counts, which vary from run to run
  std::optional<std::string> op_id;             // the client's name for the call
  std::optional<double> deadline_ms;            // from the call's arrival
  std::optional<ProgressToken> progress_token;  // absent: no progress notifications

  static void describe(auto& v, auto& self) {
    v.required("markerId", self.marker_id, kMarkerIdMeaning);
    v.optional("baseRev", self.base_revision, kBaseRevisionMeaning, kRevisions);
    v.optional("commit", self.commit, "False: return the result without changing the marker.");
    v.optional("timing", self.timing, "True: also return ms and cache, which vary from run to run.");
    v.optional("opId", self.op_id, kOpIdMeaning, kOpIds);
    v.optional("deadlineMs", self.deadline_ms,
               "After this many milliseconds the motion returns its best result so far; 1 to 86,400,000.", kDeadlines);
    v.optional("progressToken", self.progress_token, "Progress notifications, one after each round, carry this token.");
  }
};

// Parameters of every motion that works in rounds.
struct Effort {
  static constexpr std::string_view kGroup = "effort";

  motion::compaction::Accuracy accuracy{motion::compaction::Accuracy::kStandard};
  std::optional<int> rounds;             // instead of the accuracy's own limit
  std::optional<double> simplification;  // instead of the accuracy's own; a fraction of the strip's width

  static void describe(auto& v, auto& self) {
    v.optional("accuracy", self.accuracy, "How much work to invest; standard when absent.");
    v.optional("rounds", self.rounds, kRoundsMeaning, kRoundLimits);
    v.optional(
        "simplification", self.simplification,
        "Pairs farther apart than this fraction of the width are modelled by simplified enclosing outlines, 0 to "
        "1; 0 when absent.",
        {.range = {{0, kMostSimplification}}});
  }
  static constexpr std::string_view kRoundsMeaning = "Maximum number of rounds, 0 to 100,000.";
};
[[nodiscard]] motion::compaction::CompactionSettings settings_of(const Effort& effort);

}  // namespace selvage::protocol::calls

// Also declared in the namespace selvage, so that every folder may use the name unqualified.
namespace selvage {
using protocol::calls::Revision;
}  // namespace selvage
