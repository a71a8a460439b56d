// Sets cloth's rules for a whole marker at once (docs/cloth-rules.md), for files that contain none: on the command
// line, and when a marker is opened.  Fields that are absent do not change the file.  Units: the marker's.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "protocol/document/marker_file.h"
#include "protocol/edits/edits.h"

namespace selvage::protocol::edits {

// The directions of all pieces on cloth with a nap.
enum class ClothNap { kUp, kDown, kUpAndDown };

}  // namespace selvage::protocol::edits

namespace selvage::protocol::schema {

template <>
struct Choices<edits::ClothNap> {
  static constexpr std::string_view kName = "ClothNap";
  static constexpr std::string_view kMeaning =
      "How pieces lie on cloth with a nap: all up, all down, or one bundle up and the next one down.";
  static constexpr std::string_view kWords[] = {"up", "down", "up_and_down"};
};

}  // namespace selvage::protocol::schema

namespace selvage::protocol::edits {

struct ClothZone {
  static constexpr std::string_view
      kName = "ClothZone",
      kMeaning = "A rectangle of the cloth that no piece may cover, or only pieces that accept its quality.";
  formats::Decimal from{}, to{};
  std::optional<marker::Quality> quality{};

  static void describe(auto& v, auto& self) {
    v.required("from", self.from, "Its lower left corner.");
    v.required("to", self.to, "Its upper right corner.");
    v.optional("quality", self.quality, "The quality class of its cloth; absent: one that no piece accepts.",
               {.range = {{1, marker::kWorstQuality}}});
  }
};

// Pieces that are cut roughly first: the outline is widened on the sides that have a length.
struct BlocksOfShape {
  static constexpr std::string_view kName = "BlocksOfShape",
                                    kMeaning = "How much larger than its outline a shape is cut at first.";
  std::optional<std::string> shape{};
  double left{}, right{}, below{}, above{};

  static void describe(auto& v, auto& self) {
    v.optional("shape", self.shape, "The id of the shape; absent: every shape.");
    v.optional("left", self.left, "Towards smaller x, in the coordinates of the shape.", kLengths);
    v.optional("right", self.right, "Towards larger x.", kLengths);
    v.optional("below", self.below, "Towards smaller y.", kLengths);
    v.optional("above", self.above, "Towards larger y.", kLengths);
  }
};

struct RulesOfPieces {
  static constexpr std::string_view kName = "RulesOfPieces",
                                    kMeaning = "The rules of a piece, or of every piece of a shape.";
  std::optional<std::string> piece{}, shape{};
  formats::DecimalRules rules{};

  static void describe(auto& v, auto& self) {
    v.optional("piece", self.piece, "The id of the piece.");
    v.optional("shape", self.shape, "The id of the shape, instead of a piece.");
    v.required("rules", self.rules, "The complete rules, which replace all earlier ones.");
    v.check(one_of("piece", "shape"));
  }
};

struct Cloth {
  static constexpr std::string_view kGroup = "cloth";
  std::optional<double> margin{}, margin_below{}, margin_above{};
  std::optional<double> repeat_along{}, repeat_across{};
  std::optional<formats::Decimal> repeat_phase{};
  std::optional<double> shade{};
  std::optional<ClothNap> nap_direction{};
  std::optional<bool> tube{}, open_holes{};
  std::optional<std::vector<ClothZone>> zones{};
  std::optional<std::vector<RulesOfPieces>> piece_rules{};
  std::optional<std::vector<BlocksOfShape>> blocks{};

  static void describe(auto& v, auto& self) {
    v.optional("margin", self.margin, "Distance of pieces from the strip's long edges and from the ends of the cloth.",
               kLengths);
    v.optional("marginBelow", self.margin_below, "Distance from the lower edge, in place of the margin.", kLengths);
    v.optional("marginAbove", self.margin_above, "Distance from the upper edge, in place of the margin.", kLengths);
    v.optional("repeatAlong", self.repeat_along, "Length of the pattern's repeat in x; 0 for none.", kLengths);
    v.optional("repeatAcross", self.repeat_across, "Length of the pattern's repeat in y; 0 for none.", kLengths);
    v.optional("repeatPhase", self.repeat_phase, "A point at which a repeat begins.");
    v.optional("shade", self.shade,
               "Length along the strip within which the pieces of a shade must lie; pieces without a shade belong to "
               "that of their bundle.",
               {.range = {{1e-6, formats::kStripWidths.most}}});
    v.optional("napDirection", self.nap_direction,
               "How all pieces lie on cloth with a nap; with up_and_down, every second bundle lies down.");
    v.optional("tube", self.tube, "True: the cloth is a tube, whose upper edge is a fold like the lower one.");
    v.optional("openHoles", self.open_holes,
               "True: other pieces may lie in the holes of a piece, which are filled otherwise.");
    v.optional(
        "zones", self.zones,
        R"(Rectangles of the cloth that no piece, or only some pieces, may cover: [{"from": [X, Y], "to": [X, Y]}].)",
        {.entries = {{0, marker::kMaxPieces}}, .entries_are = "zones"});
    v.optional("pieceRules", self.piece_rules,
               R"(Rules of single pieces or shapes: [{"shape": "collar", "rules": {"match": [0, 0]}}].)",
               {.entries = {{0, kMaxEdits}}, .entries_are = "pieces or shapes"});
    v.optional(
        "blocks", self.blocks,
        R"(Shapes that are cut roughly first, larger on some sides: [{"shape": "collar", "left": 5, "above": 5}].)",
        {.entries = {{0, kMaxEdits}}, .entries_are = "shapes"});
  }
};

// The file with these rules.  A piece that lies against its nap is rotated about its middle if its shape allows that
// and it has neither a lock nor a group.  Of several rules for a piece the last ones count.  Holes are the closed
// cut-outs among the annotations of a shape.  Notes report rotated pieces, a shade without pieces, and holes that
// cannot be opened.  Errors: those of make_marker; kBeyondLattice; kOutOfRange for a piece or shape that the marker
// does not have, for a second block of a shape and for up_and_down where no piece has a bundle; `field` points into the
// file or at the field of Cloth.
[[nodiscard]] Result<MarkerFile> with_cloth(MarkerFile file, const Cloth& cloth);

}  // namespace selvage::protocol::edits
