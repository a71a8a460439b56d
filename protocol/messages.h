// The typed parameters of every method, and the results of those that are not in marker_methods.h.  Their
// JSON is in codec.h; every field is explained in README.md.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
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
  std::vector<std::string_view> methods;
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

// marker.check {"markerId"}
struct MarkerCheck {
  std::string marker_id;
};

// marker.close {"markerId"}
struct MarkerClose {
  std::string marker_id;
};
struct MarkerClosed {
  std::string marker_id;
};

// What every motion takes: {"markerId", "baseRev"?, "commit"?, "timing"?}
struct MotionCall {
  std::string marker_id;
  std::optional<Revision> base_revision;  // refuse when the marker is at another
  bool commit{true};                      // false: answer, but leave the marker as it is
  bool timing{};                          // answer with the times and the cache's counts, which vary from run to run
};
// What every motion in rounds takes: {"accuracy"?, "rounds"?}
struct Effort {
  Accuracy accuracy{Accuracy::kStandard};
  std::optional<int> rounds;  // instead of the accuracy's own limit
};
// [x, y]: where to, never (0, 0).
struct Direction {
  double x{}, y{};
};

// motion.compact
struct MotionCompact {
  MotionCall call;
  Effort effort;
};
// motion.push {"forces": [{"piece", "force"}]}
struct MotionPush {
  MotionCall call;
  Effort effort;
  std::vector<std::pair<std::string, Direction>> forces;  // a piece's id, and the force on it
};
// motion.gravity {"force"}
struct MotionGravity {
  MotionCall call;
  Effort effort;
  Direction force;
};
// motion.bump {"piece", "direction"}
struct MotionBump {
  MotionCall call;
  std::string piece;
  Direction direction;
};

[[nodiscard]] CompactionSettings settings_of(const Effort& effort);

inline constexpr std::size_t kMaxForces = 100'000;
inline constexpr double kLargestForce = 1e9, kLeastForce = 1e-9;  // of either coordinate; of the larger one
inline constexpr int kMaxRounds = 100'000;
inline constexpr std::string_view kAccuracyNames[] = {"draft", "standard", "fine"};  // by Accuracy
inline constexpr std::string_view kStopNames[] = {"converged", "work_limit", "cancelled",
                                                  "solver_failed"};  // by StopReason
[[nodiscard]] std::string_view name_of(StopReason reason);

}  // namespace selvage
