// What can be taken back of one marker's changes, and made again: at most kMostSteps of either, and no more than
// kMostBytes of both; the oldest are forgotten first.  A step is the moves that lead back, or, when more than moves is
// needed, the whole marker as it was (which is shared, not copied).
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <variant>

#include "protocol/moves.h"

namespace selvage {

class History {
 public:
  static constexpr std::size_t kMostSteps = 256;
  static constexpr std::size_t kMostBytes = std::size_t{32} << 20;

  using File = std::shared_ptr<const MarkerFile>;

  // A change was made: what had been taken back can no longer be made again.  `moves` lead from `before` to what came
  // after; nothing when moves do not.
  void changed(const File& before, const std::optional<Moves>& moves);
  // The file that taking back, or making again, leads to; nothing when there is nothing to.
  [[nodiscard]] std::optional<MarkerFile> undone(const MarkerFile& current) const { return after(undo_, current); }
  [[nodiscard]] std::optional<MarkerFile> redone(const MarkerFile& current) const { return after(redo_, current); }
  // It was done, `moves` leading from `before` to what undone(*before) or redone(*before) gave.
  void undid(const File& before, const std::optional<Moves>& moves);
  void redid(const File& before, const std::optional<Moves>& moves);

  [[nodiscard]] std::size_t undo_steps() const { return undo_.size(); }
  [[nodiscard]] std::size_t redo_steps() const { return redo_.size(); }

 private:
  struct Step {
    std::variant<Moves, File> back;
    std::size_t bytes{};
  };
  using Steps = std::deque<Step>;

  [[nodiscard]] static std::optional<MarkerFile> after(const Steps& steps, const MarkerFile& current);
  void push(Steps& onto, const File& before, const std::optional<Moves>& moves);
  void pop(Steps& steps);

  Steps undo_, redo_;  // the newest at the back
  std::size_t bytes_{};
};

}  // namespace selvage
