// The content of the store's file, as bytes: the rows with correct checksums, grouped by marker, and the damage that
// was found.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace selvage::server::store::disk {

struct StoredStep {
  std::uint64_t serial{};
  std::int64_t way{};  // 0: undo, 1: redo
  std::string format;  // empty: `step` consists of moves; otherwise it is a document
  std::string step;
};

struct StoredAnswer {
  std::uint64_t serial{};
  std::string client, op, method;
  std::int64_t params{};  // a checksum of the call's parameters; 0: not known
  std::string result;
};

// A complete marker: the steps lead from the snapshot to `revision`, one revision each.
struct StoredMarker {
  std::int64_t number{};
  std::uint64_t revision{};
  std::string summary;  // empty: not known
  std::uint64_t snapshot_revision{};
  std::string format, document;
  std::vector<std::string> steps;     // moves
  std::vector<StoredStep> history;    // by serial
  std::vector<StoredAnswer> answers;  // by serial
};

// A marker that cannot be used, and why.  The number is 0 if the damage belongs to no particular marker.
struct Damage {
  std::int64_t marker{};
  std::string what;
};

[[nodiscard]] inline std::string text_of(const Damage& damage) {
  return (damage.marker == 0 ? "" : "marker m" + std::to_string(damage.marker) + ": ") + damage.what;
}

struct StoredTotal {
  std::uint64_t opened{};   // markers ever opened
  std::uint64_t markers{};  // open now
  std::uint64_t answers{};  // kept for calls that opened or closed markers
};

struct StoredContent {
  StoredTotal total;
  std::vector<StoredMarker> markers;
  std::vector<StoredAnswer> answers;  // to calls that opened and closed markers
  std::vector<Damage> damage;
};

}  // namespace selvage::server::store::disk
