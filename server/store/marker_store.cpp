#include "server/store/marker_store.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <utility>

#include "server/memory/weights.h"
#include "server/store/restored_marker.h"

namespace selvage::server::store {
namespace {

constexpr std::size_t kEmptyMarker = 4096;  // bytes of the entries, locks and maps that every marker has

// The memory of a revision: the marker, and what its readers share in addition.
struct Weight {
  std::size_t file{}, readers{};
  [[nodiscard]] std::size_t all() const { return file + readers; }
};

Weight weight_of(const MarkerFile& file) {
  const std::size_t stamps = file.marker.pieces.size() * sizeof(Revision);
  return {memory::bytes_of(file), memory::bytes_for_readers(file) + stamps};
}

// Counted separately from the marker, which the history may keep for longer.
struct ForReaders {
  explicit ForReaders(memory::HeldBytes bytes) : held{std::move(bytes)} {}
  memory::HeldBytes held;
  protocol::execution::MadeOnce<std::string> text{};
  protocol::execution::MadeOnce<scene::LaidOut> laid_out{};
};

Committed committed(Revision revision, MarkerFile file, Stamps stamps, const Weight& weight,
                    const std::shared_ptr<memory::ByteAccount>& account) {
  const auto readers = std::make_shared<const ForReaders>(memory::HeldBytes{account, weight.readers});
  return {revision,
          memory::weighed(std::move(file), memory::HeldBytes{account, weight.file}),
          std::make_shared<const Stamps>(std::move(stamps)),
          {readers, &readers->text},
          {readers, &readers->laid_out}};
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

std::string id_of(std::uint64_t number) {
  return "m" + std::to_string(number);
}

// Of markers that end with the process.
std::string chance_identity() {
  std::random_device chance;
  const auto high = std::uint64_t{chance()} << 32U;
  return "process-" + std::to_string(high | chance());
}

// What the journal writes when this answer is added to those that are kept.
std::optional<KeptChange> change_of(const KeptAnswers& answers, const std::optional<KeptAnswer>& answer) {
  if (!answer) return std::nullopt;
  KeptChange change{*answer, answers.forgotten_for(*answer)};
  change.answer.serial = answers.next_serial();
  return change;
}

}  // namespace

MarkerStore::MarkerStore(Room room, Journal* journal, std::stop_token stop)
    : room_{std::move(room)}, journal_{journal}, identity_{journal ? journal->identity() : chance_identity()} {
  if (journal_) restore(journal_->restore(std::move(stop)));
}

void MarkerStore::Entry::count() {
  held.set(kEmptyMarker + history.bytes_of_moves() + answers.bytes() + (stored ? bytes_of(*stored) : 0));
}

void MarkerStore::restore(disk::StoredContent content) {
  opened_ = content.total.opened;
  answers_ = restore_answers(content.answers);
  held_answers_.set(answers_.bytes());
  for (disk::StoredMarker& marker : content.markers) {
    auto entry = std::make_shared<Entry>(room_.account);
    entry->number = static_cast<std::uint64_t>(marker.number);
    entry->stored_revision = marker.revision;
    entry->summary = read_summary(marker.summary);
    if (entry->summary && entry->summary->of_connection) {
      (void)journal_->closed(entry->number, {});  // if it is not written, the next start tries again
      continue;
    }
    entry->answers = restore_answers(std::exchange(marker.answers, {}));
    entry->stored = std::move(marker);
    entry->count();
    markers_.emplace(id_of(entry->number), std::move(entry));
  }
  for (const disk::Damage& damage : content.damage) {
    if (damage.marker > 0) quarantined_.emplace(id_of(static_cast<std::uint64_t>(damage.marker)), damage.what);
  }
}

std::shared_ptr<MarkerStore::Entry> MarkerStore::entry_of(const std::string& id) const {
  const std::lock_guard lock{mutex_};
  const auto found = markers_.find(id);
  return found == markers_.end() ? nullptr : found->second;
}

std::shared_ptr<MarkerStore::Entry> MarkerStore::find(const std::string& id) const {
  const auto entry = entry_of(id);
  return entry && load(id, *entry) ? entry : nullptr;
}

bool MarkerStore::load(const std::string& id, Entry& entry) const {
  if (entry.loaded) return true;
  const std::lock_guard loading{entry.loading};
  if (entry.loaded) return true;
  if (!entry.stored) return false;
  auto restored = restore_marker(*entry.stored, room_.account);
  if (!restored) {
    entry.stored.reset();
    const std::string why = protocol::json::describe(restored.error());
    spdlog::error("the store: marker {} at revision {} cannot be read: {}", id, entry.stored_revision, why);
    const std::lock_guard lock{mutex_};
    quarantined_.emplace(id, "it cannot be read: " + why);
    markers_.erase(id);
    return false;
  }
  const Weight weight = weight_of(restored->file);
  const bool room = room_.account->has_room(weight.all() - std::min(weight.all(), bytes_of(*entry.stored)));
  if (room) {
    entry.stored.reset();
    entry.history = std::move(restored->history);
    entry.count();
  }
  Stamps stamps = all_new(entry.stored_revision, restored->file);
  const std::lock_guard lock{mutex_};
  if (!entry.summary) entry.summary = summary_of(restored->file.marker);
  if (!room) return false;
  entry.current = committed(entry.stored_revision, std::move(restored->file), std::move(stamps), weight, room_.account);
  entry.loaded = true;
  return true;
}

std::variant<OpenMarker, NotOpened> MarkerStore::open(MarkerFile file, const OpenAnswer& answer, Owner owner) {
  const Weight weight = weight_of(file);
  if (weight.file > room_.marker_bytes) return NotOpened::kTooLarge;
  const memory::ByteAccount& account = *room_.account;
  if (!account.has_room(account.beside_reserve(kEmptyMarker + weight.all()))) return NotOpened::kNoRoom;
  Stamps stamps = all_new(1, file);
  OpenMarker opened{{}, committed(1, std::move(file), std::move(stamps), weight, room_.account)};
  auto entry = std::make_shared<Entry>(room_.account);
  entry->count();
  entry->current = opened.now;
  entry->summary = summary_of(opened.now.file->marker);
  entry->summary->of_connection = owner == Owner::kConnection;
  entry->loaded = true;
  {
    const std::lock_guard lock{mutex_};
    entry->number = ++opened_;
  }
  opened.id = id_of(entry->number);
  const auto kept = answer ? answer(opened) : std::nullopt;
  std::unique_lock answering{answering_, std::defer_lock};
  if (kept) answering.lock();
  const auto change = change_of(answers_, kept);
  const bool written =
      !journal_ || journal_->opened(entry->number, *opened.now.file, summary_text(*entry->summary), change);
  if (!written) return NotOpened::kNotWritten;
  const std::lock_guard lock{mutex_};
  markers_.emplace(opened.id, std::move(entry));
  keep_outside_markers(change);
  return opened;
}

// REQUIRES: mutex_ is locked.
void MarkerStore::keep_outside_markers(const std::optional<KeptChange>& change) {
  if (!change) return;
  answers_.keep(change->answer);
  held_answers_.set(answers_.bytes());
}

std::optional<Committed> MarkerStore::current(const std::string& id) const {
  const auto entry = find(id);
  if (!entry) return std::nullopt;
  const std::lock_guard lock{mutex_};
  return entry->current;
}

std::vector<ListedMarker> MarkerStore::all() const {
  std::vector<std::string> unknown;  // markers from a store without summaries
  {
    const std::lock_guard lock{mutex_};
    for (const auto& [id, entry] : markers_) {
      if (!entry->summary) unknown.push_back(id);
    }
  }
  for (const std::string& id : unknown) (void)find(id);
  const std::lock_guard lock{mutex_};
  std::vector<ListedMarker> markers;
  markers.reserve(markers_.size());
  for (const auto& [id, entry] : markers_) {
    if (!entry->summary) continue;  // it was opened a moment ago
    markers.push_back({id, entry->loaded ? entry->current.revision : entry->stored_revision, *entry->summary});
  }
  return markers;
}

std::optional<Summary> MarkerStore::summary(const std::string& id) const {
  {
    const std::lock_guard lock{mutex_};
    const auto found = markers_.find(id);
    if (found == markers_.end()) return std::nullopt;
    if (found->second->summary) return found->second->summary;
  }
  const auto now = current(id);
  return now ? std::optional{summary_of(now->file->marker)} : std::nullopt;
}

bool MarkerStore::is_open(const std::string& id) const {
  return entry_of(id) != nullptr;
}

bool MarkerStore::is_unread(const std::string& id) const {
  const auto entry = entry_of(id);
  return entry && !entry->loaded;
}

std::string MarkerStore::quarantine(const std::string& id) const {
  const std::lock_guard lock{mutex_};
  const auto found = quarantined_.find(id);
  return found == quarantined_.end() ? std::string{} : found->second;
}

Commit MarkerStore::commit(const std::string& id, Revision base, NextRevision next) {
  const auto entry = find(id);
  if (!entry) return {Commit::Outcome::kClosed, 0};
  const std::lock_guard writing{entry->writing};
  if (entry->closed) return {Commit::Outcome::kClosed, 0};
  // Nobody else replaces it while this thread holds `writing`.
  const Committed before = entry->current;
  if (before.revision != base) return {Commit::Outcome::kMismatch, before.revision};
  const auto moves = protocol::edits::moves_between(*before.file, next.file);
  const Revision revision = base + 1;
  const Weight weight = weight_of(next.file);
  if (weight.file > room_.marker_bytes) return {Commit::Outcome::kTooLarge, base};
  const std::size_t needed =
      weight.all() + (moves ? memory::bytes_of(*moves) : 0) + (next.answer ? next.answer->result->size() : 0);
  History history = entry->history;
  History::Recorded recorded = history.record(next.origin, before.file, moves);
  if (!room_.account->has_room(needed)) {
    history = entry->history;
    recorded = history.record(next.origin, before.file, moves, 0);
    const std::size_t freed = entry->history.bytes() - std::min(entry->history.bytes(), history.bytes());
    if (!room_.account->has_room(needed - std::min(needed, freed))) return {Commit::Outcome::kNoRoom, base};
  }
  Summary summary = summary_of(next.file.marker);
  summary.of_connection = entry->summary && entry->summary->of_connection;
  const auto change = change_of(entry->answers, next.answer);
  if (journal_ &&
      !journal_->changed(entry->number, {revision, moves, next.file, summary_text(summary), recorded, change})) {
    return {Commit::Outcome::kNotWritten, base};
  }
  Stamps stamps = stamps_after(*before.stamps, revision, moves, next.file);
  const Committed after = committed(revision, std::move(next.file), std::move(stamps), weight, room_.account);
  entry->history = std::move(history);
  {
    const std::lock_guard lock{mutex_};
    entry->current = after;
    entry->summary = std::move(summary);
    if (change) entry->answers.keep(change->answer);
  }
  entry->count();
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

Closed MarkerStore::close(const std::string& id, const std::optional<KeptAnswer>& answer,
                          const std::function<void()>& on_closed) {
  const auto entry = entry_of(id);  // a marker need not be read to be closed
  if (!entry) return close_quarantined(id, answer);
  const std::lock_guard writing{entry->writing};
  if (entry->closed) return Closed::kUnknown;
  const std::lock_guard answering{answering_};
  const auto change = change_of(answers_, answer);
  if (journal_ && !journal_->closed(entry->number, change)) return Closed::kNotWritten;
  entry->closed = true;
  {
    const std::lock_guard lock{mutex_};
    markers_.erase(id);
    keep_outside_markers(change);
  }
  if (on_closed) on_closed();
  return Closed::kDone;
}

Closed MarkerStore::close_quarantined(const std::string& id, const std::optional<KeptAnswer>& answer) {
  const std::lock_guard answering{answering_};
  if (quarantine(id).empty()) return Closed::kUnknown;
  const auto change = change_of(answers_, answer);
  if (!journal_->closed(std::stoull(id.substr(1)), change)) return Closed::kNotWritten;
  const std::lock_guard lock{mutex_};
  quarantined_.erase(id);
  keep_outside_markers(change);
  return Closed::kDone;
}

std::optional<KeptAnswer> MarkerStore::answer(const std::string& id, const std::string& op_id) const {
  const std::lock_guard lock{mutex_};
  const auto found = markers_.find(id);
  if (found == markers_.end() && !id.empty()) return std::nullopt;
  const KeptAnswer* kept = (id.empty() ? answers_ : found->second->answers).find(op_id);
  return kept ? std::optional{*kept} : std::nullopt;
}

Kept MarkerStore::keep(const std::string& id, const KeptAnswer& answer) {
  const auto entry = find(id);
  if (!entry) return Kept::kNotWritten;
  const std::lock_guard writing{entry->writing};
  if (entry->closed) return Kept::kNotWritten;
  if (!room_.account->has_room(answer.result->size())) return Kept::kNoRoom;
  const auto change = change_of(entry->answers, answer);
  if (journal_ && !journal_->answered(entry->number, *change)) return Kept::kNotWritten;
  {
    const std::lock_guard lock{mutex_};
    entry->answers.keep(change->answer);
  }
  entry->count();
  return Kept::kDone;
}

std::size_t MarkerStore::count() const {
  const std::lock_guard lock{mutex_};
  return markers_.size();
}

std::size_t MarkerStore::quarantined() const {
  const std::lock_guard lock{mutex_};
  return quarantined_.size();
}

}  // namespace selvage::server::store
