// The library of stored markers: complete, valid, never changed, and found by their similarity to an order.
//
// With a journal the markers are in the store's file, each in one synced transaction, and their entries are in memory;
// documents are read when they are needed.  Without one they live in memory.  Ids are "s1", "s2", ... in the order of
// adding and are never used twice.  A marker whose rows are damaged is left out, with a line in the log.  Every
// function may be called from any thread.
#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "protocol/document/marker_file.h"
#include "server/library/entry.h"
#include "server/store/journal.h"

namespace selvage::server::library {

inline constexpr std::size_t kMostMarkers = 100'000;
inline constexpr std::size_t kMostInMemory = 1'000;  // without a journal

enum class NotAdded { kLimit, kNotWritten };
enum class Removed { kDone, kUnknown, kNotWritten };

struct Added {
  Entry entry;
  bool fresh{};  // false if the library had this marker already
};
struct Near {
  Entry entry;
  double distance{};  // core/matching/signature.h
};

class Library {
 public:
  // Reads the markers of the journal's file, if there is a journal; it must outlive the library.
  explicit Library(store::Journal* journal = nullptr);

  [[nodiscard]] std::size_t limit() const { return journal_ ? kMostMarkers : kMostInMemory; }
  [[nodiscard]] std::size_t count() const;
  // REQUIRES: the marker is valid and all of its pieces are placed.
  [[nodiscard]] std::variant<Added, NotAdded> add(const MarkerFile& file, const std::string& style);
  [[nodiscard]] std::optional<Entry> find(std::uint64_t number) const;
  // The marker's native document, as text; nothing if there is no such marker or it is damaged.
  [[nodiscard]] std::optional<std::string> document(std::uint64_t number) const;
  // In the order of their numbers, from `offset` on, at most `most` of them.
  [[nodiscard]] std::vector<Entry> list(std::size_t offset, std::size_t most) const;
  [[nodiscard]] Removed remove(std::uint64_t number);
  // The most similar markers first, at most `most` of them.  Markers that cannot be similar are left out.
  [[nodiscard]] std::vector<Near> search(const Marker& order, std::size_t most) const;
  // The markers that are most similar to the order.
  [[nodiscard]] std::vector<MarkerFile> markers_near(const Marker& order, std::size_t most) const;

 private:
  [[nodiscard]] std::optional<std::size_t> index_of(std::uint64_t number) const;

  store::Journal* const journal_;
  mutable std::mutex mutex_;
  std::mutex writing_;                              // held while the journal writes; locked before `mutex_`
  std::vector<Entry> entries_;                      // by number
  std::vector<matching::Signature> signatures_;     // of the entries
  std::map<std::uint64_t, std::string> documents_;  // without a journal
  std::uint64_t last_{};                            // the last number that was given out without a journal
};

}  // namespace selvage::server::library
