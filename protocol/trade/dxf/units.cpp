#include "protocol/trade/dxf/units.h"

#include <utility>

#include "protocol/trade/text.h"

namespace selvage::protocol::trade::dxf {
namespace {

std::string word(LengthUnit unit) {
  return std::string{kUnitWords[static_cast<int>(unit)]};
}

std::optional<LengthUnit> unit_of_text(const std::string& text) {
  const std::string capitals = in_capitals(text);
  if (capitals == "METRIC" || capitals == "MM") return LengthUnit::kMillimetre;
  if (capitals == "ENGLISH" || capitals == "IMPERIAL" || capitals == "INCH") return LengthUnit::kInch;
  if (capitals == "CM") return LengthUnit::kCentimetre;
  return std::nullopt;
}

}  // namespace

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
  return Error{
      ErrorCode::kMissingField,
      "the file does not say its unit (neither Units: nor $INSUNITS); one of mm, cm, m, in, ft, yd is required",
      "/unit"};
}

}  // namespace selvage::protocol::trade::dxf
