#include "server/library/entry.h"

#include <charconv>

#include "protocol/json/json_text.h"

namespace selvage::server::library {
namespace {

// FNV-1a: the same on every machine.
std::uint64_t hash_of(const std::string& text) {
  std::uint64_t hash = 14695981039346656037U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
  return hash;
}

}  // namespace

std::string id_of(const Entry& entry) {
  return "s" + std::to_string(entry.number);
}

std::optional<std::uint64_t> number_of(const std::string& id) {
  std::uint64_t number = 0;
  if (id.size() < 2 || id.front() != 's' || id[1] == '0') return std::nullopt;
  const auto read = std::from_chars(id.data() + 1, id.data() + id.size(), number);
  if (read.ec != std::errc{} || read.ptr != id.data() + id.size()) return std::nullopt;
  return number;
}

Entry entry_of(const Marker& marker, const std::string& style, const std::string& document) {
  return {.number = 0,
          .name = marker.name,
          .style = style,
          .length = to_decimal(length_of(marker), marker.resolution),
          .utilisation = utilisation_of(marker),
          .content = hash_of(document),
          .signature = matching::signature_of(marker)};
}

std::string figures_text(const Entry& entry) {
  const matching::Signature& signature = entry.signature;
  Json spread = Json::array();
  for (const float value : signature.spread) spread.push_back(static_cast<double>(value));
  Json figures = Json::object();
  figures["name"] = entry.name;
  figures["style"] = entry.style;
  figures["length"] = entry.length;
  figures["utilisation"] = entry.utilisation;
  figures["content"] = std::to_string(entry.content);
  figures["unit"] = signature.unit;
  figures["width"] = signature.width;
  figures["spacing"] = signature.spacing;
  figures["pieces"] = signature.pieces;
  figures["area"] = signature.area;
  figures["spread"] = spread;
  return protocol::json::to_text(figures);
}

std::optional<Entry> read_figures(std::uint64_t number, const std::string& text) {
  const auto figures = protocol::json::parse(text);
  if (!figures || !figures->is_object()) return std::nullopt;
  for (const char* name : {"name", "style", "content", "unit"}) {
    if (!figures->contains(name) || !(*figures)[name].is_string()) return std::nullopt;
  }
  for (const char* name : {"length", "utilisation", "width", "spacing", "pieces", "area"}) {
    if (!figures->contains(name) || !(*figures)[name].is_number()) return std::nullopt;
  }
  if (!figures->contains("spread") || !(*figures)["spread"].is_array()) return std::nullopt;
  const auto text_of = [&](const char* name) { return (*figures)[name].get<std::string>(); };
  const auto number_at = [&](const char* name) { return (*figures)[name].number(); };
  Entry entry{.number = number,
              .name = text_of("name"),
              .style = text_of("style"),
              .length = number_at("length"),
              .utilisation = number_at("utilisation"),
              .content = 0,
              .signature = {}};
  const std::string content = text_of("content");
  std::from_chars(content.data(), content.data() + content.size(), entry.content);
  entry.signature.unit = text_of("unit");
  entry.signature.width = number_at("width");
  entry.signature.spacing = number_at("spacing");
  entry.signature.pieces = number_at("pieces");
  entry.signature.area = number_at("area");
  const Json& spread = (*figures)["spread"];
  if (spread.size() != entry.signature.spread.size()) return std::nullopt;
  for (std::size_t k = 0; k < spread.size(); ++k) {
    if (!spread[k].is_number()) return std::nullopt;
    entry.signature.spread[k] = static_cast<float>(spread[k].number());
  }
  return entry;
}

}  // namespace selvage::server::library
