// marker.check: whether a marker is valid, and where it is not.
#include "core/marker/validity.h"

#include "protocol/methods/readings/reading.h"

namespace selvage::protocol::methods::readings {
namespace {

struct ShadeFault {
  static constexpr std::string_view kName = "ShadeFault",
                                    kMeaning = "Pieces of one shade that are too far from each other.";
  std::string shade, leftmost, rightmost;
  double by{};

  static void describe(auto& v, auto& self) {
    v.required("shade", self.shade, "The name of the shade.");
    v.required("leftmost", self.leftmost, "The id of its leftmost piece.");
    v.required("rightmost", self.rightmost, "The id of its rightmost piece.");
    v.required("by", self.by, "By how much they exceed the allowed length.");
  }
};

struct MatchFault {
  static constexpr std::string_view kName = "MatchFault",
                                    kMeaning = "A piece that is out of phase with another one of its match set.";
  std::string set, piece, other;
  calls::Point by{};

  static void describe(auto& v, auto& self) {
    v.required("matchSet", self.set, "The name of the match set.");
    v.required("piece", self.piece, calls::kPieceMeaning);
    v.required("other", self.other, "The id of the other piece.");
    v.required("by", self.by, "How far its match point lies from the nearest repeat of the other's.");
  }
};

struct CheckResult {
  bool valid{};
  std::vector<calls::Overlap> overlaps;
  std::vector<calls::Protrusion> protrusions;
  std::optional<std::vector<ShadeFault>> shades;
  std::optional<std::vector<MatchFault>> matches;

  static void describe(auto& v, auto& self) {
    v.required("valid", self.valid, calls::kValidMeaning);
    v.required("overlaps", self.overlaps, "Pairs that overlap or are too close; at most 500,000 of them.");
    v.required("protrusions", self.protrusions,
               "Pieces that extend beyond the strip, or beyond the room that their rules allow.");
    v.optional("shades", self.shades, "Shades whose pieces are too far from each other; absent when there are none.");
    v.optional("matches", self.matches,
               "Pieces that are out of phase with their match sets; absent when there are none.");
  }
};

Result<CheckResult> run_check(const AnalysisParams&, const MarkerFile& file, const calls::MethodContext& context) {
  const auto validity = marker::check(file.marker, context.run.sums, context.run.stop);
  if (!validity) return validity.error();
  CheckResult result{.valid = validity->valid(),
                     .overlaps = calls::overlaps_of(file.marker, validity->overlaps),
                     .protrusions = calls::protrusions_of(file.marker, validity->protrusions),
                     .shades = {},
                     .matches = {}};
  for (const marker::ShadeFault& fault : validity->shades) {
    const auto& pieces = file.marker.pieces;
    if (!result.shades) result.shades.emplace();
    result.shades->push_back({pieces[fault.leftmost.value].rules.shade, pieces[fault.leftmost.value].id,
                              pieces[fault.rightmost.value].id, to_decimal(fault.by, file.marker.resolution)});
  }
  for (const marker::MatchFault& fault : validity->matches) {
    const Piece& piece = file.marker.pieces[fault.piece.value];
    if (!result.matches) result.matches.emplace();
    result.matches->push_back(
        {piece.rules.match_set, piece.id, file.marker.pieces[fault.other.value].id,
         calls::point_of(static_cast<double>(fault.by.x), static_cast<double>(fault.by.y), file.marker.resolution)});
  }
  return result;
}

}  // namespace

calls::Method check_method() {
  return reading_method("marker.check", calls::MethodKind::kAnalysis,
                        "Checks whether the marker is valid, and lists where it is not.", run_check);
}

}  // namespace selvage::protocol::methods::readings
