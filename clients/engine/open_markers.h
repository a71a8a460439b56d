// The markers that are open in this process, with their revisions and their undo and redo histories.
//
// Thread-safe.  States are immutable, so readers share them.  Changes of the same marker run one after another: a
// thread that computes a change holds the marker's `turn` from reading the current state to committing the next one.
#pragma once

#include <chrono>
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

// How a new state came about, which decides how the undo and redo histories change.
enum class Origin { kChange, kUndo, kRedo };

class OpenMarker {
 public:
  static constexpr std::size_t kMostUndone = 100;  // number of states kept for undo; the oldest is dropped first

  explicit OpenMarker(MarkerFile file) : now_{1, std::make_shared<const MarkerFile>(std::move(file))} {}

  // The lock to hold while a change is computed and committed.
  [[nodiscard]] std::unique_lock<std::mutex> turn() { return std::unique_lock{turn_}; }
  [[nodiscard]] Current current() const;
  // Returns the state that undo or redo would restore; null if there is none.  REQUIRES: origin is not kChange.
  [[nodiscard]] State peek(Origin origin) const;
  // Makes the next state current.  REQUIRES: the caller holds the turn.
  void commit(State next, Origin origin);

 private:
  std::mutex turn_;
  mutable std::mutex mutex_;  // guards everything below; held briefly
  Current now_;
  std::vector<State> undone_to_, redone_to_;  // stacks: the last state is restored first
};

class OpenMarkers {
 public:
  struct Opened {
    std::string id;
    std::shared_ptr<OpenMarker> marker;
  };

  // Opens a marker.  Its id is m1, m2 and so on, as in a daemon.
  [[nodiscard]] Opened open(MarkerFile file);
  // Returns null if no marker with this id is open.
  [[nodiscard]] std::shared_ptr<OpenMarker> find(const std::string& id) const;
  // Returns false if no marker with this id is open.
  [[nodiscard]] bool close(const std::string& id);
  // Returns all open markers in the order in which they were opened.
  [[nodiscard]] std::vector<Opened> all() const;
  // Another one for each object: the time at which it was made.
  [[nodiscard]] const std::string& identity() const { return identity_; }

 private:
  const std::string identity_ = "engine-" + std::to_string(std::chrono::steady_clock::now().time_since_epoch().count());

  mutable std::mutex mutex_;
  std::size_t opened_{};
  std::map<std::size_t, Opened> markers_;  // keyed by the number in the id
};

}  // namespace selvage::engine
