#include "protocol/plans/plan_text.h"

#include <cstdio>

namespace selvage::protocol::plans {
std::string decimals(double value, int places) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", places, value);
  return text;
}

std::string ratio_text(const Json& marker) {
  std::string text;
  for (const Json& one : marker["ratio"]) {
    text += (text.empty() ? "" : ", ") + one["size"].text() + " x " + std::to_string(one["bundles"].get<int>());
  }
  return text;
}

double gap_of(const Json& plan) {
  const double total = plan["cost"]["total"].number();
  return total > 0 ? (total - plan["bound"].number()) / total : 0;
}

std::string plan_text(const Json& plan) {
  const Json& cost = plan["cost"];
  std::string text = "cost " + decimals(cost["total"].number(), 2) + ", of which cloth " +
                     decimals(cost["cloth"].number(), 2) + "; at most " + decimals(100 * gap_of(plan), 2) +
                     " % above the least\n";
  text += decimals(plan["cloth"].number() / kMetre, 2) + " m of cloth, " + std::to_string(plan["markers"].size()) +
          " markers, " + std::to_string(plan["lays"].size()) + " lays; " +
          std::to_string(plan["made"].get<std::size_t>()) + " markers made in " +
          std::to_string(plan["rounds"].size()) + " rounds\n";
  for (const Json& marker : plan["markers"]) {
    text += "  " + ratio_text(marker) + ": " + decimals(marker["length"].number() / kMetre, 3) + " m, " +
            decimals(100 * marker["utilisation"].number(), 2) + " %, " + std::to_string(marker["plies"].get<int>()) +
            " plies in " + std::to_string(marker["lays"].get<std::size_t>()) + " lays" +
            (marker["made"] == true ? "" : " (length estimated)") + "\n";
  }
  return text;
}

}  // namespace selvage::protocol::plans
