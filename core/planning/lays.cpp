#include <algorithm>

#include "core/planning/plan.h"

namespace selvage::planning {

std::vector<Lay> lays_of(const orders::Problem& problem, const program::Cutting& cutting) {
  std::vector<Lay> lays;
  for (std::size_t marker = 0; marker < cutting.uses.size(); ++marker) {
    const std::vector<int>& units = cutting.uses[marker].units;
    int room = 0;
    for (std::size_t colour = 0; colour < units.size(); ++colour) {
      for (int left = units[colour]; left > 0;) {
        if (room == 0) {
          lays.push_back({marker, std::vector<int>(units.size())});
          room = problem.units_of_lay();
        }
        const int spread = std::min(left, room);
        lays.back().plies[colour] += spread * problem.plies_of_unit();
        left -= spread;
        room -= spread;
      }
    }
  }
  return lays;
}

}  // namespace selvage::planning
