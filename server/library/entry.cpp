#include "server/library/entry.h"

#include <charconv>

#include "core/base/fnv1a.h"
#include "protocol/json/json_text.h"

namespace selvage::server::library {

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
  return {protocol::library::stored_figures_of(marker), 0, style, Fnv1a{}.add(document).value()};
}

std::string figures_text(const Entry& entry) {
  Json figures = figures_document(entry);
  figures["style"] = entry.style;
  figures["content"] = std::to_string(entry.content);
  return protocol::json::to_text(figures);
}

std::optional<Entry> read_figures(std::uint64_t number, const std::string& text) {
  const auto document = protocol::json::parse(text);
  if (!document) return std::nullopt;
  auto figures = protocol::library::read_stored_figures(*document);
  if (!figures) return std::nullopt;
  for (const char* name : {"style", "content"}) {
    if (!document->contains(name) || !(*document)[name].is_string()) return std::nullopt;
  }
  const std::string digits = (*document)["content"].get<std::string>();
  std::uint64_t content = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), content);
  return Entry{*std::move(figures), number, (*document)["style"].get<std::string>(), content};
}

}  // namespace selvage::server::library
