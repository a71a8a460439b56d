// The messages of plan.cut: what is to be cut, within which limits and at which cost; and the plan.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/planning/plan.h"
#include "protocol/calls/results.h"
#include "protocol/methods/library/given_marker.h"
#include "protocol/schema/documents.h"
#include "protocol/schema/visitors.h"

namespace selvage::protocol::schema {

template <>
struct Choices<selvage::planning::orders::Spread> {
  static constexpr std::string_view kName = "Spread";
  static constexpr std::string_view kMeaning =
      "How plies are spread: all face up, or in pairs face to face, of which the second cuts mirrored pieces.";
  static constexpr std::string_view kWords[] = {"one_way", "face_to_face"};
};

}  // namespace selvage::protocol::schema

namespace selvage::protocol::methods::planning {

inline constexpr std::size_t kMostStored = 1'000, kNearest = 20;  // stored markers: given, and of a library

struct Quantity {
  static constexpr std::string_view kName = "Quantity", kMeaning = "How many garments are ordered.";
  std::string colour, size;
  int garments{};

  static void describe(auto& v, auto& self) {
    v.required("colour", self.colour, "The colour of the cloth.", {.bytes = {{1, 200}}});
    v.required("size", self.size, "As the style's pieces name it among their attributes.", {.bytes = {{1, 200}}});
    v.required("garments", self.garments, "0 to 1,000,000.",
               {.range = {{0, selvage::planning::orders::kMostGarments}}});
  }
};

struct GivenRemnant {
  static constexpr std::string_view kName = "Remnant", kMeaning = "Cloth that an earlier order has left.";
  std::string colour;
  double length{};

  static void describe(auto& v, auto& self) {
    v.required("colour", self.colour, "One of the order's colours.", {.bytes = {{1, 200}}});
    v.required("length", self.length, "Its length; above 0.", {.range = {{1e-6, 1e9}}});
  }
};

// Lengths are in millimetres; the standard values are those of the core.
struct PlanParams {
  std::string marker_id;
  std::vector<Quantity> quantities;
  std::optional<std::vector<GivenRemnant>> remnants;
  std::optional<std::vector<library::GivenMarker>> stored;
  selvage::planning::orders::Cloth cloth{};
  selvage::planning::orders::Limits limits{};
  selvage::planning::orders::Costs costs{};
  double gap{0.01};
  int rounds{8};
  std::size_t most_made{24}, near_made{2};
  std::uint64_t moves_per_piece{60}, seed{1};
  bool documents{true};
  std::optional<double> deadline_ms;
  std::optional<calls::ProgressToken> progress_token;

  static void describe(auto& v, auto& self) {
    constexpr double kLongest = 1e9, kDearest = 1e9;
    v.required("markerId", self.marker_id, "The style: a marker with one garment of every size.");
    v.required("quantities", self.quantities, "1 to 2,500 of them; those of one colour and size are added up.",
               {.entries = {{1, 2'500}}, .entries_are = "quantities"});
    v.optional("spread", self.cloth.spread, "How plies are spread.");
    v.optional("endLoss", self.cloth.end_loss, "Cloth that every ply loses at its two ends together.",
               {.range = {{0, kLongest}}});
    v.optional("rollLength", self.cloth.roll_length,
               "The length of a roll; plies are spliced where one ends. 0: rolls have no end. Else no shorter than the "
               "table and than two splices.",
               {.range = {{0, kLongest}}});
    v.optional("spliceLoss", self.cloth.splice_loss, "Cloth that a splice takes: the overlap of two rolls in a ply.",
               {.range = {{0, kLongest}}});
    v.optional("remnants", self.remnants,
               "Up to 100 lengths of cloth that are there already. They hold whole plies, which are not spliced.",
               {.entries = {{0, selvage::planning::orders::kMostRemnants}}, .entries_are = "remnants"});
    v.optional("plies", self.limits.plies, "Most plies of a lay, 1 to 1,000.",
               {.range = {{1, selvage::planning::orders::kMostPlies}}});
    v.optional("table", self.limits.table, "Most length of a ply: that of the marker and the end loss.",
               {.range = {{1e-6, kLongest}}});
    v.optional("bundles", self.limits.bundles, "Most bundles of a marker, 1 to 50.",
               {.range = {{1, selvage::planning::orders::kMostBundles}}});
    v.optional("overCut", self.limits.over, "Part by which more garments of a colour and size may be cut, 0 to 10.",
               {.range = {{0, 10}}});
    v.optional("underCut", self.limits.under, "Part by which fewer may be cut, 0 to 1.", {.range = {{0, 1}}});
    v.optional("costMetre", self.costs.metre, "The cost of a metre of cloth from rolls.", {.range = {{0, kDearest}}});
    v.optional("costRemnantMetre", self.costs.remnant_metre, "The cost of a metre of cloth from remnants.",
               {.range = {{0, kDearest}}});
    v.optional("costLay", self.costs.lay, "The cost of setting up a lay.", {.range = {{0, kDearest}}});
    v.optional("costPly", self.costs.ply, "The cost of spreading a ply.", {.range = {{0, kDearest}}});
    v.optional("costMarker", self.costs.marker, "The cost of making a marker.", {.range = {{0, kDearest}}});
    v.optional("costCutMetre", self.costs.cut_metre,
               "The cost of a metre that the knife cuts around the pieces of a lay.", {.range = {{0, kDearest}}});
    v.optional("gap", self.gap, "The search ends when cost and bound differ by this part of the cost, 0 to 1.",
               {.range = {{0, 1}}});
    v.optional("rounds", self.rounds, "Most rounds of choosing markers and making them, 1 to 100.",
               {.range = {{1, 100}}});
    v.optional("mostMade", self.most_made,
               "After so many made markers, only those are made that a round's plan needs, 0 to 1,000.",
               {.range = {{0, 1'000}}});
    v.optional("nearMade", self.near_made, "Markers that each round makes besides those of its plan, 0 to 100.",
               {.range = {{0, 100}}});
    v.optional("movesPerPiece", self.moves_per_piece,
               "The budget of nesting a marker, in moves for each of its pieces.", {.range = {{0, 1e6}}});
    v.optional("seed", self.seed, "The seed of nesting's random choices.", {.range = {{0, 9007199254740991.0}}});
    v.optional("stored", self.stored,
               "Stored markers, native or sparrow documents: those of similar garments on such cloth teach how long "
               "markers become. The nearest of the library when absent.",
               {.entries = {{0, kMostStored}}, .entries_are = "markers"});
    v.optional("documents", self.documents, "False: leave out the markers' documents.");
    v.optional("deadlineMs", self.deadline_ms,
               "After this many milliseconds the best plan so far is returned; 1 to 86,400,000.", calls::kDeadlines);
    v.optional("progressToken", self.progress_token,
               "Progress notifications, one after each round, carry this token; their length is the cloth of the best "
               "plan so far.");
  }
};

struct BundlesOfSize {
  static constexpr std::string_view kName = "BundlesOfSize", kMeaning = "How many bundles of a size a marker holds.";
  std::string size;
  int bundles{};

  static void describe(auto& v, auto& self) {
    v.required("size", self.size, "The size.");
    v.required("bundles", self.bundles, "At least 1.");
  }
};

struct PliesOfColour {
  static constexpr std::string_view kName = "PliesOfColour", kMeaning = "How many plies of a colour a lay has.";
  std::string colour;
  int plies{};
  std::optional<std::size_t> remnant;

  static void describe(auto& v, auto& self) {
    v.required("colour", self.colour, "The colour.");
    v.required("plies", self.plies, "At least 1.");
    v.optional("remnant", self.remnant,
               "Position in the list of remnants of the one that they come from; absent: they come from rolls.");
  }
};

struct PlannedMarker {
  static constexpr std::string_view kName = "PlannedMarker", kMeaning = "A marker of a plan.";
  std::vector<BundlesOfSize> ratio;
  bool made{};
  double length{}, utilisation{};
  std::size_t lays{};
  int plies{};
  double cloth{}, cost{};
  std::optional<schema::NativeDocument> marker;

  static void describe(auto& v, auto& self) {
    v.required("ratio", self.ratio, "What it holds.");
    v.required("made", self.made, "False: the run ended before the marker was made, and its length is an estimate.");
    v.required("length", self.length, "The length of the marker, without the end loss.");
    v.required("utilisation", self.utilisation, "The pieces' area divided by width times length, 0 to 1.");
    v.required("lays", self.lays, "Number of lays that are cut with it.");
    v.required("plies", self.plies, "Number of plies of all these lays.");
    v.required("cloth", self.cloth, "Length of cloth that they take, with end losses.");
    v.required("cost", self.cost,
               "The cost of making the marker and cutting its lays; cloth from remnants at its price.");
    v.optional("marker", self.marker, "Its document in the native form; absent when it was not made or not asked for.");
  }
};

struct PlannedLay {
  static constexpr std::string_view kName = "PlannedLay", kMeaning = "A lay of a plan.";
  std::size_t marker{};
  std::vector<PliesOfColour> plies;

  static void describe(auto& v, auto& self) {
    v.required("marker", self.marker, "Position in the list of markers; 0 is the first.");
    v.required("plies", self.plies, "From the lowest to the uppermost.");
  }
};

struct Delivered {
  static constexpr std::string_view kName = "Delivered", kMeaning = "How many garments are cut.";
  std::string colour, size;
  int ordered{}, cut{};

  static void describe(auto& v, auto& self) {
    v.required("colour", self.colour, "The colour.");
    v.required("size", self.size, "The size.");
    v.required("ordered", self.ordered, "Garments.");
    v.required("cut", self.cut, "Garments.");
  }
};

struct PlannedRemnant {
  static constexpr std::string_view kName = "PlannedRemnant", kMeaning = "What a plan takes from a remnant.";
  std::string colour;
  double length{}, used{}, left{};
  int plies{};

  static void describe(auto& v, auto& self) {
    v.required("colour", self.colour, "The colour.");
    v.required("length", self.length, "Its length.");
    v.required("plies", self.plies, "Number of plies that come from it.");
    v.required("used", self.used, "The length that they take, with end losses.");
    v.required("left", self.left, "What is left of it.");
  }
};

struct PlannedRolls {
  static constexpr std::string_view kName = "PlannedRolls",
                                    kMeaning =
                                        "What a plan takes from the rolls of a colour, spread one after another.";
  std::string colour;
  double cloth{}, lost{}, left{};
  int rolls{}, splices{};

  static void describe(auto& v, auto& self) {
    v.required("colour", self.colour, "The colour.");
    v.required("cloth", self.cloth, "The length of the plies that come from rolls, with end losses.");
    v.required("rolls", self.rolls, "Number of rolls that are begun; 0 when rolls have no end.");
    v.required("splices", self.splices, "Number of plies that are spliced.");
    v.required("lost", self.lost, "Length lost in splices, and in ends that are shorter than a splice.");
    v.required("left", self.left, "What is left of the last roll: a remnant for another order.");
  }
};

struct PlanCosts {
  static constexpr std::string_view kName = "PlanCosts", kMeaning = "What a plan costs.";
  double total{}, cloth{}, splices{}, remnants{}, lays{}, plies{}, markers{}, cutting{};

  static void describe(auto& v, auto& self) {
    v.required("total", self.total, "The sum of the costs.");
    v.required("cloth", self.cloth, "Cloth from rolls, with end losses.");
    v.required("splices", self.splices, "Cloth that splices take, as many as so much cloth has on an average.");
    v.required("remnants", self.remnants, "Cloth from remnants.");
    v.required("lays", self.lays, "Setting up lays.");
    v.required("plies", self.plies, "Spreading plies.");
    v.required("markers", self.markers, "Making markers.");
    v.required("cutting", self.cutting, "The knife's way.");
  }
};

struct PlanningRound {
  static constexpr std::string_view kName = "PlanningRound", kMeaning = "A round of choosing markers and making them.";
  double estimated{};
  std::optional<double> real;
  double best{};

  static void describe(auto& v, auto& self) {
    v.required("estimated", self.estimated, "Cost of the round's plan at the lengths that chose it.");
    v.required("real", self.real, "Its cost once its markers were made; null when one of them cannot be used.");
    v.required("best", self.best, "The least real cost so far.");
  }
};

// After the style's id and revision.
struct PlanResult {
  std::vector<PlannedMarker> markers;
  std::vector<PlannedLay> lays;
  std::vector<Delivered> delivered;
  std::vector<PlannedRemnant> remnants;
  std::vector<PlannedRolls> rolls;
  double cloth{};
  PlanCosts cost;
  double bound{};
  bool complete{};
  std::size_t candidates{}, made{}, stored{};
  std::vector<PlanningRound> rounds;
  calls::StopCause stop{};

  static void describe(auto& v, auto& self) {
    v.required("markers", self.markers, "The markers that are cut.");
    v.required("lays", self.lays, "Which plies lie under which marker.");
    v.required("delivered", self.delivered, "For every colour and size that is ordered.");
    v.required("remnants", self.remnants, "In the order in which they were given.");
    v.required("rolls", self.rolls, "For every colour.");
    v.required("cloth", self.cloth, "Length of cloth in all plies, with end losses.");
    v.required("cost", self.cost, "What the plan costs.");
    v.required("bound", self.bound,
               "No plan costs less at the lengths that the last round used, where markers that were not made are "
               "estimated.");
    v.required("complete", self.complete, "True: every marker of the plan was made, and is proved valid.");
    v.required("candidates", self.candidates, "Number of ratios that the last round considered.");
    v.required("made", self.made, "Number of markers that were made.");
    v.required("stored", self.stored, "Number of stored markers that the first estimate of lengths was learnt from.");
    v.required("rounds", self.rounds, "What each round came to.");
    v.required("stop", self.stop, calls::kStopMeaning);
  }
};

}  // namespace selvage::protocol::methods::planning
