#include "protocol/trade/aama/piece_texts.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

#include "protocol/json/json_text.h"
#include "protocol/trade/text.h"

namespace selvage::protocol::trade::aama {
namespace {

// The words and numbers of a quantity, apart: "L1 R1" has four.  None when there is anything else.
std::optional<std::vector<std::string>> tokens_of(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789.", kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ", kBetween = " \t,;/=:+()";
  const std::string capitals = in_capitals(text);
  std::vector<std::string> tokens;
  for (std::size_t at = 0; at < capitals.size();) {
    if (kBetween.find(capitals[at]) != std::string_view::npos) {
      ++at;
      continue;
    }
    const std::string_view kind = kDigits.find(capitals[at]) != std::string_view::npos ? kDigits : kLetters;
    const std::size_t end = std::min(capitals.find_first_not_of(kind, at), capitals.size());
    if (end == at) return std::nullopt;
    tokens.push_back(capitals.substr(at, end - at));
    at = end;
  }
  return tokens;
}

struct SaidQuantity {
  Quantity quantity;
  bool sides{};  // it says which copies are mirrored
};

// "2", "1,1" (right and left), "2 (1+1)", "L1 R1", "1 pair", "2 pcs", "cut 2 on fold".
std::optional<SaidQuantity> quantity_in(std::string_view text) {
  static const std::set<std::string, std::less<>> kUnimportant{"CUT", "QTY", "QUANTITY", "ON", "FOLD"};
  auto tokens = tokens_of(text);
  if (!tokens) return std::nullopt;
  std::erase_if(*tokens, [](const std::string& token) { return kUnimportant.contains(token); });
  std::vector<int> numbers;
  std::vector<std::string> words;
  for (const std::string& token : *tokens) {
    const auto number = number_in(token);
    if (!number) {
      words.push_back(token);
    } else if (*number == std::floor(*number) && *number <= kMostCopies) {
      numbers.push_back(static_cast<int>(*number));
    } else {
      return std::nullopt;
    }
  }
  const auto all_of = [&](const std::set<std::string, std::less<>>& known) {
    return !words.empty() &&
           std::all_of(words.begin(), words.end(), [&](const auto& word) { return known.contains(word); });
  };
  if (words.empty() && numbers.size() == 1) return SaidQuantity{{numbers[0], 0}, false};
  const bool sum = numbers.size() == 3 && numbers[0] == numbers[1] + numbers[2];
  if (words.empty() && sum) return SaidQuantity{{numbers[1], numbers[2]}, true};
  if (words.empty() && numbers.size() == 2) return SaidQuantity{{numbers[0], numbers[1]}, true};
  if (words.size() == 1 && numbers.size() < 2 && all_of({"PAIR", "PAIRS", "PR", "PRS"})) {
    const int pairs = numbers.empty() ? 1 : numbers[0];
    return SaidQuantity{{pairs, pairs}, true};
  }
  if (words.size() == 1 && numbers.size() == 1 && all_of({"X", "PC", "PCS", "PIECE", "PIECES"})) {
    return SaidQuantity{{numbers[0], 0}, false};
  }
  if (words.size() != numbers.size() || words.size() > 2 || !all_of({"L", "LEFT", "R", "RIGHT"})) return std::nullopt;
  if (words.size() == 2 && words[0].front() == words[1].front()) return std::nullopt;
  SaidQuantity said{{0, 0}, true};
  for (std::size_t k = 0; k < words.size(); ++k) {
    (words[k].front() == 'R' ? said.quantity.right : said.quantity.left) = numbers[k];
  }
  return said;
}

// A text such as "CUT 1 PAIR" or "QTY 1,1", which is no pair of key and value; null if there is none.
const std::string* free_quantity(const PatternBlock& block) {
  const auto begins = [](const std::string& text) {
    const std::string capitals = in_capitals(text);
    return capitals.starts_with("CUT ") || capitals.starts_with("QTY ") || capitals.starts_with("QUANTITY ");
  };
  for (const document::DrawnText& one : block.annotations.texts) {
    if (begins(one.text) && quantity_in(one.text)) return &one.text;
  }
  return nullptr;
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
  if (!said && (said = free_quantity(block))) {
    notes.push_back(note_at(block.line, "no Quantity: the text " + in_quotes(*said) + " is taken for it"));
  }
  const auto quantity = said ? quantity_in(*said) : std::nullopt;
  if (!said && block.inserted > 0 && block.inserted_mirrored > 0) {
    piece.quantity = {block.inserted, block.inserted_mirrored};
  } else if (!said) {
    notes.push_back(note_at(block.line, "no quantity: 1"));
  } else if (!quantity) {
    notes.push_back(note_at(block.line, "the quantity " + in_quotes(*said) +
                                            " is not understood: 1; a quantity is 2, 1,1, L1 R1 or 1 pair"));
  } else if (quantity->quantity.right > 1 && !quantity->sides) {
    notes.push_back(note_at(
        block.line, "quantity " + *said + ": the file does not say whether some of them are mirrored; none is"));
  }
  if (quantity) piece.quantity = quantity->quantity;
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
