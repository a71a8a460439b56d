// What a library knows about a stored marker without reading its document: figures for lists, and the signature by
// which similar markers are found.  The daemon keeps it in its store, the command line in the index of a folder.
#pragma once

#include <optional>
#include <string>

#include "core/marker/marker.h"
#include "core/matching/signature.h"
#include "protocol/json/value.h"

namespace selvage::protocol::library {

struct StoredFigures {
  std::string name;      // the marker's
  double length{};       // in the marker's unit
  double utilisation{};  // 0..1
  matching::Signature signature;
  friend bool operator==(const StoredFigures&, const StoredFigures&) = default;
};

// REQUIRES: the marker has pieces.
[[nodiscard]] StoredFigures stored_figures_of(const Marker& marker);

// Returns an object, to which a caller may add fields.
[[nodiscard]] Json figures_document(const StoredFigures& figures);
// The inverse of figures_document(), or nothing; other fields are ignored.
[[nodiscard]] std::optional<StoredFigures> read_stored_figures(const Json& document);

}  // namespace selvage::protocol::library
