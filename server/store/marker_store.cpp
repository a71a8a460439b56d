#include "server/store/marker_store.h"

#include <utility>

namespace selvage::server::store {
namespace {

Committed committed(Revision revision, MarkerFile file, Stamps stamps) {
  return {revision, std::make_shared<const MarkerFile>(std::move(file)),
          std::make_shared<const Stamps>(std::move(stamps)),
          std::make_shared<const protocol::execution::MadeOnce<std::string>>(),
          std::make_shared<const protocol::execution::MadeOnce<scene::LaidOut>>()};
}

Stamps all_new(Revision revision, const MarkerFile& file) {
  return {revision, std::vector<Revision>(file.marker.pieces.size(), revision)};
}

Stamps stamps_after(const Stamps& before, Revision revision, const std::optional<protocol::edits::Moves>& moves,
                    const MarkerFile& after) {
  if (!moves) return all_new(revision, after);
  Stamps stamps = before;
  for (const protocol::edits::Move& move : *moves) stamps.pieces[move.index] = revision;
  return stamps;
}

}  // namespace

MarkerStore::MarkerStore(std::size_t limit, Journal* journal) : limit_{limit}, journal_{journal} {
  if (!journal_) return;
  Restored restored = journal_->restore();
  opened_ = restored.opened;
  for (KeptAnswer& answer : restored.answers) answers_.keep(std::move(answer));
  for (RestoredMarker& marker : restored.markers) {
    auto entry = std::make_shared<Entry>();
    Stamps stamps = all_new(marker.revision, marker.file);
    entry->current = committed(marker.revision, std::move(marker.file), std::move(stamps));
    entry->history = std::move(marker.history);
    for (KeptAnswer& answer : marker.answers) entry->answers.keep(std::move(answer));
    markers_.emplace(std::move(marker.id), std::move(entry));
  }
}

std::shared_ptr<MarkerStore::Entry> MarkerStore::find(const std::string& id) const {
  const std::lock_guard lock{mutex_};
  const auto found = markers_.find(id);
  return found == markers_.end() ? nullptr : found->second;
}

std::variant<OpenMarker, NotOpened> MarkerStore::open(MarkerFile file, const OpenAnswer& answer) {
  Stamps stamps = all_new(1, file);
  OpenMarker opened{{}, committed(1, std::move(file), std::move(stamps))};
  auto entry = std::make_shared<Entry>();
  entry->current = opened.now;
  std::uint64_t number{};
  {
    const std::lock_guard lock{mutex_};
    if (markers_.size() + opening_ >= limit_) return NotOpened::kLimit;
    ++opening_;
    number = ++opened_;
  }
  opened.id = "m" + std::to_string(number);
  const auto kept = answer ? answer(opened) : std::nullopt;
  const bool written = !journal_ || journal_->opened(opened.id, number, *opened.now.file, kept);
  const std::lock_guard lock{mutex_};
  --opening_;
  if (!written) return NotOpened::kNotWritten;
  markers_.emplace(opened.id, std::move(entry));
  if (kept) answers_.keep(*kept);
  return opened;
}

std::optional<Committed> MarkerStore::current(const std::string& id) const {
  const std::lock_guard lock{mutex_};
  const auto found = markers_.find(id);
  if (found == markers_.end()) return std::nullopt;
  return found->second->current;
}

std::vector<OpenMarker> MarkerStore::all() const {
  const std::lock_guard lock{mutex_};
  std::vector<OpenMarker> markers;
  markers.reserve(markers_.size());
  for (const auto& [id, entry] : markers_) markers.push_back({id, entry->current});
  return markers;
}

Commit MarkerStore::commit(const std::string& id, Revision base, NextRevision next) {
  const auto entry = find(id);
  if (!entry) return {Commit::Outcome::kClosed, 0};
  const std::lock_guard writing{entry->writing};
  if (entry->closed) return {Commit::Outcome::kClosed, 0};
  // Nobody else replaces it while we hold `writing`.
  const Committed before = entry->current;
  if (before.revision != base) return {Commit::Outcome::kMismatch, before.revision};
  const auto moves = protocol::edits::moves_between(*before.file, next.file);
  const Revision revision = base + 1;
  History history = entry->history;
  const History::Recorded recorded = history.record(next.origin, before.file, moves);
  if (journal_ && !journal_->changed(id, {revision, moves, next.file, recorded, next.answer})) {
    return {Commit::Outcome::kNotWritten, base};
  }
  Stamps stamps = stamps_after(*before.stamps, revision, moves, next.file);
  const Committed after = committed(revision, std::move(next.file), std::move(stamps));
  entry->history = std::move(history);
  {
    const std::lock_guard lock{mutex_};
    entry->current = after;
    if (next.answer) entry->answers.keep(*std::move(next.answer));
  }
  if (next.on_committed) next.on_committed(after);
  return {Commit::Outcome::kDone, revision};
}

std::optional<MarkerStore::UndoResult> MarkerStore::peek(const std::string& id, UndoDirection direction) const {
  const auto entry = find(id);
  if (!entry) return std::nullopt;
  const std::lock_guard writing{entry->writing};
  const History& history = entry->history;
  const MarkerFile& now = *entry->current.file;
  return UndoResult{entry->current, history.after(direction, now), history.steps(UndoDirection::kUndo),
                    history.steps(UndoDirection::kRedo)};
}

bool MarkerStore::close(const std::string& id, const std::optional<KeptAnswer>& answer,
                        const std::function<void()>& on_closed) {
  const auto entry = find(id);
  if (!entry) return false;
  const std::lock_guard writing{entry->writing};
  if (std::exchange(entry->closed, true)) return false;
  if (journal_)
    (void)journal_->closed(id,
                           answer);  // better a marker that reappears after a restart than one that cannot be closed
  {
    const std::lock_guard lock{mutex_};
    markers_.erase(id);
    if (answer) answers_.keep(*answer);
  }
  if (on_closed) on_closed();
  return true;
}

std::optional<KeptAnswer> MarkerStore::answer(const std::string& id, const std::string& op_id) const {
  const std::lock_guard lock{mutex_};
  const auto found = markers_.find(id);
  if (found == markers_.end() && !id.empty()) return std::nullopt;
  const KeptAnswer* kept = (id.empty() ? answers_ : found->second->answers).find(op_id);
  return kept ? std::optional{*kept} : std::nullopt;
}

bool MarkerStore::keep(const std::string& id, const KeptAnswer& answer) {
  const auto entry = find(id);
  if (!entry) return false;
  const std::lock_guard writing{entry->writing};
  if (journal_ && !journal_->answered(id, answer)) return false;
  const std::lock_guard lock{mutex_};
  entry->answers.keep(answer);
  return true;
}

std::size_t MarkerStore::count() const {
  const std::lock_guard lock{mutex_};
  return markers_.size();
}

}  // namespace selvage::server::store
