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
    v.required("by", self.by, "By how much more of the length they take than they may.");
  }
};

struct CheckResult {
  bool valid{};
  std::vector<calls::Overlap> overlaps;
  std::vector<calls::Protrusion> protrusions;
  std::optional<std::vector<ShadeFault>> shades;

  static void describe(auto& v, auto& self) {
    v.required("valid", self.valid, calls::kValidMeaning);
    v.required("overlaps", self.overlaps, "Pairs that overlap or are too close.");
    v.required("protrusions", self.protrusions,
               "Pieces that extend beyond the strip, or out of the room that their rules leave.");
    v.optional("shades", self.shades, "Shades whose pieces are too far from each other; absent when there are none.");
  }
};

Result<CheckResult> run_check(const AnalysisParams&, const MarkerFile& file, const calls::MethodContext& context) {
  const auto validity = marker::check(file.marker, context.run.sums, context.run.stop);
  if (!validity) return validity.error();
  CheckResult result{.valid = validity->valid(),
                     .overlaps = calls::overlaps_of(file.marker, validity->overlaps),
                     .protrusions = calls::protrusions_of(file.marker, validity->protrusions),
                     .shades = {}};
  for (const marker::ShadeFault& fault : validity->shades) {
    const auto& pieces = file.marker.pieces;
    if (!result.shades) result.shades.emplace();
    result.shades->push_back({pieces[fault.leftmost.value].rules.shade, pieces[fault.leftmost.value].id,
                              pieces[fault.rightmost.value].id, to_decimal(fault.by, file.marker.resolution)});
  }
  return result;
}

}  // namespace

calls::Method check_method() {
  return reading_method("marker.check", calls::MethodKind::kAnalysis,
                        "Checks whether the marker is valid, and lists where it is not.", run_check);
}

}  // namespace selvage::protocol::methods::readings
