// What can be taken back of one marker's changes, and made again: at most kMostSteps of either, and no more than
// kMostBytes of both; the oldest are forgotten first.  A step is the moves that lead back, or, when more than moves is
// needed, the whole marker as it was (which is shared, not copied).
//
// Copies of a history share their steps: what a change would make of it can be written down before the change is made.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "protocol/edits/moves.h"

namespace selvage::server::store {

// Where a revision comes from.
enum class Origin { kChange, kUndo, kRedo };
// Where a step leads: to before the last change, or to after the one that was taken back last.
enum class Way { kUndo, kRedo };

class History {
 public:
  static constexpr std::size_t kMostSteps = 256;
  static constexpr std::size_t kMostBytes = std::size_t{32} << 20;

  using File = std::shared_ptr<const MarkerFile>;
  using Back = std::variant<protocol::edits::Moves, File>;
  struct Step {
    std::uint64_t serial{};  // larger than those of all steps before it
    Back back;
  };

  History() = default;
  // Of steps that were written down, the oldest first.  REQUIRES: serials grow along each.
  History(std::vector<Step> undo, std::vector<Step> redo);

  // What a revision did to the history.
  struct Recorded {
    Way way{};  // that got a step more
    std::shared_ptr<const Step> step;
    std::vector<std::uint64_t> forgotten;  // the serials of steps that are gone
  };
  // A revision was made.  `moves` lead from `before` to what came after; nothing when moves do not.  After kChange what
  // had been taken back cannot be made again.  REQUIRES: of kUndo and kRedo, that what came after is what
  // after(kUndo, *before) or after(kRedo, *before) gave.
  [[nodiscard]] Recorded record(Origin origin, const File& before, const std::optional<protocol::edits::Moves>& moves);

  // The file that a way leads to; nothing when it leads nowhere.
  [[nodiscard]] std::optional<MarkerFile> after(Way way, const MarkerFile& current) const;
  [[nodiscard]] std::size_t steps(Way way) const { return of(way).size(); }

 private:
  struct Kept {
    std::shared_ptr<const Step> step;
    std::size_t bytes{};
  };
  using Stack = std::deque<Kept>;  // the newest at the back

  [[nodiscard]] const Stack& of(Way way) const { return way == Way::kUndo ? undo_ : redo_; }
  [[nodiscard]] Stack& of(Way way) { return way == Way::kUndo ? undo_ : redo_; }
  void push(Way way, std::shared_ptr<const Step> step);
  [[nodiscard]] std::uint64_t pop_newest(Way way);
  [[nodiscard]] std::uint64_t pop_oldest(Way way);

  Stack undo_, redo_;
  std::size_t bytes_{};
  std::uint64_t last_serial_{};
};

// The marker that a step leads to from `current`.
[[nodiscard]] MarkerFile taken(const History::Back& back, MarkerFile current);

}  // namespace selvage::server::store
