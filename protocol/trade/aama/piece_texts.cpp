#include "protocol/trade/aama/piece_texts.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "protocol/json/json_text.h"
#include "protocol/trade/text.h"

namespace selvage::protocol::trade::aama {
namespace {

// "2", or "1,1": right and left.
std::optional<Quantity> quantity_in(const std::string& text) {
  const std::size_t comma = text.find(',');
  const auto right = whole_number_in(trimmed(std::string_view{text}.substr(0, comma)));
  const auto left = comma == std::string::npos ? std::optional{0}
                                               : whole_number_in(trimmed(std::string_view{text}.substr(comma + 1)));
  const auto sensible = [](std::optional<int> n) { return n && *n >= 0 && *n <= kMostCopies; };
  if (!sensible(right) || !sensible(left)) return std::nullopt;
  return Quantity{*right, *left};
}

}  // namespace

const std::string& text_or_empty(const Texts& texts, const std::string& key) {
  static const std::string kEmpty;
  const auto found = texts.find(key);
  return found == texts.end() ? kEmpty : found->second;
}

std::string in_quotes(const std::string& text) {
  return json::shortened(Json(text));
}

PatternPiece described(const PatternBlock& block, const std::string& name, std::vector<Note>& notes) {
  PatternPiece piece;
  piece.name = name;
  piece.line = block.line;
  piece.material = text_or_empty(block.texts, "MATERIAL");
  piece.category = text_or_empty(block.texts, "CATEGORY");
  piece.annotation = text_or_empty(block.texts, "ANNOTATION");
  for (const auto& [key, attribute] :
       {std::pair{"ROTATION", "rotation"}, {"FLIP", "flip"}, {"TILT", "tilt"}, {"FOLD", "fold"}}) {
    if (const std::string* text = block.text(key)) piece.attributes[attribute] = *text;
  }
  const std::string* said = block.text("QUANTITY");
  const auto quantity = said ? quantity_in(*said) : std::nullopt;
  if (!said) {
    notes.push_back(note_at(block.line, "no quantity: 1"));
  } else if (!quantity) {
    notes.push_back(note_at(block.line, "the quantity " + in_quotes(*said) + " is not understood: 1"));
  } else if (quantity->right > 1 && said->find(',') == std::string::npos) {
    notes.push_back(note_at(
        block.line, "quantity " + *said + ": the file does not say whether some of them are mirrored; none is"));
  }
  piece.quantity = quantity.value_or(Quantity{});
  return piece;
}

void check_extent(const PatternPiece& piece, std::vector<Note>& notes) {
  constexpr double kLeast = 10, kMost = 5000;
  Spot low = piece.outline.front(), high = low;
  for (const Spot& point : piece.outline) {
    low = {std::min(low.x, point.x), std::min(low.y, point.y)};
    high = {std::max(high.x, point.x), std::max(high.y, point.y)};
  }
  const double extent = std::max(high.x - low.x, high.y - low.y);
  if (extent >= kLeast && extent <= kMost) return;
  notes.push_back(note_at(piece.line, "the piece is " + json::number_text(std::round(extent * 100) / 100) +
                                          " mm long: is the unit right?"));
}

}  // namespace selvage::protocol::trade::aama
