// The typed parameters and results of every method.  Their JSON is in codec.h; every field is explained in
// README.md.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/marker/validity.h"
#include "core/minkowski/cache.h"
#include "core/motion/compact.h"
#include "protocol/formats/format.h"
#include "protocol/stage_times.h"

namespace selvage {

using Revision = std::uint64_t;  // 1 when a marker is opened, one more with every change

// engine.info {}
struct EngineInfo {
  std::string version;
  int workers{};
  std::size_t markers{};  // open
  std::size_t max_request_bytes{};
  CacheCounts cache;
};

// marker.open {"marker": document, "spacing"?}
struct MarkerOpen {
  MarkerFile file;  // with the spacing applied
};
struct MarkerOpened {
  std::string marker_id;
  Revision revision{};
  std::size_t pieces{};
  double length{};  // in the marker's unit
  double utilisation{};
  bool valid{};
  std::vector<Note> notes;
};

// marker.get {"markerId", "format"?}
struct MarkerGet {
  std::string marker_id;
  Format format{Format::kNative};
};
struct MarkerGot {
  std::string marker_id;
  Revision revision{};
  Format format{};
  Json document;  // an object; for svg a string
};

// marker.check {"markerId"}
struct MarkerCheck {
  std::string marker_id;
};
struct MarkerChecked {
  std::string marker_id;
  Revision revision{};
  Json validity;  // what validity_json says
};

// marker.close {"markerId"}
struct MarkerClose {
  std::string marker_id;
};
struct MarkerClosed {
  std::string marker_id;
};

// motion.compact {"markerId", "baseRev"?, "accuracy"?, "rounds"?, "commit"?, "timing"?}
struct MotionCompact {
  std::string marker_id;
  std::optional<Revision> base_revision;  // refuse when the marker is at another
  Accuracy accuracy{Accuracy::kStandard};
  std::optional<int> rounds;  // instead of the accuracy's own limit
  bool commit{true};          // false: answer, but leave the marker as it is
  bool timing{};              // answer with the times and the cache's counts, which vary from run to run
};
// The figures of one compaction; what `selvage compact --json` prints and motion.compact answers.  Lengths
// are in the marker's unit, exact; `times` and `cache` vary from run to run, all else is the same for the
// same input.
struct CompactionFigures {
  std::string name;
  std::size_t pieces{};
  double length_before{}, length_after{};
  double utilisation_before{}, utilisation_after{};
  int rounds{};
  StopReason stop{};
  bool valid{};  // what is_valid said of the result
  std::size_t healed_pairs{}, healed_protruding{};
  double healed_deepest{}, healed_farthest_move{}, healed_lengthened{};
  StageTimes times;
  CacheCounts cache;
};
struct MotionCompacted {
  std::string marker_id;
  Revision revision{};  // the marker's, after it
  CompactionFigures figures;
  Json placements;    // of the pieces that moved: changed_placements
  bool timing{true};  // tell figures.times and figures.cache
};

// The figures of a finished compaction; proves the result with is_valid.
[[nodiscard]] CompactionFigures figures_of(const Compaction& compaction, const StageTimes& times,
                                           const CacheCounts& cache);
[[nodiscard]] CompactionSettings settings_of(Accuracy accuracy, std::optional<int> rounds);

inline constexpr int kMaxRounds = 100'000;
inline constexpr std::string_view kAccuracyNames[] = {"draft", "standard", "fine"};         // by Accuracy
inline constexpr std::string_view kStopNames[] = {"converged", "work_limit", "cancelled",
                                                  "solver_failed"};  // by StopReason
[[nodiscard]] std::string_view name_of(StopReason reason);

}  // namespace selvage
