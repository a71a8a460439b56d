// What the library knows about a stored marker without reading its document.
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
  std::string style;        // what the marker is of, as the caller describes it
  std::uint64_t content{};  // a hash of its document, so that the same marker is stored only once
};

// "s7" is the id of entry 7.
[[nodiscard]] std::string id_of(const Entry& entry);
// Returns nothing if the text is not an id.
[[nodiscard]] std::optional<std::uint64_t> number_of(const std::string& id);

[[nodiscard]] Entry entry_of(const Marker& marker, const std::string& style, const std::string& document);
// The text that the store's file contains; without the number.
[[nodiscard]] std::string figures_text(const Entry& entry);
// The inverse of figures_text().  Returns nothing if the text was not written by it.
[[nodiscard]] std::optional<Entry> read_figures(std::uint64_t number, const std::string& text);

}  // namespace selvage::server::library
