// plan.cut: from an order to markers, lays and plies [Li94 5.3.4].
#include <algorithm>
#include <string>
#include <utility>

#include "core/planning/making/nested_markers.h"
#include "core/planning/making/stored_lengths.h"
#include "protocol/json/json_text.h"
#include "protocol/methods/planning/plan_answer.h"
#include "protocol/methods/planning/plan_params.h"
#include "protocol/methods/planning/style_garments.h"
#include "protocol/methods/readings/reading.h"

namespace selvage::protocol::methods::planning {
namespace {

namespace core = selvage::planning;
using core::making::Garments;
using core::orders::Problem;

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

// The remnants with their colours by position.
Result<std::vector<core::orders::Remnant>> remnants_of(const std::vector<GivenRemnant>& given, const Demand& demand) {
  std::vector<core::orders::Remnant> remnants;
  for (std::size_t k = 0; k < given.size(); ++k) {
    const auto found = std::find(demand.colours.begin(), demand.colours.end(), given[k].colour);
    if (found == demand.colours.end()) {
      return Error{ErrorCode::kOutOfRange,
                   "nothing is ordered in " + json::shortened(Json(given[k].colour)) + ", the colour of a remnant",
                   "/remnants/" + std::to_string(k) + "/colour"};
    }
    remnants.push_back({static_cast<std::size_t>(found - demand.colours.begin()), given[k].length});
  }
  return remnants;
}

Result<Problem> problem_of(const PlanParams& params, const Demand& demand, const Garments& garments) {
  Problem problem{{{}, demand.colours, demand.garments}, params.cloth, params.limits, params.costs};
  for (std::size_t size = 0; size < demand.sizes.size(); ++size)
    problem.order.sizes.push_back(measured(garments, size, demand.sizes[size]));
  const Resolution resolution = garments.style.resolution;
  problem.cloth.width = to_decimal(garments.style.strip.width, resolution);
  auto remnants = remnants_of(params.remnants.value_or(std::vector<GivenRemnant>{}), demand);
  if (!remnants) return remnants.error();
  problem.cloth.remnants = *std::move(remnants);
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
                     " of size " + json::shortened(Json(demand.sizes[size])) + " has no mirror image in its bundle",
                 "/spread"};
  }
  return problem;
}

// What the stored markers that are given, or those of the library, say about the lengths of markers.
std::vector<core::orders::MadeLength> stored_lengths(const PlanParams& params, const Garments& garments,
                                                     const calls::MethodContext& context) {
  std::vector<Marker> stored;
  if (params.stored) {
    for (const library::GivenMarker& given : *params.stored) stored.push_back(given.file.marker);
  } else if (context.library) {
    for (MarkerFile& file : context.library(one_of_each_size(garments), library::kNearest)) {
      stored.push_back(std::move(file.marker));
    }
  }
  return lengths_like(garments, stored);
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

// The core names its own fields; on the wire they have others.
Error on_the_wire(Error error) {
  if (error.field == "/limits/table") error.field = "/table";
  if (error.field == "/limits/plies") error.field = "/plies";
  if (error.field == "/limits") error.field = "/quantities";
  if (error.field.starts_with("/cloth/")) error.field.erase(0, std::string_view{"/cloth"}.size());
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
  core::PlanSettings settings = settings_of(params);
  settings.stored = stored_lengths(params, *garments, context);
  const auto plan = plan_cut(*problem, settings, make, plan_run);
  if (!plan) return on_the_wire(plan.error());
  PlanResult result = plan_answer(*problem, *plan, made, params.documents ? &style : nullptr);
  result.stored = settings.stored.size();
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
