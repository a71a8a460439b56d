// Results that many methods share, and how they are made from the core's values.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/marker/validity.h"
#include "core/minkowski/cache.h"
#include "core/motion/repair/repair.h"
#include "protocol/calls/choices.h"
#include "protocol/calls/params.h"
#include "protocol/calls/values.h"
#include "protocol/execution/stage_times.h"
#include "protocol/schema/visitors.h"

namespace selvage::protocol::calls {

inline constexpr std::string_view kRevisionMeaning = "The marker's revision.";
inline constexpr std::string_view kNameMeaning = "The marker's name.";
inline constexpr std::string_view kPiecesMeaning = "Number of pieces, not counting zones.";
inline constexpr std::string_view kUnplacedMeaning =
    "Number of pieces that do not lie on the cloth; absent when there are none.";
inline constexpr std::string_view kLengthMeaning = "The x coordinate where the rightmost piece ends; exact.";
inline constexpr std::string_view kUtilisationMeaning = "The pieces' area divided by width times length, 0 to 1.";
inline constexpr std::string_view kValidMeaning =
    "Proved in integers: no overlap beyond the allowances, no distance below the spacing, nothing outside the strip, "
    "and no rule broken.";
inline constexpr std::string_view kStopMeaning = "Why the motion ended.";
inline constexpr std::string_view kPieceMeaning = "The piece's id.";

// The marker and the revision that a result belongs to.
struct AtRevision {
  std::string marker_id;
  Revision revision{};

  static void describe(auto& v, auto& self) {
    v.required("markerId", self.marker_id, kMarkerIdMeaning);
    v.required("revision", self.revision, kRevisionMeaning);
  }
};

struct Note {
  static constexpr std::string_view kName = "Note", kMeaning = "A repair made while reading, or what a format loses.";
  std::string field, text;

  static void describe(auto& v, auto& self) {
    v.required("field", self.field, "A JSON pointer into the parameters; empty for the whole marker.");
    v.required("text", self.text, "What was repaired, rounded, read differently than written or lost.");
  }
};
[[nodiscard]] std::vector<Note> notes_of(const std::vector<selvage::Note>& notes);

struct Placement {
  static constexpr std::string_view kName = "Placement", kMeaning = "The position and orientation of a piece.";
  std::string id;
  Point at;
  double rotation{};
  bool flip{};
  double tilt{};

  static void describe(auto& v, auto& self) {
    v.required("id", self.id, kPieceMeaning);
    v.required("at", self.at, "The position of the shape's origin.");
    v.required("rotation", self.rotation, "Degrees, counter-clockwise.");
    v.required("flip", self.flip, "Whether the piece is mirrored.");
    v.required("tilt", self.tilt, "Degrees, added to the rotation.");
  }
};
// The number as it appears in messages, where it is absent when all pieces are placed.
[[nodiscard]] inline std::optional<std::size_t> unplaced_count(const Marker& marker) {
  return marker.unplaced.empty() ? std::nullopt : std::optional{marker.unplaced.size()};
}

// The pieces whose placement differs, or that are new.  Pieces that were removed are not listed.  REQUIRES: pieces in
// the same order.
[[nodiscard]] std::vector<Placement> changed_placements(const Marker& before, const Marker& after);

struct Overlap {
  static constexpr std::string_view kName = "Overlap", kMeaning = "Two pieces that overlap or are too close.";
  std::string first, second;
  Point witness;
  double depth{};

  static void describe(auto& v, auto& self) {
    v.required("first", self.first, kPieceMeaning);
    v.required("second", self.second, "The other piece's id.");
    v.required("witness", self.witness, "A point inside both pieces.");
    v.required("depth", self.depth,
               "The length of the shortest move that separates them as far as spacing or overlap allowance demand; 0 "
               "when not measured because the motion was stopped.");
  }
};
[[nodiscard]] std::vector<Overlap> overlaps_of(const Marker& marker, const std::vector<marker::Overlap>& overlaps);

struct Protrusion {
  static constexpr std::string_view
      kName = "Protrusion",
      kMeaning = "A piece that extends beyond the strip, or beyond the room that its rules leave it.";
  std::string piece;
  double by{};

  static void describe(auto& v, auto& self) {
    v.required("piece", self.piece, kPieceMeaning);
    v.required("by", self.by, "How far it extends beyond that.");
  }
};
[[nodiscard]] std::vector<Protrusion> protrusions_of(const Marker& marker,
                                                     const std::vector<marker::Protrusion>& protrusions);

struct Healing {
  static constexpr std::string_view kName = "Healing", kMeaning = "The repair of small overlaps in the input.";
  std::size_t pairs{}, protruding{};
  double deepest{}, farthest_move{}, lengthened{};

  static void describe(auto& v, auto& self) {
    v.required("pairs", self.pairs, "Number of pairs that overlapped.");
    v.required("protruding", self.protruding, "Number of pieces that extended beyond the strip.");
    v.required("deepest", self.deepest, "Depth of the deepest overlap.");
    v.required("farthestMove", self.farthest_move, "The longest move of a piece.");
    v.required("lengthened", self.lengthened, "By how much the repair made the marker longer.");
  }
};
[[nodiscard]] Healing healing_of(const motion::repair::Repair& repair, Resolution resolution);

struct StageTimes {
  static constexpr std::string_view kName = "StageTimes", kMeaning = "Milliseconds by stage.";
  double decomposition{}, sums{}, rows{}, solve{}, verify{}, total{};

  static void describe(auto& v, auto& self) {
    v.required("decomposition", self.decomposition, "Decomposing new outlines into star-shaped parts.");
    v.required("sums", self.sums, "Computing Minkowski sums.");
    v.required("rows", self.rows, "Building linear programs.");
    v.required("solve", self.solve, "Solving them.");
    v.required("verify", self.verify, "Proving the result.");
    v.required("total", self.total, "The whole motion.");
  }
};
[[nodiscard]] StageTimes stage_times_of(const execution::StageTimes& times);

struct CacheCounts {
  static constexpr std::string_view kName = "CacheCounts", kMeaning = "The cache of Minkowski sums.";
  std::size_t hits{}, misses{}, entries{}, bytes{}, limit{};

  static void describe(auto& v, auto& self) {
    v.required("hits", self.hits, "Sums that were found in the cache.");
    v.required("misses", self.misses, "Sums that had to be computed.");
    v.required("entries", self.entries, "Sums in the cache.");
    v.required("bytes", self.bytes, "Memory in use.");
    v.required("limit", self.limit, "Maximum memory in bytes.");
  }
};
[[nodiscard]] CacheCounts cache_counts_of(const minkowski::CacheCounts& counts);

}  // namespace selvage::protocol::calls
