#include "core/planning/orders/order.h"

#include <algorithm>
#include <cmath>

namespace selvage::planning::orders {
namespace {

// Of a fraction of a count: 1.03 * 100 is 103, whatever rounding makes of it.
constexpr double kRounding = 1e-9;
constexpr double kPerMetre = 1e-3;  // metres in a millimetre

// Without the zeros that std::to_string adds.
std::string shown(double value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text;
}

std::optional<Error> outside(const char* field, double value, double least, double most) {
  if (std::isfinite(value) && value >= least && value <= most) return std::nullopt;
  return Error{ErrorCode::kOutOfRange,
               shown(value) + " is out of range; " + shown(least) + " to " + shown(most) + " is allowed", field};
}

std::optional<Error> mistake_in_numbers(const Problem& problem) {
  constexpr double kLongest = 1e9, kDearest = 1e9;
  const Cloth& cloth = problem.cloth;
  const Limits& limits = problem.limits;
  const Costs& costs = problem.costs;
  const int least_plies = problem.plies_of_unit();
  for (const auto& mistake :
       {outside("/cloth/width", cloth.width, 1e-6, kLongest), outside("/cloth/endLoss", cloth.end_loss, 0, kLongest),
        outside("/cloth/rollLength", cloth.roll_length, 0, kLongest),
        outside("/cloth/spliceLoss", cloth.splice_loss, 0, kLongest),
        outside("/limits/plies", limits.plies, least_plies, kMostPlies),
        outside("/limits/table", limits.table, 1e-6, kLongest),
        outside("/limits/bundles", limits.bundles, 1, kMostBundles), outside("/limits/over", limits.over, 0, 10),
        outside("/limits/under", limits.under, 0, 1), outside("/costs/metre", costs.metre, 0, kDearest),
        outside("/costs/remnantMetre", costs.remnant_metre, 0, kDearest), outside("/costs/lay", costs.lay, 0, kDearest),
        outside("/costs/ply", costs.ply, 0, kDearest), outside("/costs/marker", costs.marker, 0, kDearest),
        outside("/costs/cutMetre", costs.cut_metre, 0, kDearest)}) {
    if (mistake) return mistake;
  }
  const double shortest = std::max(limits.table, 2 * cloth.splice_loss);
  if (cloth.roll_length > 0 && cloth.roll_length < shortest) {
    return Error{ErrorCode::kOutOfRange,
                 shown(cloth.roll_length) + " is out of range; 0 is allowed, and " + shown(shortest) +
                     " or more: no roll is shorter than the table or two splices",
                 "/cloth/rollLength"};
  }
  return std::nullopt;
}

std::optional<Error> mistake_in_remnants(const Problem& problem) {
  constexpr double kLongest = 1e9;
  const std::vector<Remnant>& remnants = problem.cloth.remnants;
  if (remnants.size() > kMostRemnants)
    return Error{ErrorCode::kOutOfRange, "there are more than 100 remnants", "/cloth/remnants"};
  for (std::size_t k = 0; k < remnants.size(); ++k) {
    const std::string at = "/cloth/remnants/" + std::to_string(k);
    if (remnants[k].colour >= problem.order.colours.size())
      return Error{ErrorCode::kOutOfRange, "nothing is ordered in the colour of the remnant", at + "/colour"};
    if (auto mistake = outside("", remnants[k].length, 1e-6, kLongest)) {
      mistake->field = at + "/length";
      return mistake;
    }
  }
  return std::nullopt;
}

}  // namespace

double Problem::splice_part() const {
  return cloth.roll_length > 0 ? cloth.splice_loss / (cloth.roll_length - cloth.splice_loss) : 0;
}

double Problem::roll_rate() const {
  return costs.metre * kPerMetre * (1 + splice_part());
}

double Problem::remnant_saving() const {
  return std::max(0.0, roll_rate() - costs.remnant_metre * kPerMetre);
}

double Problem::cut_rate() const {
  return costs.cut_metre * kPerMetre;
}

int Problem::least(std::size_t colour, std::size_t size) const {
  return static_cast<int>(std::ceil(order.garments[colour][size] * (1 - limits.under) - kRounding));
}

int Problem::most(std::size_t colour, std::size_t size) const {
  const int garments = order.garments[colour][size];
  if (garments == 0) return 0;
  const int unit = plies_of_unit();
  const int rounded_up = (least(colour, size) + unit - 1) / unit * unit;
  return std::max(rounded_up, static_cast<int>(std::floor(garments * (1 + limits.over) + kRounding)));
}

std::optional<Error> too_many_lays(std::int64_t lays) {
  if (lays <= kMostLays) return std::nullopt;
  return Error{ErrorCode::kOutOfRange,
               "the order takes " + std::to_string(lays) + " lays or more; at most " + std::to_string(kMostLays) +
                   " are allowed: allow more plies in a lay, or more bundles in a marker",
               "/limits/plies"};
}

std::optional<Error> mistake_in(const Problem& problem) {
  const Order& order = problem.order;
  const auto missing = [](const char* what) { return Error{ErrorCode::kMissingField, what, "/quantities"}; };
  if (order.sizes.empty() || order.colours.empty()) return missing("the order has no sizes or no colours");
  if (order.sizes.size() > kMostSizes || order.colours.size() > kMostColours) {
    return Error{ErrorCode::kOutOfRange, "the order has more than 50 sizes or more than 50 colours", "/quantities"};
  }
  if (order.garments.size() != order.colours.size()) return missing("a colour has no quantities");
  if (auto mistake = mistake_in_numbers(problem)) return mistake;
  if (auto mistake = mistake_in_remnants(problem)) return mistake;
  std::int64_t must = 0;  // garments that must be cut
  for (std::size_t colour = 0; colour < order.colours.size(); ++colour) {
    const std::string at = "/quantities/" + order.colours[colour];
    if (order.garments[colour].size() != order.sizes.size()) return missing("a colour lacks the number of a size");
    for (std::size_t size = 0; size < order.sizes.size(); ++size) {
      const int garments = order.garments[colour][size];
      if (garments < 0 || garments > kMostGarments) {
        return Error{ErrorCode::kOutOfRange, std::to_string(garments) + " garments; 0 to 1000000 are allowed",
                     at + "/" + order.sizes[size].name};
      }
      must += problem.least(colour, size);
    }
  }
  if (must == 0) return missing("the order has no garments that must be cut");
  const std::int64_t of_lay = std::int64_t{problem.units_of_lay()} * problem.plies_of_unit() * problem.limits.bundles;
  return too_many_lays((must + of_lay - 1) / of_lay);
}

}  // namespace selvage::planning::orders
