// The parameters of plan.cut: what is to be cut, from which cloth, within which limits and at which cost.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/planning/orders/order.h"
#include "protocol/calls/results.h"
#include "protocol/methods/library/given_marker.h"
#include "protocol/schema/visitors.h"

namespace selvage::protocol::schema {

template <>
struct Choices<selvage::planning::orders::Spread> {
  static constexpr std::string_view kName = "Spread";
  static constexpr std::string_view kMeaning =
      "How plies are spread: all face up, or in pairs face to face, where the second ply cuts mirrored pieces.";
  static constexpr std::string_view kWords[] = {"one_way", "face_to_face"};
};

}  // namespace selvage::protocol::schema

namespace selvage::protocol::methods::planning {

struct Quantity {
  static constexpr std::string_view kName = "Quantity", kMeaning = "How many garments are ordered.";
  std::string colour, size;
  int garments{};

  static void describe(auto& v, auto& self) {
    v.required("colour", self.colour, "The colour of the cloth.", {.bytes = {{1, 200}}});
    v.required("size", self.size, "The size, as the attributes of the style's pieces or shapes name it.",
               {.bytes = {{1, 200}}});
    v.required("garments", self.garments, "The number of garments, 0 to 1,000,000.",
               {.range = {{0, selvage::planning::orders::kMostGarments}}});
  }
};

struct GivenRemnant {
  static constexpr std::string_view kName = "Remnant", kMeaning = "A length of cloth left over from an earlier order.";
  std::string colour;
  double length{};

  static void describe(auto& v, auto& self) {
    v.required("colour", self.colour, "The colour, which must be one of the order's.", {.bytes = {{1, 200}}});
    v.required("length", self.length, "The length of the remnant, above 0.", {.range = {{1e-6, 1e9}}});
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
    v.required("markerId", self.marker_id, "The style: a marker with one garment of every size.");
    v.required("quantities", self.quantities,
               "What is ordered: 1 to 2,500 entries. Entries of the same colour and size are added up.",
               {.entries = {{1, 2'500}}, .entries_are = "quantities"});
    describe_cloth(v, self);
    describe_limits(v, self);
    describe_costs(v, self);
    describe_search(v, self);
    v.optional(
        "stored", self.stored,
        "Stored markers, as native or sparrow documents. The lengths of markers are first estimated from those that "
        "hold similar garments on similar cloth. Absent: the most similar ones of the library.",
        {.entries = {{0, library::kMostStored}}, .entries_are = "markers"});
    v.optional("documents", self.documents, "Whether the result contains the documents of the markers.");
    v.optional("deadlineMs", self.deadline_ms,
               "After this many milliseconds the best plan so far is returned; 1 to 86,400,000.", calls::kDeadlines);
    v.optional("progressToken", self.progress_token,
               "Progress notifications, one after each round, carry this token. Their length is that of the cloth "
               "which the best plan so far takes.");
  }

 private:
  static constexpr double kLongest = 1e9, kHighest = 1e9;

  static void describe_cloth(auto& v, auto& self) {
    v.optional("spread", self.cloth.spread, "How plies are spread.");
    v.optional("endLoss", self.cloth.end_loss, "Cloth that every ply loses at its two ends together.",
               {.range = {{0, kLongest}}});
    v.optional(
        "rollLength", self.cloth.roll_length,
        "The length of a roll; where a roll ends within a ply, the ply is spliced. 0: rolls are endless. Otherwise "
        "at least the table's length and at least twice the splice loss.",
        {.range = {{0, kLongest}}});
    v.optional("spliceLoss", self.cloth.splice_loss, "Cloth lost in a splice: the length by which two rolls overlap.",
               {.range = {{0, kLongest}}});
    v.optional("remnants", self.remnants,
               "Up to 100 lengths of cloth left over from earlier orders. Plies from remnants are never spliced.",
               {.entries = {{0, selvage::planning::orders::kMostRemnants}}, .entries_are = "remnants"});
  }
  static void describe_limits(auto& v, auto& self) {
    v.optional("plies", self.limits.plies, "Maximum number of plies in a lay, 1 to 1,000.",
               {.range = {{1, selvage::planning::orders::kMostPlies}}});
    v.optional("table", self.limits.table,
               "The length of the table: a ply, including its end loss, is at most this long.",
               {.range = {{1e-6, kLongest}}});
    v.optional("bundles", self.limits.bundles, "Maximum number of bundles in a marker, 1 to 50.",
               {.range = {{1, selvage::planning::orders::kMostBundles}}});
    v.optional(
        "overCut", self.limits.over,
        "How many garments of a colour and size may be cut beyond those ordered, as a fraction of these, 0 to 10.",
        {.range = {{0, 10}}});
    v.optional("underCut", self.limits.under, "How many garments fewer than ordered may be cut, as a fraction, 0 to 1.",
               {.range = {{0, 1}}});
  }
  static void describe_costs(auto& v, auto& self) {
    v.optional("costMetre", self.costs.metre, "The cost of a metre of cloth from rolls.", {.range = {{0, kHighest}}});
    v.optional("costRemnantMetre", self.costs.remnant_metre, "The cost of a metre of cloth from remnants.",
               {.range = {{0, kHighest}}});
    v.optional("costLay", self.costs.lay, "The cost of setting up a lay.", {.range = {{0, kHighest}}});
    v.optional("costPly", self.costs.ply, "The cost of spreading a ply.", {.range = {{0, kHighest}}});
    v.optional("costMarker", self.costs.marker, "The cost of making a marker.", {.range = {{0, kHighest}}});
    v.optional("costCutMetre", self.costs.cut_metre,
               "The cost of cutting a lay, per metre of the outlines in its marker.", {.range = {{0, kHighest}}});
  }
  static void describe_search(auto& v, auto& self) {
    v.optional("gap", self.gap,
               "The search ends when the cost exceeds the bound by at most this fraction of the cost, 0 to 1.",
               {.range = {{0, 1}}});
    v.optional("rounds", self.rounds,
               "Maximum number of rounds, each of which chooses markers and makes them, 1 to 100.",
               {.range = {{1, 100}}});
    v.optional("mostMade", self.most_made,
               "Once this many markers have been made, a round makes only those that its plan needs, 0 to 1,000.",
               {.range = {{0, 1'000}}});
    v.optional("nearMade", self.near_made,
               "How many markers each round makes in addition to those of its plan, 0 to 100.", {.range = {{0, 100}}});
    v.optional("movesPerPiece", self.moves_per_piece,
               "The budget for nesting a marker, in moves for each of its pieces.", {.range = {{0, 1e6}}});
    v.optional("seed", self.seed, "The seed of the random choices in nesting.", {.range = {{0, 9007199254740991.0}}});
  }
};

}  // namespace selvage::protocol::methods::planning
