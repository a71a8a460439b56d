#include "protocol/library/stored_figures.h"

#include <algorithm>

namespace selvage::protocol::library {

StoredFigures stored_figures_of(const Marker& marker) {
  return {.name = marker.name,
          .length = to_decimal(length_of(marker), marker.resolution),
          .utilisation = utilisation_of(marker),
          .signature = matching::signature_of(marker)};
}

Json figures_document(const StoredFigures& figures) {
  const matching::Signature& signature = figures.signature;
  Json spread = Json::array();
  for (const float value : signature.spread) spread.push_back(static_cast<double>(value));
  Json document = Json::object();
  document["name"] = figures.name;
  document["length"] = figures.length;
  document["utilisation"] = figures.utilisation;
  document["unit"] = signature.unit;
  document["width"] = signature.width;
  document["spacing"] = signature.spacing;
  document["pieces"] = signature.pieces;
  document["area"] = signature.area;
  document["spread"] = spread;
  return document;
}

std::optional<StoredFigures> read_stored_figures(const Json& document) {
  const auto has = [&](const char* name) { return document.contains(name); };
  if (!document.is_object()) return std::nullopt;
  for (const char* name : {"name", "unit"}) {
    if (!has(name) || !document[name].is_string()) return std::nullopt;
  }
  for (const char* name : {"length", "utilisation", "width", "spacing", "pieces", "area"}) {
    if (!has(name) || !document[name].is_number()) return std::nullopt;
  }
  StoredFigures figures;
  matching::Signature& signature = figures.signature;
  if (!has("spread") || !document["spread"].is_array()) return std::nullopt;
  const Json& spread = document["spread"];
  if (spread.size() != signature.spread.size()) return std::nullopt;
  for (std::size_t k = 0; k < spread.size(); ++k) {
    if (!spread[k].is_number()) return std::nullopt;
    signature.spread[k] = static_cast<float>(spread[k].number());
  }
  figures.name = document["name"].get<std::string>();
  figures.length = document["length"].number();
  figures.utilisation = document["utilisation"].number();
  signature.unit = document["unit"].get<std::string>();
  signature.width = document["width"].number();
  signature.spacing = document["spacing"].number();
  signature.pieces = document["pieces"].number();
  signature.area = document["area"].number();
  return figures;
}

}  // namespace selvage::protocol::library
