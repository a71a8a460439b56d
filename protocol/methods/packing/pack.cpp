// motion.pack: the shortest marker of all, by exact search [Li94 8.2].
#include "core/packing/pack.h"

#include "protocol/methods/packing/search.h"

namespace selvage::protocol::methods::packing {
namespace {

constexpr std::size_t kMostPieces = 64;  // an exact search of more has no hope

struct PackParams {
  calls::CommonParams call;
  SearchEffort effort;

  static void describe(auto& v, auto& self) {
    v.part(self.call);
    v.part(self.effort);
  }
};

struct PackResult {
  bool found{}, proved{};
  double bound{};
  SearchReport report;

  static void describe(auto& v, auto& self) {
    v.required("found", self.found, "Whether there is a layout; without one the pieces stay.");
    v.required("proved", self.proved,
               "Whether the search is complete: no layout is shorter by more than a millionth of the width, or none "
               "fits the cloth at all.");
    v.required("bound", self.bound, "No marker of these pieces is shorter; proved.");
    v.part(self.report);
  }
};

Result<calls::Motion<PackResult>> run(const PackParams& params, const Marker& start,
                                      const calls::MethodContext& context) {
  if (start.pieces.size() > kMostPieces) {
    return Error{ErrorCode::kTooManyPieces,
                 "the marker has " + std::to_string(start.pieces.size()) + " pieces; motion.pack takes at most " +
                     std::to_string(kMostPieces),
                 "/markerId"};
  }
  selvage::packing::PackSettings settings;
  settings.limits = params.effort.limits();
  settings.turns = params.effort.turns;
  auto done = selvage::packing::pack(start, settings, context.run);
  return calls::Motion<PackResult>{{std::move(done.marker)},
                                   {done.found, done.proved, to_decimal(done.bound, start.resolution),
                                    report_of(done.work, done.rounds, stop_cause(done.reason, context))}};
}

}  // namespace

calls::Method pack_method() {
  return calls::motion_method("motion.pack", calls::MethodKind::kMotion,
                              "Finds the shortest marker of a few pieces and proves that it is.", run);
}

}  // namespace selvage::protocol::methods::packing
