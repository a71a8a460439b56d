#include "server/store/history.h"

#include <algorithm>
#include <utility>

#include "server/memory/weights.h"

namespace selvage::server::store {
namespace {

std::size_t bytes_of(const History::Back& back) {
  if (const auto* moves = std::get_if<protocol::edits::Moves>(&back)) {
    return sizeof(History::Step) + memory::bytes_of(*moves);
  }
  return sizeof(History::Step) + memory::bytes_of(*std::get<History::File>(back));
}

History::Back back_to(const History::File& before, const std::optional<protocol::edits::Moves>& moves) {
  if (!moves) return before;
  protocol::edits::Moves back;
  back.reserve(moves->size());
  for (const protocol::edits::Move& move : *moves) back.push_back({move.index, before->marker.pieces[move.index]});
  return back;
}

}  // namespace

History::History(std::vector<Step> undo, std::vector<Step> redo) {
  for (Step& step : undo) push(UndoDirection::kUndo, std::make_shared<const Step>(std::move(step)));
  for (Step& step : redo) push(UndoDirection::kRedo, std::make_shared<const Step>(std::move(step)));
}

History::Recorded History::record(Origin origin, const File& before, const std::optional<protocol::edits::Moves>& moves,
                                  std::size_t most_bytes) {
  const UndoDirection direction = origin == Origin::kUndo ? UndoDirection::kRedo : UndoDirection::kUndo;
  Recorded recorded{direction, std::make_shared<const Step>(Step{last_serial_ + 1, back_to(before, moves)}), {}};
  std::vector<std::uint64_t>& forgotten = recorded.forgotten;
  if (origin == Origin::kUndo) forgotten.push_back(pop_newest(UndoDirection::kUndo));
  if (origin == Origin::kRedo) forgotten.push_back(pop_newest(UndoDirection::kRedo));
  while (origin == Origin::kChange && !redo_.empty()) forgotten.push_back(pop_newest(UndoDirection::kRedo));
  push(direction, recorded.step);
  if (steps(direction) > kMaxSteps) forgotten.push_back(pop_oldest(direction));
  while (bytes_ > most_bytes && undo_.size() + redo_.size() > 1) {
    forgotten.push_back(pop_oldest(undo_.size() > 1 ? UndoDirection::kUndo : UndoDirection::kRedo));
  }
  return recorded;
}

std::optional<MarkerFile> History::after(UndoDirection direction, const MarkerFile& current) const {
  if (stack(direction).empty()) return std::nullopt;
  return after_step(stack(direction).back().step->back, current);
}

void History::push(UndoDirection direction, std::shared_ptr<const Step> step) {
  last_serial_ = std::max(last_serial_, step->serial);
  const std::size_t bytes = bytes_of(step->back);
  const bool moves = std::holds_alternative<protocol::edits::Moves>(step->back);
  bytes_ += bytes;
  if (moves) bytes_of_moves_ += bytes;
  stack(direction).push_back({std::move(step), bytes, moves});
}

std::uint64_t History::pop_newest(UndoDirection direction) {
  const Kept kept = std::move(stack(direction).back());
  stack(direction).pop_back();
  count_out(kept);
  return kept.step->serial;
}

std::uint64_t History::pop_oldest(UndoDirection direction) {
  const Kept kept = std::move(stack(direction).front());
  stack(direction).pop_front();
  count_out(kept);
  return kept.step->serial;
}

void History::count_out(const Kept& kept) {
  bytes_ -= kept.bytes;
  if (kept.moves) bytes_of_moves_ -= kept.bytes;
}

MarkerFile after_step(const History::Back& back, MarkerFile current) {
  if (const auto* moves = std::get_if<protocol::edits::Moves>(&back)) return moved(std::move(current), *moves);
  return *std::get<History::File>(back);
}

}  // namespace selvage::server::store
