#include "clients/cli/commands/drawing.h"

namespace selvage::cli::commands {
namespace {

// The forces in the parameters of motion.push, motion.gravity and motion.bump, each drawn at the centre of its piece.
std::vector<protocol::drawing::SvgArrow> forces_of(const Marker& marker, const Json& params) {
  std::vector<protocol::drawing::SvgArrow> forces;
  const auto add = [&](std::uint32_t i, const Json& force) {
    const Box box = box_of(placed_outline(marker, PieceId{i}));
    forces.push_back({static_cast<double>(box.low.x + box.high.x) / 2, static_cast<double>(box.low.y + box.high.y) / 2,
                      force[0].get<double>(), force[1].get<double>()});
  };
  for (std::uint32_t i = 0; i < marker.pieces.size(); ++i) {
    if (params.contains("force")) add(i, params["force"]);
    if (params.contains("direction") && params.value("piece", "") == marker.pieces[i].id) add(i, params["direction"]);
    if (!params.contains("forces")) continue;
    for (const Json& one : params["forces"]) {
      if (one["piece"] == marker.pieces[i].id) add(i, one["force"]);
    }
  }
  return forces;
}

}  // namespace

protocol::drawing::SvgOptions result_drawing(const MarkerFile& end, const Marker& start, const Json& params,
                                             const Overlays& overlays) {
  protocol::drawing::SvgOptions drawing = protocol::drawing::svg_options(end);
  drawing.length_before = length_of(start);
  if (overlays.arrows) {
    drawing.overlay.moves = protocol::drawing::moves_between(start, end.marker);
    drawing.overlay.forces = forces_of(start, params);
  }
  if (overlays.critical_path) {
    SumCache sums;
    if (const auto path = motion::compaction::critical_path(end.marker, {sums}))
      drawing.overlay.chain = protocol::drawing::chain_of(end.marker, *path);
  }
  return drawing;
}

}  // namespace selvage::cli::commands
