#include "core/model/pair_rows.h"

#include <cmath>

namespace selvage::model {
namespace {

constexpr double kRowResidual = 1e-9;  // column units: no solver breaks a row by more
constexpr double kWitness = 2;         // lattice units by which a translation that separates a pair is rounded

}  // namespace

FreeSide side_at(const HalfPlane& line, Vec r, Coord spacing) {
  const auto dx = static_cast<double>(line.direction.x);
  const auto dy = static_cast<double>(line.direction.y);
  const double length = std::sqrt(dx * dx + dy * dy);
  return {line, {dy / length, -dx / length}, slack_of(line, r) - static_cast<double>(spacing), spacing < 0};
}

std::vector<HalfPlane> region_of(const PairPosition& position, const RegionSettings& region) {
  if (position.spacing >= 0) return free_region(position.obstacle, position.about, region);
  return overlap_region(position.obstacle, {position.r, position.about, -position.spacing}, region);
}

std::vector<FreeSide> free_sides(const PairPosition& position, const RegionSettings& region) {
  std::vector<FreeSide> sides;
  for (const HalfPlane& line : region_of(position, region)) {
    sides.push_back(side_at(line, position.r, position.spacing));
  }
  return sides;
}

PairRow row_of(marker::PiecePair pair, const FreeSide& side, ModelUnit unit, TightRows tight) {
  PairRow row{pair, side.normal.x, side.normal.y, 0};
  const double rounding = std::abs(row.nx) + std::abs(row.ny);
  double margin = side.slanted() ? rounding + 2 * kRowResidual * unit.lattice_units() : 0;
  if (side.slanted() && side.may_overlap) margin += kWitness;
  row.bound = margin - side.slack;
  const double least = side.may_overlap ? -kWitness : 0;  // a layout that was proved may lie this far behind the line
  if (tight == TightRows::kKeep && side.slack >= least && side.slack < margin) row.bound = 0;
  return row;
}

std::vector<PairRow> pair_rows(marker::PiecePair pair, const PairPosition& position, const RegionSettings& region,
                               const RowSettings& settings) {
  std::vector<PairRow> rows;
  append_pair_rows(pair, position, region, settings, rows);
  return rows;
}

void append_pair_rows(marker::PiecePair pair, const PairPosition& position, const RegionSettings& region,
                      const RowSettings& settings, std::vector<PairRow>& rows) {
  for (const HalfPlane& line : region_of(position, region)) {
    const PairRow row = row_of(pair, side_at(line, position.r, position.spacing), settings.unit, settings.tight);
    if (-row.bound <= settings.motion * (std::abs(row.nx) + std::abs(row.ny))) rows.push_back(row);
  }
}

}  // namespace selvage::model
