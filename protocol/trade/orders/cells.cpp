#include "protocol/trade/orders/cells.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>

#include "protocol/trade/text.h"

namespace selvage::protocol::trade::orders {
namespace {

// Only the letters a to z of a cell are put in capitals before it is compared.
constexpr std::string_view kSizeWords[] = {"SIZE",    "SIZES",  "GRößE",   "GRÖßE",     "GRößEN",  "GRöSSE", "GRÖSSE",
                                           "GROESSE", "TAILLE", "TAILLES", "TALLA",     "TALLAS",  "TAGLIA", "TAGLIE",
                                           "TAMANHO", "MAAT",   "STORLEK", "STøRRELSE", "ROZMIAR", "BEDEN",  "Размер",
                                           "РАЗМЕР",  "размер", "尺码",    "尺寸",      "サイズ"};
constexpr std::string_view kQuantityWords[] = {"QUANTITY", "QUANTITIES", "QTY",        "QTY.",     "PCS",   "PIECES",
                                               "GARMENTS", "MENGE",      "ANZAHL",     "STüCK",    "STÜCK", "STUECK",
                                               "STK",      "STK.",       "QUANTITé",   "QUANTITÉ", "QTé",   "CANTIDAD",
                                               "QUANTITà", "QUANTITÀ",   "QUANTIDADE", "AANTAL",   "ANTAL", "ADET",
                                               "MIKTAR",   "Количество", "КОЛИЧЕСТВО", "数量",     "件数"};
constexpr std::string_view kColourWords[] = {"COLOUR",   "COLOURS", "COLOR",  "COLORS", "FARBE", "FARBEN", "COULEUR",
                                             "COULEURS", "COLORE",  "COLORI", "COR",    "KLEUR", "FäRG",   "FARVE",
                                             "KOLOR",    "RENK",    "Цвет",   "ЦВЕТ",   "цвет",  "颜色",   "色"};
constexpr std::string_view kSumWords[] = {"TOTAL",  "TOTALS", "SUM",    "SUMME",  "GESAMT", "SOMME",
                                          "TOTALE", "SUMA",   "TOTAAL", "TOPLAM", "Итого",  "合计"};

template <std::size_t N>
bool is_among(std::string_view cell, const std::string_view (&words)[N]) {
  std::string capitals = in_capitals(trimmed(cell));
  while (capitals.ends_with(':')) capitals.pop_back();
  return std::find(std::begin(words), std::end(words), capitals) != std::end(words);
}

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

// "1 200" with the unbreakable blanks that spreadsheets put between thousands.
void make_blanks_plain(std::string& cell) {
  for (const std::string_view blank : {"\u00a0", "\u202f", "\u2009"}) {
    for (std::size_t at; (at = cell.find(blank)) != std::string::npos;) cell.replace(at, blank.size(), " ");
  }
}

// "20,00" becomes "20", and "1.200,000" becomes "1.200"; "12,000" stays, because it groups its thousands.
void drop_zero_fraction(std::string& cell) {
  constexpr std::size_t kGroup = 3;
  const std::size_t mark = cell.find_last_of(",.");
  if (mark == std::string::npos || mark == 0 || mark + 1 == cell.size()) return;
  if (cell.find_first_not_of('0', mark + 1) != std::string::npos) return;
  const std::size_t first = cell.find_first_of(",.' ");
  if (cell.size() - mark - 1 == kGroup && cell[first] == cell[mark]) return;
  cell.erase(mark);
}

// One of S, M and L, with X before it or a number of them; or up to three digits.
bool is_one_size(std::string_view size) {
  constexpr std::size_t kMostDigits = 3;
  std::size_t digits = 0;
  while (digits < size.size() && is_digit(size[digits])) ++digits;
  if (digits > kMostDigits) return false;
  const std::string_view letters = size.substr(digits);
  if (letters.empty()) return digits > 0;
  const std::size_t crosses = std::min(letters.find_first_not_of('X'), letters.size());
  const std::string_view last = letters.substr(crosses);
  if (last.size() != 1 || (digits > 0 && crosses != 1)) return false;
  return last == "S" || last == "L" || (last == "M" && crosses == 0);
}

}  // namespace

std::vector<std::string> cells_of(std::string_view line, char separator) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t at = 0; at < line.size(); ++at) {
    const char c = line[at];
    if (c == '"' && quoted && line.substr(at + 1, 1) == "\"") {
      cells.back() += line[at++];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == separator && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  for (std::string& cell : cells) cell = std::string{trimmed(cell)};
  return cells;
}

std::optional<Garments> garments_in(std::string cell, double most) {
  Garments garments;
  if (cell.empty()) return garments;
  make_blanks_plain(cell);
  drop_zero_fraction(cell);
  const std::size_t mark = cell.find_first_of(",.' ");
  if (mark != std::string::npos && mark <= 3) {
    const char grouping = cell[mark];
    bool groups = true;  // of three digits after every mark
    for (std::size_t at = mark; at < cell.size(); at += 4)
      groups = groups && cell[at] == grouping && at + 4 <= cell.size();
    garments.ambiguous = groups && (grouping == ',' || grouping == '.') && cell.substr(mark + 1) == "000";
    if (groups) std::erase(cell, grouping);
  }
  const auto number = number_in(cell);
  if (!number || *number != std::floor(*number) || *number < 0 || *number > most) return std::nullopt;
  garments.count = static_cast<int>(*number);
  return garments;
}

bool names_sizes(std::string_view cell) {
  return is_among(cell, kSizeWords);
}
bool names_quantities(std::string_view cell) {
  return is_among(cell, kQuantityWords);
}
bool names_colours(std::string_view cell) {
  return is_among(cell, kColourWords);
}
bool names_sum(std::string_view cell) {
  return is_among(cell, kSumWords);
}

bool is_usual_size(std::string_view cell) {
  const std::string capitals = in_capitals(trimmed(cell));
  const std::size_t slash = capitals.find('/');
  if (slash == std::string::npos) return is_one_size(capitals);
  return is_one_size(std::string_view{capitals}.substr(0, slash)) &&
         is_one_size(std::string_view{capitals}.substr(slash + 1));
}

}  // namespace selvage::protocol::trade::orders
