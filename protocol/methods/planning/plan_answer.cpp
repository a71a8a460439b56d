#include "protocol/methods/planning/plan_answer.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/planning/program/remnants.h"
#include "protocol/formats/format.h"

namespace selvage::protocol::methods::planning {
namespace {

namespace core = selvage::planning;
using core::program::Use;

constexpr double kMillimetresOfMetre = 1000;

class Answer {
 public:
  Answer(const core::orders::Problem& problem, const core::Plan& plan, const core::making::MadeMarkers& made,
         const MarkerFile* documented)
      : problem_{problem},
        plan_{plan},
        made_{made},
        documented_{documented},
        on_remnants_{spread_on_remnants(problem, plan.cutting.uses)} {}

  [[nodiscard]] PlanResult result() {
    for (std::size_t k = 0; k < plan_.cutting.uses.size(); ++k) add_marker(k);
    for (const core::Lay& lay : plan_.lays) {
      ++result_.markers[lay.marker].lays;
      result_.lays.push_back({lay.marker, plies_of(lay)});
    }
    add_delivered();
    add_remnants();
    add_rolls();
    PlanCosts& cost = result_.cost;
    cost.total = cost.cloth + cost.splices + cost.remnants + cost.lays + cost.plies + cost.markers + cost.cutting;
    result_.bound = std::min(plan_.bound, cost.total);
    result_.complete = plan_.complete;
    result_.candidates = plan_.candidates;
    result_.made = plan_.made;
    for (const core::PlanRound& round : plan_.rounds)
      result_.rounds.push_back({round.estimated, round.real, round.best});
    return std::move(result_);
  }

 private:
  void add_marker(std::size_t position) {
    const Use& use = plan_.cutting.uses[position];
    PlannedMarker marker;
    for (std::size_t size = 0; size < use.candidate.ratio.size(); ++size) {
      const int bundles = use.candidate.ratio[size];
      if (bundles > 0) marker.ratio.push_back({problem_.order.sizes[size].name, bundles});
    }
    marker.length = use.candidate.length;
    marker.utilisation = area_of(problem_.order, use.candidate.ratio) / (marker.length * problem_.cloth.width);
    const int units = std::accumulate(use.units.begin(), use.units.end(), 0);
    marker.plies = problem_.plies_of_unit() * units;
    marker.cloth = units * problem_.unit_length(marker.length);
    marker.cost = cost_of(problem_, use) - problem_.remnant_saving() * length_on_remnants(position);
    if (const Marker* made = made_.find(use.candidate.ratio)) {
      marker.made = true;
      if (documented_ != nullptr) marker.marker = {document_of(*made)};
    }
    add_costs(position, marker);
    result_.markers.push_back(std::move(marker));
  }

  void add_costs(std::size_t position, const PlannedMarker& marker) {
    const Use& use = plan_.cutting.uses[position];
    const core::orders::Costs& costs = problem_.costs;
    const double remnants = length_on_remnants(position), rolls = marker.cloth - remnants;
    PlanCosts& cost = result_.cost;
    result_.cloth += marker.cloth;
    cost.cloth += costs.metre * rolls / kMillimetresOfMetre;
    cost.splices += costs.metre * problem_.splice_part() * rolls / kMillimetresOfMetre;
    cost.remnants += costs.remnant_metre * remnants / kMillimetresOfMetre;
    cost.plies += costs.ply * marker.plies;
    cost.markers += costs.marker;
    const int lays = lays_of(problem_, use);
    cost.lays += costs.lay * lays;
    cost.cutting += costs.cut_metre * lays * perimeter_of(problem_.order, use.candidate.ratio) / kMillimetresOfMetre;
  }

  [[nodiscard]] double length_on_remnants(std::size_t position) const {
    const std::vector<int>& units = on_remnants_.units[position];
    return std::accumulate(units.begin(), units.end(), 0) *
           problem_.unit_length(plan_.cutting.uses[position].candidate.length);
  }

  [[nodiscard]] Json document_of(const Marker& marker) const {
    MarkerFile file;
    file.marker = marker;
    for (const Shape& shape : marker.shapes) {
      const auto& shapes = documented_->marker.shapes;
      const auto own = std::find_if(shapes.begin(), shapes.end(), [&](const Shape& one) { return one.id == shape.id; });
      file.attributes.shapes.push_back(documented_->attributes.shapes[static_cast<std::size_t>(own - shapes.begin())]);
    }
    file.attributes.pieces.assign(marker.pieces.size(), Json::object());
    return *formats::marker_document(file, Format::kNative);
  }

  // The plies in the order in which they are spread: of every colour, first those from remnants, then those from rolls.
  [[nodiscard]] std::vector<PliesOfColour> plies_of(const core::Lay& lay) const {
    std::vector<PliesOfColour> listed;
    for (std::size_t colour = 0; colour < lay.plies.size(); ++colour) {
      int left = lay.plies[colour];
      for (std::size_t r = 0; r < lay.on_remnants.size(); ++r) {
        if (problem_.cloth.remnants[r].colour != colour || lay.on_remnants[r] == 0) continue;
        listed.push_back({problem_.order.colours[colour], lay.on_remnants[r], r});
        left -= lay.on_remnants[r];
      }
      if (left > 0) listed.push_back({problem_.order.colours[colour], left, {}});
    }
    return listed;
  }

  void add_delivered() {
    const auto cut = delivered_by(problem_, plan_.cutting.uses);
    for (std::size_t colour = 0; colour < cut.size(); ++colour) {
      for (std::size_t size = 0; size < cut[colour].size(); ++size) {
        const int ordered = problem_.order.garments[colour][size];
        if (ordered > 0)
          result_.delivered.push_back(
              {problem_.order.colours[colour], problem_.order.sizes[size].name, ordered, cut[colour][size]});
      }
    }
  }

  void add_remnants() {
    const std::vector<Use>& uses = plan_.cutting.uses;
    for (std::size_t r = 0; r < problem_.cloth.remnants.size(); ++r) {
      const core::orders::Remnant& given = problem_.cloth.remnants[r];
      PlannedRemnant remnant{.colour = problem_.order.colours[given.colour], .length = given.length};
      for (std::size_t k = 0; k < uses.size(); ++k) {
        remnant.plies += problem_.plies_of_unit() * on_remnants_.units[k][r];
        remnant.used += on_remnants_.units[k][r] * problem_.unit_length(uses[k].candidate.length);
      }
      remnant.left = std::max(0.0, remnant.length - remnant.used);
      result_.remnants.push_back(std::move(remnant));
    }
  }

  void add_rolls() {
    for (std::size_t colour = 0; colour < plan_.rolls.size(); ++colour) {
      const core::Rolls& rolls = plan_.rolls[colour];
      result_.rolls.push_back({.colour = problem_.order.colours[colour],
                               .cloth = rolls.cloth,
                               .lost = rolls.lost,
                               .left = rolls.left,
                               .rolls = rolls.rolls,
                               .splices = rolls.splices});
    }
  }

  const core::orders::Problem& problem_;
  const core::Plan& plan_;
  const core::making::MadeMarkers& made_;
  const MarkerFile* documented_;
  core::program::OnRemnants on_remnants_;
  PlanResult result_;
};

}  // namespace

PlanResult plan_answer(const core::orders::Problem& problem, const core::Plan& plan,
                       const core::making::MadeMarkers& made, const MarkerFile* documented) {
  return Answer{problem, plan, made, documented}.result();
}

}  // namespace selvage::protocol::methods::planning
