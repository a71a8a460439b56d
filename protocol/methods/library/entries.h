// The library of a daemon: adding, getting, listing, removing and searching for stored markers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "protocol/calls/results.h"
#include "protocol/schema/documents.h"

namespace selvage::protocol::methods::library {

inline constexpr std::string_view kIdMeaning = "The stored marker's id, such as s7.";
inline constexpr schema::Limits kStyles{.bytes = {{0, 200}}};
inline constexpr std::size_t kMostListed = 1'000, kMostFound = 100;

// What is known of a stored marker.
struct LibraryEntry {
  static constexpr std::string_view kName = "LibraryEntry", kMeaning = "A stored marker.";
  std::string id, name, style, unit;
  std::size_t pieces{};
  double width{}, spacing{}, length{}, utilisation{};

  static void describe(auto& v, auto& self) {
    v.required("id", self.id, kIdMeaning);
    v.required("name", self.name, calls::kNameMeaning);
    v.required("style", self.style, "The style, as it was given.");
    v.required("unit", self.unit, "The unit of all its lengths.");
    v.required("pieces", self.pieces, calls::kPiecesMeaning);
    v.required("width", self.width, "The width of the strip.");
    v.required("spacing", self.spacing, "The least distance between two pieces.");
    v.required("length", self.length, calls::kLengthMeaning);
    v.required("utilisation", self.utilisation, calls::kUtilisationMeaning);
  }
};

struct LibraryAddParams {
  std::string marker_id;
  std::string style;

  static void describe(auto& v, auto& self) {
    v.required("markerId", self.marker_id,
               "The open marker to store, at its current revision; it must be valid, with all pieces placed.");
    v.optional("style", self.style, "The style.", kStyles);
  }
};
struct LibraryAddResult {
  LibraryEntry entry;
  bool added{};

  static void describe(auto& v, auto& self) {
    v.part(self.entry);
    v.required("added", self.added, "Whether the marker is new; false when the library had it already.");
  }
};

struct LibraryIdParams {
  std::string id;

  static void describe(auto& v, auto& self) { v.required("id", self.id, kIdMeaning); }
};
struct LibraryGetResult {
  LibraryEntry entry;
  schema::NativeDocument marker;

  static void describe(auto& v, auto& self) {
    v.part(self.entry);
    v.required("marker", self.marker, "The marker as a native document.");
  }
};
struct LibraryRemoveResult {
  std::string id;
  bool removed{true};

  static void describe(auto& v, auto& self) {
    v.required("id", self.id, kIdMeaning);
    v.required("removed", self.removed, "Always true.");
  }
};

struct LibraryListParams {
  std::size_t offset{}, most{100};

  static void describe(auto& v, auto& self) {
    v.optional("offset", self.offset, "Number of markers to skip.", {.range = {{0, 1e9}}});
    v.optional("most", self.most, "Maximum number of markers to list, 1 to 1000.", {.range = {{1, kMostListed}}});
  }
};
struct LibraryListResult {
  std::size_t count{};
  std::vector<LibraryEntry> markers;

  static void describe(auto& v, auto& self) {
    v.required("count", self.count, "Number of stored markers.");
    v.required("markers", self.markers, "The markers, in the order in which they were added.");
  }
};

struct LibrarySearchParams {
  std::string marker_id;
  std::size_t most{10};

  static void describe(auto& v, auto& self) {
    v.required("markerId", self.marker_id, "The open marker to compare with; how its pieces lie does not matter.");
    v.optional("most", self.most, "Maximum number of markers to return, 1 to 100.", {.range = {{1, kMostFound}}});
  }
};
struct LibraryNear {
  static constexpr std::string_view kName = "LibraryNear", kMeaning = "A stored marker that is similar to an order.";
  LibraryEntry entry;
  double distance{};

  static void describe(auto& v, auto& self) {
    v.part(self.entry);
    v.required("distance", self.distance, "The distance between their signatures; 0 for equal pieces.");
  }
};
struct LibrarySearchResult {
  std::vector<LibraryNear> near;

  static void describe(auto& v, auto& self) {
    v.required("near", self.near, "The markers found, the most similar first.");
  }
};

}  // namespace selvage::protocol::methods::library
