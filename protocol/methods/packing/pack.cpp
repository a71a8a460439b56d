// motion.pack: the shortest marker of all pieces, with a proof [Li94 8.2].
#include "core/packing/pack.h"

#include <algorithm>

#include "core/geometry/lattice.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/methods/packing/search_params.h"

namespace selvage::protocol::methods::packing {
namespace {

constexpr double kLeastGap = 1e-9;

struct PackParams {
  calls::CommonParams call;
  SearchEffort effort;
  double gap{selvage::packing::PackSettings{}.gap};

  static void describe(auto& v, auto& self) {
    v.part(self.call);
    v.part(self.effort);
    v.optional("gap", self.gap,
               "The search ends when the marker is longer than the bound by at most this fraction of the width, 1e-9 "
               "to 1.",
               {.range = {{kLeastGap, 1}}});
  }
};

struct PackResult {
  bool found{}, proved{};
  double bound{};
  std::size_t placed{}, unplaced{};
  std::uint64_t nodes{};
  calls::RoundsResult rounds;

  static void describe(auto& v, auto& self) {
    v.required("found", self.found, "Whether there is a layout of all pieces; if not, the marker stays as it is.");
    v.required("proved", self.proved,
               "Whether it is proved that no layout is shorter, up to the gap, or that there is none.");
    v.required("bound", self.bound,
               "A proved lower bound on the length of any marker of these pieces with their present tilts, even if the "
               "search ended early.");
    v.required("placed", self.placed, "Number of pieces that lie on the cloth afterwards.");
    v.required("unplaced", self.unplaced, "Number of pieces that do not lie on the cloth afterwards.");
    v.required("nodes", self.nodes, "Number of nodes searched.");
    v.part(self.rounds);
  }
};

Result<calls::Motion<PackResult>> run_pack(const PackParams& params, const Marker& start,
                                           const calls::MethodContext& context) {
  const auto fixed = [](const Piece& piece) { return piece.locked.x && piece.locked.y; };
  const auto locked = static_cast<std::size_t>(std::ranges::count_if(start.pieces, fixed));
  const std::size_t moving = start.pieces.size() - locked + start.unplaced.size();
  if (const auto refusal = too_many(moving, "pieces are not locked", "")) return *refusal;
  selvage::packing::PackSettings settings;
  settings.limits = limits_of(params.effort, params.call);
  settings.turns = params.effort.turns;
  settings.gap = params.gap;
  auto done = selvage::packing::pack(start, settings, context.run);
  const PackResult result{.found = done.found,
                          .proved = done.proved,
                          .bound = to_decimal(done.bound, start.resolution),
                          .placed = piece_count(done.marker),
                          .unplaced = done.marker.unplaced.size(),
                          .nodes = done.work.nodes,
                          .rounds = {done.rounds, stop_cause(done.reason, context)}};
  return calls::Motion<PackResult>{{std::move(done.marker), done.repair}, result};
}

}  // namespace

calls::Method pack_method() {
  return calls::motion_method("motion.pack", calls::MethodKind::kMotion,
                              "Searches all layouts of the pieces for the shortest, and proves how short it can be.",
                              run_pack);
}

}  // namespace selvage::protocol::methods::packing
