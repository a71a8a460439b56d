#include "server/history.h"

#include <utility>

namespace selvage {
namespace {

// Roughly what a file takes in memory: enough to bound a history.
std::size_t bytes_of(const MarkerFile& file) {
  std::size_t bytes = sizeof(MarkerFile) + file.marker.pieces.size() * (sizeof(Piece) + sizeof(Json));
  for (const Shape& shape : file.marker.shapes) bytes += sizeof(Shape) + shape.outline.size() * sizeof(Vec);
  return bytes;
}

}  // namespace

void History::changed(const File& before, const std::optional<Moves>& moves) {
  while (!redo_.empty()) pop(redo_);
  push(undo_, before, moves);
}

void History::undid(const File& before, const std::optional<Moves>& moves) {
  pop(undo_);
  push(redo_, before, moves);
}

void History::redid(const File& before, const std::optional<Moves>& moves) {
  pop(redo_);
  push(undo_, before, moves);
}

std::optional<MarkerFile> History::after(const Steps& steps, const MarkerFile& current) {
  if (steps.empty()) return std::nullopt;
  if (const auto* moves = std::get_if<Moves>(&steps.back().back)) return moved(current, *moves);
  return *std::get<File>(steps.back().back);
}

void History::push(Steps& onto, const File& before, const std::optional<Moves>& moves) {
  Step step;
  if (moves) {
    Moves back;
    back.reserve(moves->size());
    for (const Move& move : *moves) back.push_back({move.index, before->marker.pieces[move.index]});
    step.bytes = sizeof(Step) + back.size() * sizeof(Move);
    step.back = std::move(back);
  } else {
    step.bytes = sizeof(Step) + bytes_of(*before);
    step.back = before;
  }
  bytes_ += step.bytes;
  onto.push_back(std::move(step));
  const auto forget_oldest = [this](Steps& steps) {
    bytes_ -= steps.front().bytes;
    steps.pop_front();
  };
  if (onto.size() > kMostSteps) forget_oldest(onto);
  while (bytes_ > kMostBytes && undo_.size() + redo_.size() > 1) forget_oldest(undo_.size() > 1 ? undo_ : redo_);
}

void History::pop(Steps& steps) {
  bytes_ -= steps.back().bytes;
  steps.pop_back();
}

}  // namespace selvage
