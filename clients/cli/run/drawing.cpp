#include "clients/cli/run/drawing.h"

namespace selvage::cli::run {
namespace {

// The forces that the parameters of motion.push, motion.gravity and motion.bump name, at the middles of their pieces.
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

protocol::drawing::SvgOptions drawing_of(const MarkerFile& end, const Marker& start, const Json& params,
                                         const DrawingWish& wish) {
  protocol::drawing::SvgOptions drawing = protocol::drawing::svg_options(end);
  drawing.length_before = length_of(start);
  if (wish.arrows) {
    drawing.overlay.moves = protocol::drawing::moves_between(start, end.marker);
    drawing.overlay.forces = forces_of(start, params);
  }
  if (wish.chain) {
    SumCache sums;
    if (const auto hold = motion::compaction::what_holds(end.marker, {sums}))
      drawing.overlay.chain = protocol::drawing::chain_of(end.marker, *hold);
  }
  return drawing;
}

}  // namespace selvage::cli::run
