// What marker.list says of a marker, and how large it is: known without reading its document.
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
  friend bool operator==(const Summary&, const Summary&) = default;
};

[[nodiscard]] Summary summary_of(const Marker& marker);
// As the journal writes it.
[[nodiscard]] std::string summary_text(const Summary& summary);
// Nothing if the text is not one of summary_text().
[[nodiscard]] std::optional<Summary> read_summary(const std::string& text);

}  // namespace selvage::server::store
