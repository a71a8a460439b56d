// The markers that are open, each at its last committed revision.
//
// A committed marker never changes: readers share it while a motion works on the next one.  Ids are "m1",
// "m2", ... in the order of opening and are never used twice by one process; revisions of a marker count
// from 1. Every function may be called from any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "protocol/messages.h"

namespace selvage {

struct Committed {
  Revision revision{};
  std::shared_ptr<const MarkerFile> file;  // the marker, and what its document said beside it
};

struct OpenMarker {
  std::string id;
  Committed first;
};

// How a commit went.
struct Commit {
  enum class Outcome { kDone, kMismatch, kClosed } outcome{};
  Revision revision{};  // the current one: the new one when done
};

class MarkerStore {
 public:
  explicit MarkerStore(std::size_t limit) : limit_{limit} {}

  // Nothing when `limit` markers are open.
  [[nodiscard]] std::optional<OpenMarker> open(MarkerFile file);
  // Nothing when no such marker is open.
  [[nodiscard]] std::optional<Committed> current(const std::string& id) const;
  // Makes `file` the revision after `base`, if `base` is still the current one.
  [[nodiscard]] Commit commit(const std::string& id, Revision base, MarkerFile file);
  // False when no such marker is open.
  [[nodiscard]] bool close(const std::string& id);

  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] std::size_t limit() const { return limit_; }

 private:
  const std::size_t limit_;
  mutable std::mutex mutex_;
  std::uint64_t opened_{};
  std::map<std::string, Committed> markers_;
};

}  // namespace selvage
