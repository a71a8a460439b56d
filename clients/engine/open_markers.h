// The markers that are open in this process, with their revisions and the states that undo and redo lead to.
//
// Safe to use from several threads.  A state never changes once it is current, so readers share it.  Changes of one
// marker run one after another: whoever computes a change holds the marker's turn from reading the current state to
// committing the next.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "protocol/calls/params.h"
#include "protocol/document/marker_file.h"

namespace selvage::engine {

using State = std::shared_ptr<const MarkerFile>;

// A marker's current state.
struct Current {
  Revision revision{};
  State file;
};

// Where a new state comes from, and so what becomes of the states that undo and redo lead to.
enum class Origin { kChange, kUndo, kRedo };

class OpenMarker {
 public:
  static constexpr std::size_t kMostUndone = 100;  // states kept for undo; the oldest is dropped first

  explicit OpenMarker(MarkerFile file) : now_{1, std::make_shared<const MarkerFile>(std::move(file))} {}

  // Held while a change is computed and committed.
  [[nodiscard]] std::unique_lock<std::mutex> turn() { return std::unique_lock{turn_}; }
  [[nodiscard]] Current current() const;
  // The state that undo or redo leads to; null when there is none.  REQUIRES: origin is not kChange.
  [[nodiscard]] State peek(Origin origin) const;
  // Makes the next state current.  REQUIRES: the caller holds the turn.
  void commit(State next, Origin origin);

 private:
  std::mutex turn_;
  mutable std::mutex mutex_;  // of all below; held briefly
  Current now_;
  std::vector<State> undone_to_, redone_to_;  // the last is the next
};

class OpenMarkers {
 public:
  struct Opened {
    std::string id;
    std::shared_ptr<OpenMarker> marker;
  };

  // Ids are m1, m2 and so on, as a daemon gives them.
  [[nodiscard]] Opened open(MarkerFile file);
  // Null when no marker of this id is open.
  [[nodiscard]] std::shared_ptr<OpenMarker> find(const std::string& id) const;
  // False when no marker of this id is open.
  [[nodiscard]] bool close(const std::string& id);
  // In the order in which they were opened.
  [[nodiscard]] std::vector<Opened> all() const;

 private:
  mutable std::mutex mutex_;
  std::size_t opened_{};
  std::map<std::size_t, Opened> markers_;  // by the number in the id
};

}  // namespace selvage::engine
