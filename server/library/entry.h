// What the library knows of a stored marker without reading its document.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "core/marker/marker.h"
#include "protocol/library/stored_figures.h"

namespace selvage::server::library {

struct Entry : protocol::library::StoredFigures {
  std::uint64_t number{};
  std::string style;        // what it is a marker of, in the caller's words
  std::uint64_t content{};  // a hash of its document: the same marker is stored once
};

// "s7" is the id of entry 7.
[[nodiscard]] std::string id_of(const Entry& entry);
// Nothing for a text that is no id.
[[nodiscard]] std::optional<std::uint64_t> number_of(const std::string& id);

[[nodiscard]] Entry entry_of(const Marker& marker, const std::string& style, const std::string& document);
// As the store's file has it; without the number.
[[nodiscard]] std::string figures_text(const Entry& entry);
// Nothing if the text is not one of figures_text().
[[nodiscard]] std::optional<Entry> read_figures(std::uint64_t number, const std::string& text);

}  // namespace selvage::server::library
