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
    auto held = std::make_shared<Held>();
    Stamps stamps = all_new(marker.revision, marker.file);
    held->current = committed(marker.revision, std::move(marker.file), std::move(stamps));
    held->history = std::move(marker.history);
    for (KeptAnswer& answer : marker.answers) held->answers.keep(std::move(answer));
    markers_.emplace(std::move(marker.id), std::move(held));
  }
}

std::shared_ptr<MarkerStore::Held> MarkerStore::held(const std::string& id) const {
  const std::lock_guard lock{mutex_};
  const auto found = markers_.find(id);
  return found == markers_.end() ? nullptr : found->second;
}

std::variant<OpenMarker, NotOpened> MarkerStore::open(MarkerFile file, const OpenAnswer& answer) {
  Stamps stamps = all_new(1, file);
  OpenMarker opened{{}, committed(1, std::move(file), std::move(stamps))};
  auto held = std::make_shared<Held>();
  held->current = opened.now;
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
  markers_.emplace(opened.id, std::move(held));
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
  for (const auto& [id, held] : markers_) markers.push_back({id, held->current});
  return markers;
}

Commit MarkerStore::commit(const std::string& id, Revision base, NextRevision next) {
  const auto held = this->held(id);
  if (!held) return {Commit::Outcome::kClosed, 0};
  const std::lock_guard writing{held->writing};
  if (held->closed) return {Commit::Outcome::kClosed, 0};
  // Nobody else replaces it while `writing` is ours.
  const Committed before = held->current;
  if (before.revision != base) return {Commit::Outcome::kMismatch, before.revision};
  const auto moves = protocol::edits::moves_between(*before.file, next.file);
  const Revision revision = base + 1;
  History history = held->history;
  const History::Recorded recorded = history.record(next.origin, before.file, moves);
  if (journal_ && !journal_->changed(id, {revision, moves, next.file, recorded, next.answer})) {
    return {Commit::Outcome::kNotWritten, base};
  }
  Stamps stamps = stamps_after(*before.stamps, revision, moves, next.file);
  const Committed after = committed(revision, std::move(next.file), std::move(stamps));
  held->history = std::move(history);
  {
    const std::lock_guard lock{mutex_};
    held->current = after;
    if (next.answer) held->answers.keep(*std::move(next.answer));
  }
  if (next.tell) next.tell(after);
  return {Commit::Outcome::kDone, revision};
}

std::optional<MarkerStore::Return> MarkerStore::way_back(const std::string& id, Way way) const {
  const auto held = this->held(id);
  if (!held) return std::nullopt;
  const std::lock_guard writing{held->writing};
  const History& history = held->history;
  const MarkerFile& now = *held->current.file;
  return Return{held->current, history.after(way, now), history.steps(Way::kUndo), history.steps(Way::kRedo)};
}

bool MarkerStore::close(const std::string& id, const std::optional<KeptAnswer>& answer,
                        const std::function<void()>& tell) {
  const auto held = this->held(id);
  if (!held) return false;
  const std::lock_guard writing{held->writing};
  if (std::exchange(held->closed, true)) return false;
  if (journal_) (void)journal_->closed(id, answer);  // a marker that comes back is better than one that cannot close
  {
    const std::lock_guard lock{mutex_};
    markers_.erase(id);
    if (answer) answers_.keep(*answer);
  }
  if (tell) tell();
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
  const auto held = this->held(id);
  if (!held) return false;
  const std::lock_guard writing{held->writing};
  if (journal_ && !journal_->answered(id, answer)) return false;
  const std::lock_guard lock{mutex_};
  held->answers.keep(answer);
  return true;
}

std::size_t MarkerStore::count() const {
  const std::lock_guard lock{mutex_};
  return markers_.size();
}

}  // namespace selvage::server::store
