// marker.check: whether a marker is valid, and where it is not.
#include "core/marker/validity.h"

#include "protocol/methods/readings/reading.h"

namespace selvage::protocol::methods::readings {
namespace {

struct CheckResult {
  bool valid{};
  std::vector<calls::Overlap> overlaps;
  std::vector<calls::Protrusion> protrusions;

  static void describe(auto& v, auto& self) {
    v.required("valid", self.valid, calls::kValidMeaning);
    v.required("overlaps", self.overlaps, "Pairs that overlap or are too close.");
    v.required("protrusions", self.protrusions, "Pieces that extend beyond the strip.");
  }
};

Result<CheckResult> run(const AnalysisParams&, const MarkerFile& file, const calls::MethodContext& context) {
  const auto validity = marker::check(file.marker, context.run.sums, context.run.stop);
  if (!validity) return validity.error();
  return CheckResult{.valid = validity->valid(),
                     .overlaps = calls::overlaps_of(file.marker, validity->overlaps),
                     .protrusions = calls::protrusions_of(file.marker, validity->protrusions)};
}

}  // namespace

calls::Method check_method() {
  return reading_method("marker.check", calls::MethodKind::kAnalysis,
                        "Checks whether the marker is valid, and lists where it is not.", run);
}

}  // namespace selvage::protocol::methods::readings
