#include "protocol/plans/plan_text.h"

#include <cstdio>

namespace selvage::protocol::plans {
namespace {

std::string counted(std::size_t count, const char* one, const char* several) {
  return std::to_string(count) + " " + (count == 1 ? one : several);
}

}  // namespace

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

std::string plies_text(const Json& lay) {
  std::string text;
  for (const Json& one : lay["plies"]) {
    text += (text.empty() ? "" : ", ") + std::to_string(one["plies"].get<int>()) + " " + one["colour"].text();
    if (one.contains("remnant")) text += " from remnant " + std::to_string(one["remnant"].get<std::size_t>() + 1);
  }
  return text;
}

std::string metres(const Json& length) {
  return decimals(length.number() / kMetre, 2) + " m";
}

double gap_of(const Json& plan) {
  const double total = plan["cost"]["total"].number();
  return total > 0 ? (total - plan["bound"].number()) / total : 0;
}

std::string plan_text(const Json& plan) {
  const Json& cost = plan["cost"];
  std::string text = "cost " + decimals(cost["total"].number(), 2) + ", of which cloth " +
                     decimals(cost["cloth"].number(), 2) + "; at most " + decimals(100 * gap_of(plan), 2) +
                     " % above the least, if markers that were not made are as long as estimated\n";
  text += metres(plan["cloth"]) + " of cloth, " + counted(plan["markers"].size(), "marker", "markers") + ", " +
          counted(plan["lays"].size(), "lay", "lays") + "; " +
          counted(plan["made"].get<std::size_t>(), "marker", "markers") + " made in " +
          counted(plan["rounds"].size(), "round", "rounds") + "\n";
  for (const Json& marker : plan["markers"]) {
    text += "  " + ratio_text(marker) + ": " + decimals(marker["length"].number() / kMetre, 3) + " m, " +
            decimals(100 * marker["utilisation"].number(), 2) + " %, " +
            counted(marker["plies"].get<std::size_t>(), "ply", "plies") + " in " +
            counted(marker["lays"].get<std::size_t>(), "lay", "lays") +
            (marker["made"] == true ? "" : " (length estimated)") + "\n";
  }
  std::size_t number = 0;
  for (const Json& remnant : plan["remnants"]) {
    text += "  remnant " + std::to_string(++number) + ", " + remnant["colour"].text() + ", " +
            metres(remnant["length"]) + ": " + counted(remnant["plies"].get<std::size_t>(), "ply", "plies") + ", " +
            metres(remnant["left"]) + " left\n";
  }
  for (const Json& rolls : plan["rolls"]) {
    if (rolls["rolls"] == 0) continue;
    text += "  " + rolls["colour"].text() + ": " + counted(rolls["rolls"].get<std::size_t>(), "roll", "rolls") + ", " +
            counted(rolls["splices"].get<std::size_t>(), "splice", "splices") + ", " + metres(rolls["lost"]) +
            " lost, " + metres(rolls["left"]) + " left of the last\n";
  }
  return text;
}

}  // namespace selvage::protocol::plans
