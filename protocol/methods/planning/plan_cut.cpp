// plan.cut: from an order to markers, lays and plies [Li94 5.3.4].
#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "core/planning/making/nested_markers.h"
#include "protocol/formats/format.h"
#include "protocol/json/json_text.h"
#include "protocol/methods/planning/plan_messages.h"
#include "protocol/methods/planning/style_garments.h"
#include "protocol/methods/readings/reading.h"

namespace selvage::protocol::methods::planning {
namespace {

namespace core = selvage::planning;
using core::making::Garments;
using core::orders::Problem;
using core::program::Use;

constexpr double kMillimetresOfMetre = 1000;
constexpr double kMirrorSlack = 1;  // millimetres: digitised pairs are not exact mirror images

std::size_t position_in(std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) names.push_back(name);
  return static_cast<std::size_t>(found - names.begin());
}

// The sizes and colours in the order in which they come first.
struct Demand {
  std::vector<std::string> sizes, colours;
  std::vector<std::vector<int>> garments;  // by colour, by size
};
Result<Demand> demand_of(const std::vector<Quantity>& quantities) {
  Demand demand;
  for (const Quantity& quantity : quantities) {
    (void)position_in(demand.sizes, quantity.size);
    (void)position_in(demand.colours, quantity.colour);
  }
  demand.garments.assign(demand.colours.size(), std::vector<int>(demand.sizes.size()));
  for (std::size_t k = 0; k < quantities.size(); ++k) {
    const Quantity& quantity = quantities[k];
    int& sum = demand.garments[position_in(demand.colours, quantity.colour)][position_in(demand.sizes, quantity.size)];
    sum += quantity.garments;
    if (sum > core::orders::kMostGarments) {
      return Error{ErrorCode::kOutOfRange,
                   std::to_string(sum) + " garments of one colour and size; 0 to 1000000 are allowed",
                   "/quantities/" + std::to_string(k) + "/garments"};
    }
  }
  return demand;
}

Result<Problem> problem_of(const PlanParams& params, const Demand& demand, const Garments& garments) {
  Problem problem{{{}, demand.colours, demand.garments}, params.cloth, params.limits, params.costs};
  for (std::size_t size = 0; size < demand.sizes.size(); ++size)
    problem.order.sizes.push_back(measured(garments, size, demand.sizes[size]));
  const Resolution resolution = garments.style.resolution;
  problem.cloth.width = to_decimal(garments.style.strip.width, resolution);
  if (problem.cloth.spread == core::orders::Spread::kOneWay) return problem;
  if (params.limits.plies < 2)
    return Error{ErrorCode::kOutOfRange, "1 is out of range; face to face, a lay has at least 2 plies", "/plies"};
  for (std::size_t size = 0; size < demand.sizes.size(); ++size) {
    const double slack = kMirrorSlack / to_decimal(1, resolution);
    const auto piece = piece_without_mirror_image(garments, size, slack);
    if (!piece) continue;
    const std::size_t placed = garments.style.pieces.size();
    const Piece& odd = *piece < placed ? garments.style.pieces[*piece] : garments.style.unplaced[*piece - placed];
    return Error{ErrorCode::kOutOfRange,
                 "face to face, every second ply cuts mirror images, and piece " + json::shortened(Json(odd.id)) +
                     " of size " + json::shortened(Json(demand.sizes[size])) + " has none in its bundle",
                 "/spread"};
  }
  return problem;
}

core::PlanSettings settings_of(const PlanParams& params) {
  core::PlanSettings settings;
  settings.search.gap = params.gap;
  settings.rounds = params.rounds;
  settings.most_made = params.most_made;
  settings.near_made = params.near_made;
  return settings;
}

calls::StopCause stop_of(core::PlanEnd end, const calls::MethodContext& context) {
  switch (end) {
    case core::PlanEnd::kConverged: return calls::StopCause::kConverged;
    case core::PlanEnd::kWorkLimit: return calls::StopCause::kWorkLimit;
    case core::PlanEnd::kCancelled: break;
  }
  return stop_cause(scene::StopReason::kCancelled, context);
}

// Puts the answer together from a plan.
class Answer {
 public:
  // Documents have the attributes of the style's shapes; null: there are none.
  Answer(const Problem& problem, const core::Plan& plan, const core::making::MadeMarkers& made,
         const MarkerFile* documented)
      : problem_{problem}, plan_{plan}, made_{made}, documented_{documented} {}

  [[nodiscard]] PlanResult result() {
    for (const Use& use : plan_.cutting.uses) add_marker(use);
    for (const core::Lay& lay : plan_.lays) {
      ++result_.markers[lay.marker].lays;
      result_.lays.push_back({lay.marker, plies_of(lay.plies)});
    }
    add_delivered();
    PlanCosts& cost = result_.cost;
    cost.total = cost.cloth + cost.lays + cost.plies + cost.markers + cost.cutting;
    result_.bound = std::min(plan_.bound, cost.total);
    result_.complete = plan_.complete;
    result_.candidates = plan_.candidates;
    result_.made = plan_.made;
    for (const core::PlanRound& round : plan_.rounds)
      result_.rounds.push_back({round.estimated, round.real, round.best});
    return std::move(result_);
  }

 private:
  void add_marker(const Use& use) {
    const core::orders::Costs& costs = problem_.costs;
    PlannedMarker marker;
    for (std::size_t size = 0; size < use.candidate.ratio.size(); ++size) {
      const int bundles = use.candidate.ratio[size];
      if (bundles > 0) marker.ratio.push_back({problem_.order.sizes[size].name, bundles});
    }
    marker.length = use.candidate.length;
    marker.utilisation = area_of(problem_.order, use.candidate.ratio) / (marker.length * problem_.cloth.width);
    marker.plies = problem_.plies_of_unit() * std::accumulate(use.units.begin(), use.units.end(), 0);
    marker.cloth = marker.plies * (marker.length + problem_.cloth.end_loss);
    marker.cost = cost_of(problem_, use);
    if (const Marker* made = made_.find(use.candidate.ratio)) {
      marker.made = true;
      if (documented_ != nullptr) marker.marker = {document_of(*made)};
    }
    result_.cloth += marker.cloth;
    result_.cost.cloth += costs.metre * marker.cloth / kMillimetresOfMetre;
    result_.cost.plies += costs.ply * marker.plies;
    result_.cost.markers += costs.marker;
    const int lays = lays_of(problem_, use);
    result_.cost.lays += costs.lay * lays;
    result_.cost.cutting +=
        costs.cut_metre * lays * perimeter_of(problem_.order, use.candidate.ratio) / kMillimetresOfMetre;
    result_.markers.push_back(std::move(marker));
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

  [[nodiscard]] std::vector<PliesOfColour> plies_of(const std::vector<int>& plies) const {
    std::vector<PliesOfColour> listed;
    for (std::size_t colour = 0; colour < plies.size(); ++colour) {
      if (plies[colour] > 0) listed.push_back({problem_.order.colours[colour], plies[colour]});
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

  const Problem& problem_;
  const core::Plan& plan_;
  const core::making::MadeMarkers& made_;
  const MarkerFile* documented_;
  PlanResult result_;
};

// The core names its own fields; on the wire they have others.
Error on_the_wire(Error error) {
  if (error.field == "/limits/table") error.field = "/table";
  if (error.field == "/limits") error.field = "/quantities";
  return error;
}

Result<PlanResult> run_plan_cut(const PlanParams& params, const MarkerFile& style,
                                const calls::MethodContext& context) {
  const auto demand = demand_of(params.quantities);
  if (!demand) return demand.error();
  const auto garments = garments_of(style, demand->sizes);
  if (!garments) return garments.error();
  const auto problem = problem_of(params, *demand, *garments);
  if (!problem) return problem.error();

  core::making::MadeMarkers made{*garments, core::making::nest_from_nothing({params.moves_per_piece, params.seed}),
                                 context.run};
  const core::MakeMarker make = [&made](const core::orders::Ratio& ratio) { return made.make(ratio); };
  core::PlanRun plan_run{.stop = context.run.stop, .executor = context.run.executor};
  plan_run.on_round = [&](const core::PlanRound& round) {
    const double cloth = std::min(round.best_cloth, to_decimal(kLatticeLimit - 1, style.marker.resolution));
    context.run.observer.on_round({round.number, to_lattice(cloth, style.marker.resolution)});
  };
  const auto plan = plan_cut(*problem, settings_of(params), make, plan_run);
  if (!plan) return on_the_wire(plan.error());
  PlanResult result = Answer{*problem, *plan, made, params.documents ? &style : nullptr}.result();
  result.stop = stop_of(plan->end, context);
  return result;
}

}  // namespace

calls::Method plan_cut_method() {
  return readings::reading_method("plan.cut", calls::MethodKind::kSearch,
                                  "Plans which markers are cut for an order, and how many plies of which colour.",
                                  run_plan_cut);
}

}  // namespace selvage::protocol::methods::planning
