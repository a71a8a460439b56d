// The result of plan.cut: the markers, the lays, the cloth that they take, and what the plan costs.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "protocol/calls/results.h"
#include "protocol/schema/documents.h"
#include "protocol/schema/visitors.h"

namespace selvage::protocol::methods::planning {

struct BundlesOfSize {
  static constexpr std::string_view kName = "BundlesOfSize",
                                    kMeaning = "The number of bundles of one size in a marker.";
  std::string size;
  int bundles{};

  static void describe(auto& v, auto& self) {
    v.required("size", self.size, "The size.");
    v.required("bundles", self.bundles, "The number of bundles, at least 1.");
  }
};

struct PliesOfColour {
  static constexpr std::string_view kName = "PliesOfColour",
                                    kMeaning = "Plies of one colour in a lay, all from rolls or all from one remnant.";
  std::string colour;
  int plies{};
  std::optional<std::size_t> remnant;

  static void describe(auto& v, auto& self) {
    v.required("colour", self.colour, "The colour.");
    v.required("plies", self.plies, "The number of plies, at least 1.");
    v.optional("remnant", self.remnant,
               "The index of the remnant that the plies are cut from, from 0; absent: they are cut from rolls.");
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
    v.required("ratio", self.ratio, "The sizes in the marker.");
    v.required("made", self.made,
               "Whether the marker was made. If not, the search ended before, and the length is an estimate.");
    v.required("length", self.length, "The length of the marker, without the end loss.");
    v.required("utilisation", self.utilisation, "The pieces' area divided by width times length, 0 to 1.");
    v.required("lays", self.lays, "Number of lays that are cut with the marker.");
    v.required("plies", self.plies, "Number of plies in all these lays.");
    v.required("cloth", self.cloth, "Length of cloth in these plies, including end losses.");
    v.required("cost", self.cost, "The cost of making the marker and cutting its lays, cloth included.");
    v.optional("marker", self.marker,
               "The marker as a native document; absent if it was not made or documents were not requested.");
  }
};

struct PlannedLay {
  static constexpr std::string_view kName = "PlannedLay", kMeaning = "A lay of a plan.";
  std::size_t marker{};
  std::vector<PliesOfColour> plies;

  static void describe(auto& v, auto& self) {
    v.required("marker", self.marker, "The index of the lay's marker in markers, from 0.");
    v.required("plies", self.plies, "The plies, from the lowest to the uppermost.");
  }
};

struct Delivered {
  static constexpr std::string_view kName = "Delivered", kMeaning = "How many garments of a colour and size are cut.";
  std::string colour, size;
  int ordered{}, cut{};

  static void describe(auto& v, auto& self) {
    v.required("colour", self.colour, "The colour.");
    v.required("size", self.size, "The size.");
    v.required("ordered", self.ordered, "Number of garments ordered.");
    v.required("cut", self.cut, "Number of garments cut.");
  }
};

struct PlannedRemnant {
  static constexpr std::string_view kName = "PlannedRemnant", kMeaning = "How a plan uses a remnant.";
  std::string colour;
  double length{}, used{}, left{};
  int plies{};

  static void describe(auto& v, auto& self) {
    v.required("colour", self.colour, "The colour.");
    v.required("length", self.length, "The length of the remnant.");
    v.required("plies", self.plies, "Number of plies cut from the remnant.");
    v.required("used", self.used, "The length of these plies, including end losses.");
    v.required("left", self.left, "The length that remains.");
  }
};

struct PlannedRolls {
  static constexpr std::string_view
      kName = "PlannedRolls",
      kMeaning = "How a plan uses the rolls of a colour, when its lays are spread one after another.";
  std::string colour;
  double cloth{}, lost{}, left{};
  int rolls{}, splices{};

  static void describe(auto& v, auto& self) {
    v.required("colour", self.colour, "The colour.");
    v.required("cloth", self.cloth, "The length of the plies cut from rolls, including end losses.");
    v.required("rolls", self.rolls, "Number of rolls that are opened; 0 if rolls are endless.");
    v.required("splices", self.splices, "Number of spliced plies.");
    v.required("lost", self.lost, "Length lost in splices and in roll ends that are too short to be spliced.");
    v.required("left", self.left, "The length that remains of the last roll: a remnant for another order.");
  }
};

struct PlanCosts {
  static constexpr std::string_view kName = "PlanCosts", kMeaning = "What a plan costs.";
  double total{}, cloth{}, splices{}, remnants{}, lays{}, plies{}, markers{}, cutting{};

  static void describe(auto& v, auto& self) {
    v.required("total", self.total, "The sum of the costs.");
    v.required("cloth", self.cloth, "Cloth from rolls, including end losses.");
    v.required("splices", self.splices,
               "Cloth lost in splices, computed from the average number of splices in this much cloth.");
    v.required("remnants", self.remnants, "Cloth from remnants.");
    v.required("lays", self.lays, "Setting up lays.");
    v.required("plies", self.plies, "Spreading plies.");
    v.required("markers", self.markers, "Making markers.");
    v.required("cutting", self.cutting, "Cutting along the outlines.");
  }
};

struct PlanningRound {
  static constexpr std::string_view kName = "PlanningRound",
                                    kMeaning = "A round, which chooses markers and makes them.";
  double estimated{};
  std::optional<double> real;
  double best{};

  static void describe(auto& v, auto& self) {
    v.required("estimated", self.estimated,
               "The cost of the round's plan at the lengths by which it was chosen, some of them estimates.");
    v.required("real", self.real, "Its cost at the lengths of the markers made; null if one of them cannot be used.");
    v.required("best", self.best, "The lowest real cost so far.");
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
    v.required("lays", self.lays, "The lays, each with its marker and its plies.");
    v.required("delivered", self.delivered, "How many garments are cut, for every colour and size ordered.");
    v.required("remnants", self.remnants, "How each remnant is used, in the order in which they were given.");
    v.required("rolls", self.rolls, "How the rolls of each colour are used.");
    v.required("cloth", self.cloth, "Length of cloth in all plies, including end losses.");
    v.required("cost", self.cost, "What the plan costs.");
    v.required(
        "bound", self.bound,
        "A lower bound on the cost of any plan at the lengths that the last round used. Markers that were not made "
        "have estimated lengths.");
    v.required("complete", self.complete, "Whether every marker of the plan was made; each of these is proved valid.");
    v.required("candidates", self.candidates, "Number of ratios that the last round considered.");
    v.required("made", self.made, "Number of markers that were made.");
    v.required("stored", self.stored, "Number of stored markers from which the lengths were first estimated.");
    v.required("rounds", self.rounds, "The result of each round.");
    v.required("stop", self.stop, calls::kStopMeaning);
  }
};

}  // namespace selvage::protocol::methods::planning
