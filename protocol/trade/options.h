// Options for reading trade files, for information that such files often do not contain.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace selvage::protocol::trade {

enum class LengthUnit { kMillimetre, kCentimetre, kMetre, kInch, kFoot, kYard };
inline constexpr std::string_view kUnitWords[] = {"mm", "cm", "m", "in", "ft", "yd"};  // by LengthUnit
[[nodiscard]] constexpr double in_millimetres(LengthUnit unit) {
  constexpr double kFactors[] = {1, 10, 1000, 25.4, 304.8, 914.4};
  return kFactors[static_cast<int>(unit)];
}

// What happens to a half piece that is drawn up to its mirror line: it is unfolded, kept as drawn, or laid on the fold
// of cloth in two layers, where every other piece is cut as a pair.
enum class FoldRule { kUnfold, kKeep, kLay };
inline constexpr std::string_view kFoldWords[] = {"unfold", "keep", "lay"};  // by FoldRule

// The directions that the nap of the cloth allows: pieces at 0 degrees only, or at 0 and 180.
enum class Nap { kOneWay, kEitherWay };
inline constexpr std::string_view kNapWords[] = {"one_way", "either_way"};  // by Nap

struct ReadingOptions {
  std::optional<LengthUnit> unit;  // of the file's coordinates; if absent, the unit in the file
  double tolerance{0.05};          // millimetres: how far a polygon may lie from the curve that it replaces
  FoldRule fold{FoldRule::kUnfold};
  Nap nap{Nap::kOneWay};
  std::optional<double> width;       // of the cloth, millimetres; none: what the file says, or kUsualWidth
  std::vector<std::string> sizes;    // of a graded style; empty: all sizes in the file
  std::optional<std::string> rules;  // the text of the style's .rul file
  std::optional<std::string> order;  // the text of an order: the pieces of its bundles are cut
  bool one_of_each_size{};           // of the order's sizes, one bundle each, whatever its ratio is
  bool plain{};                      // a DXF without pattern pieces: every closed outline is a piece
};

inline constexpr double kUsualWidth = 1500;  // millimetres; used if no width is given

}  // namespace selvage::protocol::trade
