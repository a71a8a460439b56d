// What all motions have in common: the figures that each of them returns, and how a motion becomes a Method.
//
// Each motion is defined in one file: its parameters and its result, each with a descriptor, a function that runs it,
// and one call of motion_method.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/motion/repair/repair.h"
#include "protocol/calls/method.h"
#include "protocol/calls/results.h"

namespace selvage::protocol::calls {

// The result of every motion in rounds, after its own fields.
struct RoundsResult {
  static constexpr std::string_view kGroup = "rounds";
  int rounds{};
  StopCause stop{};

  static void describe(auto& v, auto& self) {
    v.required("rounds", self.rounds, "Number of rounds done.");
    v.required("stop", self.stop, kStopMeaning);
  }
};

// The outcome of a motion.
struct MotionEnd {
  Marker marker;
  motion::repair::Repair repair{};
  bool keep_invalid{};                             // commit even an invalid marker, as the caller requested
  std::shared_ptr<const scene::LaidOut> before{};  // the marker it began with, when the motion laid that out
};
template <class Own>
struct Motion {
  MotionEnd end;
  Own result;  // the motion's own fields
};
// Of a Marker, or of a MarkerFile for the few motions that also read attributes.
template <class Params, class Own, class Start>
using MotionFunction = Result<Motion<Own>> (*)(const Params&, const Start&, const MethodContext&);

// The fields that the result of every motion has in addition to its own.
struct MotionBefore {
  static constexpr std::string_view kGroup = "motion";
  std::string name;
  std::size_t pieces{};
  double length_before{}, length_after{}, utilisation_before{}, utilisation_after{};

  static void describe(auto& v, auto& self) {
    v.required("name", self.name, kNameMeaning);
    v.required("pieces", self.pieces, kPiecesMeaning);
    v.required("lengthBefore", self.length_before, "The marker's length before the motion; exact.");
    v.required("lengthAfter", self.length_after, "Its length after the motion; exact.");
    v.required("utilisationBefore", self.utilisation_before, "0 to 1.");
    v.required("utilisationAfter", self.utilisation_after, "0 to 1.");
  }
};
struct MotionAfter {
  static constexpr std::string_view kGroup = "motion";
  bool valid{};
  Healing healed;
  std::vector<Placement> placements;
  std::optional<StageTimes> ms;
  std::optional<CacheCounts> cache;

  static void describe(auto& v, auto& self) {
    v.required("valid", self.valid, "Whether the result is valid, proved in integers.");
    v.required("healed", self.healed, "The repair of small overlaps in the input.");
    v.required("placements", self.placements, "The new placements of the pieces that moved.");
    v.optional("ms", self.ms, "Milliseconds by stage; only with timing.");
    v.optional("cache", self.cache, "The cache of Minkowski sums; only with timing.");
  }
};
template <class Own>
struct MotionResult {
  AtRevision at;
  MotionBefore before;
  Own own;
  MotionAfter after;

  static void describe(auto& v, auto& self) {
    v.part(self.at);
    v.part(self.before);
    v.part(self.own);
    v.part(self.after);
  }
};

// Proves that the motion's marker is valid and assembles the answer; `own` are the motion's own fields.
[[nodiscard]] MethodAnswer answer_of(const Marker& start, MotionEnd end, const Json& own, bool commit,
                                     const MethodContext& context);

template <class Start>
[[nodiscard]] const Start& start_of(const MarkerFile& file) {
  if constexpr (std::is_same_v<Start, MarkerFile>) {
    return file;
  } else {
    return file.marker;
  }
}

// The method of a motion.  REQUIRES: Params has a CommonParams `call`.
template <class Params, class Own, class Start>
[[nodiscard]] Method motion_method(std::string_view name, MethodKind kind, std::string_view summary,
                                   MotionFunction<Params, Own, Start> work) {
  const auto read = [name, kind, work](const Json& json) -> Result<ParsedCall> {
    Result<Params> wanted = schema::decode<Params>(json);
    if (!wanted) return wanted.error();
    const auto params = std::make_shared<const Params>(*std::move(wanted));
    const auto run = [params, work](const MarkerFile& file, const MethodContext& context) -> Result<MethodAnswer> {
      Result<Motion<Own>> done = work(*params, start_of<Start>(file), context);
      if (!done) return done.error();
      return answer_of(file.marker, std::move(done->end), schema::encode(done->result), params->call.commit, context);
    };
    return ParsedCall{name, kind, params->call, params, run};
  };
  return {name,
          summary,
          kind,
          read,
          &schema::describe<Params>,
          &schema::describe<MotionResult<Own>>,
          &canonical_params<Params>,
          true,
          true};
}

}  // namespace selvage::protocol::calls
