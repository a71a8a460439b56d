// The undo and redo history of one marker: at most kMaxSteps steps in either direction, and kMaxBytes in both
// directions together, including everything that the steps hold.  The oldest steps are forgotten first.  A step holds
// the moves that lead back or, if moves do not suffice, the whole earlier marker, which is shared, not copied.
//
// Copies of a history share their steps, so that the effect of a change on the history can be written to the journal
// before the change is made.
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

// How a revision was made.
enum class Origin { kChange, kUndo, kRedo };
enum class UndoDirection { kUndo, kRedo };
// As the store's file has it.
[[nodiscard]] constexpr std::int64_t way_of(UndoDirection direction) {
  return direction == UndoDirection::kUndo ? 0 : 1;
}

class History {
 public:
  static constexpr std::size_t kMaxSteps = 256;
  static constexpr std::size_t kMaxBytes = std::size_t{32} << 20;

  using File = std::shared_ptr<const MarkerFile>;
  using Back = std::variant<protocol::edits::Moves, File>;
  struct Step {
    std::uint64_t serial{};  // larger than those of all earlier steps
    Back back;
  };

  History() = default;
  // Makes a history of the journal's steps, the oldest first.  REQUIRES: serials increase in each direction.
  History(std::vector<Step> undo, std::vector<Step> redo);

  // How a revision changed the history.
  struct Recorded {
    UndoDirection direction{};  // that got one more step
    std::shared_ptr<const Step> step;
    std::vector<std::uint64_t> forgotten;  // serials of the steps that were removed
  };
  // Records that a revision was made.  `moves` lead from `before` to the new revision; nothing if moves do not suffice.
  // kChange removes all redo steps.  In both directions together at least one step is kept, and as many more as fit
  // into `most_bytes`.  REQUIRES: for kUndo and kRedo, the new revision is what after(kUndo, *before) or after(kRedo,
  // *before) returned.
  [[nodiscard]] Recorded record(Origin origin, const File& before, const std::optional<protocol::edits::Moves>& moves,
                                std::size_t most_bytes = kMaxBytes);

  // The file after undoing or redoing one step; nothing if there is no step.
  [[nodiscard]] std::optional<MarkerFile> after(UndoDirection direction, const MarkerFile& current) const;
  [[nodiscard]] std::size_t steps(UndoDirection direction) const { return stack(direction).size(); }
  // The memory of all steps, and of the steps that hold moves.
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] std::size_t bytes_of_moves() const { return bytes_of_moves_; }

 private:
  struct Kept {
    std::shared_ptr<const Step> step;
    std::size_t bytes{};
    bool moves{};
  };
  using Stack = std::deque<Kept>;  // the newest step is last

  [[nodiscard]] const Stack& stack(UndoDirection direction) const {
    return direction == UndoDirection::kUndo ? undo_ : redo_;
  }
  [[nodiscard]] Stack& stack(UndoDirection direction) { return direction == UndoDirection::kUndo ? undo_ : redo_; }
  void push(UndoDirection direction, std::shared_ptr<const Step> step);
  [[nodiscard]] std::uint64_t pop_newest(UndoDirection direction);
  [[nodiscard]] std::uint64_t pop_oldest(UndoDirection direction);
  void count_out(const Kept& kept);

  Stack undo_, redo_;
  std::size_t bytes_{}, bytes_of_moves_{};
  std::uint64_t last_serial_{};
};

// The marker that a step leads to from `current`.
[[nodiscard]] MarkerFile after_step(const History::Back& back, MarkerFile current);

}  // namespace selvage::server::store
