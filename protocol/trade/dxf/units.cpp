#include "protocol/trade/dxf/units.h"

#include <utility>

#include "protocol/trade/text.h"

namespace selvage::protocol::trade::dxf {
namespace {

std::string word(LengthUnit unit) {
  return std::string{kUnitWords[static_cast<int>(unit)]};
}

}  // namespace

std::optional<LengthUnit> unit_of_text(std::string_view text) {
  struct Known {
    std::string_view word;
    LengthUnit unit;
  };
  static constexpr Known kWords[] = {{"METRIC", LengthUnit::kMillimetre},
                                     {"MM", LengthUnit::kMillimetre},
                                     {"MILLIMETER", LengthUnit::kMillimetre},
                                     {"MILLIMETERS", LengthUnit::kMillimetre},
                                     {"MILLIMETRE", LengthUnit::kMillimetre},
                                     {"MILLIMETRES", LengthUnit::kMillimetre},
                                     {"CM", LengthUnit::kCentimetre},
                                     {"CENTIMETER", LengthUnit::kCentimetre},
                                     {"CENTIMETERS", LengthUnit::kCentimetre},
                                     {"CENTIMETRE", LengthUnit::kCentimetre},
                                     {"CENTIMETRES", LengthUnit::kCentimetre},
                                     {"ENGLISH", LengthUnit::kInch},
                                     {"IMPERIAL", LengthUnit::kInch},
                                     {"INCH", LengthUnit::kInch},
                                     {"INCHES", LengthUnit::kInch},
                                     {"IN", LengthUnit::kInch},
                                     {"\"", LengthUnit::kInch},
                                     {"FOOT", LengthUnit::kFoot},
                                     {"FEET", LengthUnit::kFoot},
                                     {"FT", LengthUnit::kFoot},
                                     {"YARD", LengthUnit::kYard},
                                     {"YARDS", LengthUnit::kYard},
                                     {"YD", LengthUnit::kYard},
                                     {"METER", LengthUnit::kMetre},
                                     {"METERS", LengthUnit::kMetre},
                                     {"METRE", LengthUnit::kMetre},
                                     {"METRES", LengthUnit::kMetre},
                                     {"M", LengthUnit::kMetre}};
  text = trimmed(text);
  const std::string capitals = in_capitals(text.substr(0, text.find_first_of(" (")));  // "Metric (mm)"
  for (const Known& known : kWords) {
    if (capitals == known.word) return known.unit;
  }
  return std::nullopt;
}

std::optional<LengthUnit> unit_of_insunits(int value) {
  switch (value) {
    case 1: return LengthUnit::kInch;
    case 2: return LengthUnit::kFoot;
    case 4: return LengthUnit::kMillimetre;
    case 5: return LengthUnit::kCentimetre;
    case 6: return LengthUnit::kMetre;
    case 10: return LengthUnit::kYard;
    default: return std::nullopt;
  }
}

Result<double> settle_unit(const std::map<std::string, std::string>& texts, std::optional<int> insert_units,
                           std::optional<LengthUnit> asked, std::vector<Note>& notes) {
  const auto said = texts.find("UNITS");
  const auto by_text = said == texts.end() ? std::nullopt : unit_of_text(said->second);
  const auto by_header = insert_units ? unit_of_insunits(*insert_units) : std::nullopt;
  const auto settle = [&](LengthUnit unit, const std::string& why) {
    notes.push_back({"", "unit: " + word(unit) + why});
    for (const auto& [source, other] : {std::pair{"its text Units:", &by_text}, {"its $INSUNITS", &by_header}}) {
      if (*other && word(**other) != word(unit)) notes.push_back({"", std::string{source} + " says " + word(**other)});
    }
    return in_millimetres(unit);
  };
  if (asked) return settle(*asked, ", as asked for");
  if (by_text) return settle(*by_text, ", since the file says Units: " + said->second);
  if (by_header) return settle(*by_header, ", by $INSUNITS");
  const std::string why = said == texts.end() ? "the file does not say its unit (neither Units: nor $INSUNITS)"
                                              : "the file's unit is not known: it says Units: " + said->second;
  return Error{ErrorCode::kMissingField, why + "; one of mm, cm, m, in, ft, yd is required", "/unit"};
}

}  // namespace selvage::protocol::trade::dxf
