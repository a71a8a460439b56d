// What marker.list reports about a marker, and its size in memory, both known without reading its document.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/marker/marker.h"

namespace selvage::server::store {

struct Summary {
  std::string name;
  std::size_t pieces{}, unplaced{};
  std::size_t vertices{};  // of all pieces
  double length{};         // in the marker's unit
  double utilisation{};    // 0..1
  bool of_connection{};    // it belongs to a connection, with which it is closed
  friend bool operator==(const Summary&, const Summary&) = default;
};

[[nodiscard]] Summary summary_of(const Marker& marker);
// The text that the journal writes.
[[nodiscard]] std::string summary_text(const Summary& summary);
// The inverse of summary_text().  Returns nothing if the text was not written by it.
[[nodiscard]] std::optional<Summary> read_summary(const std::string& text);

}  // namespace selvage::server::store
