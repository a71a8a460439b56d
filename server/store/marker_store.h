// The open markers, each at its last committed revision, with its undo and redo history and the last answers for
// retries.
//
// A committed marker never changes: readers share it while a motion works on the next revision and while that is
// written to the journal.  Ids are "m1", "m2", ... in the order of opening and are never used twice; revisions of a
// marker count from 1.  With a journal, readers see a revision only when it is on disk.
//
// Everything that is kept is counted in one account of bytes.  When the account has no room, no marker can be opened,
// and a change first drops the undo steps of its marker; it is refused if that does not suffice.  An eighth of the
// account is reserved for changes, so that the markers of a full store can still be edited.  A marker of the journal
// for which there is no room when it is first used stays in the journal, and is not read until there is.
//
// A marker of the journal is kept as the bytes of its rows until it is first used, but its revision and summary are
// available at once.  A marker whose rows are damaged is quarantined: it is not open, its rows stay in the file, and it
// can only be closed.  Every function may be called from any thread.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

#include "core/scene/laid_out.h"
#include "protocol/calls/params.h"
#include "protocol/execution/made_once.h"
#include "server/memory/byte_account.h"
#include "server/store/history.h"
#include "server/store/journal.h"
#include "server/store/kept_answers.h"
#include "server/store/summary.h"

namespace selvage::server::store {

// The revision at which each piece last moved, and the one at which anything else of the marker last changed.
struct Stamps {
  Revision whole{1};
  std::vector<Revision> pieces;
};

struct Committed {
  Revision revision{};
  std::shared_ptr<const MarkerFile> file;  // the marker with the other content of its document
  std::shared_ptr<const Stamps> stamps;
  std::shared_ptr<const protocol::execution::MadeOnce<std::string>> text;  // the answer to marker.get
  std::shared_ptr<const protocol::execution::MadeOnce<scene::LaidOut>>
      laid_out;  // for motions of a single piece, of which there may be many
};

struct OpenMarker {
  std::string id;
  Committed now;
};
struct ListedMarker {
  std::string id;
  Revision revision{};
  Summary summary;
};

// The memory that markers may take.
struct Room {
  std::shared_ptr<memory::ByteAccount> account = std::make_shared<memory::ByteAccount>();  // of all of them
  std::size_t marker_bytes{std::size_t{256} << 20};                                        // of one of them
};

// Why a marker was not opened: it is too large, there is no room left for markers, or the journal failed.
enum class NotOpened { kTooLarge, kNoRoom, kNotWritten };

// To whom a marker belongs.  One of a connection is closed with it; the next start closes one that is left in a
// journal.
enum class Owner { kDaemon, kConnection };

enum class Closed { kDone, kUnknown, kNotWritten };

// Whether an answer was kept.
enum class Kept { kDone, kNoRoom, kNotWritten };

struct NextRevision {
  MarkerFile file;
  Origin origin{};
  std::optional<KeptAnswer> answer{};  // of the call that makes it, when it has an opId
  // Called when the change has become the current revision, for each marker in the order of its revisions.
  std::function<void(const Committed&)> on_committed{};
};

// The result of a commit.  Every outcome except kDone means that nothing was changed.
struct Commit {
  // kTooLarge, kNoRoom and kNotWritten have the same meaning as in NotOpened.
  enum class Outcome { kDone, kMismatch, kClosed, kTooLarge, kNoRoom, kNotWritten } outcome{};
  Revision revision{};  // the current one, which is the new one after kDone
};

class MarkerStore {
 public:
  // Opens all markers of the journal, if there is one.  Throws as Journal::restore.
  explicit MarkerStore(Room room = {}, Journal* journal = nullptr, std::stop_token stop = {});

  // `answer` returns the answer to keep for retries, given the opened marker, or nothing.
  using OpenAnswer = std::function<std::optional<KeptAnswer>(const OpenMarker&)>;
  [[nodiscard]] std::variant<OpenMarker, NotOpened> open(MarkerFile file, const OpenAnswer& answer = {},
                                                         Owner owner = Owner::kDaemon);
  // Returns nothing if no such marker is open, or if there is no room to read it from the journal.
  [[nodiscard]] std::optional<Committed> current(const std::string& id) const;
  [[nodiscard]] std::vector<ListedMarker> all() const;  // in the order of ids
  // The summary of its current revision; nothing if no such marker is open.
  [[nodiscard]] std::optional<Summary> summary(const std::string& id) const;
  [[nodiscard]] bool is_open(const std::string& id) const;
  // Whether the next use of the marker will read it from the journal, which may take long.
  [[nodiscard]] bool is_unread(const std::string& id) const;
  // Why the marker is quarantined; empty if it is not.
  [[nodiscard]] std::string quarantine(const std::string& id) const;

  // Makes the file the revision after `base` if `base` is still the current revision.
  [[nodiscard]] Commit commit(const std::string& id, Revision base, NextRevision next);
  // The change that undoing or redoing one step would commit.
  struct UndoResult {
    Committed from;                          // the current revision
    std::optional<MarkerFile> file;          // nothing if there is no step
    std::size_t undo_steps{}, redo_steps{};  // of the current revision
  };
  // Nothing if no such marker is open.
  [[nodiscard]] std::optional<UndoResult> peek(const std::string& id, UndoDirection direction) const;
  // Closes an open or a quarantined marker.  `on_closed` is called when the closing of an open one is written.
  [[nodiscard]] Closed close(const std::string& id, const std::optional<KeptAnswer>& answer = {},
                             const std::function<void()>& on_closed = {});

  // The kept answer to a call on a marker or, if the id is empty, to a call that opened or closed a marker.
  [[nodiscard]] std::optional<KeptAnswer> answer(const std::string& id, const std::string& op_id) const;
  // Keeps the answer to a call that changed nothing.
  [[nodiscard]] Kept keep(const std::string& id, const KeptAnswer& answer);

  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] std::size_t quarantined() const;
  // Why changes cannot be written; empty if no reason is known.
  [[nodiscard]] std::string failure() const { return journal_ ? journal_->failure() : std::string{}; }
  [[nodiscard]] const Room& room() const { return room_; }
  // As Journal::back_up.  REQUIRES: is_durable().
  std::uint64_t back_up(const std::string& name) { return journal_->back_up(name); }
  // As long as it is the same, an id names the same marker: that of the journal or, without one, made by this object.
  [[nodiscard]] const std::string& identity() const { return identity_; }
  // Whether markers survive the end of the process.
  [[nodiscard]] bool is_durable() const { return journal_ != nullptr; }

 private:
  // The store's mutex protects `current`, `summary` and `answers`; `writing` protects the rest.  `writing` is locked
  // first, and held while the journal writes; `loading` is locked while the rows are read, with nothing else locked.
  struct Entry {
    explicit Entry(std::shared_ptr<memory::ByteAccount> account) : held{std::move(account)} {}
    // Counts what this object keeps, except the marker and whole earlier markers, which count themselves.
    void count();

    std::uint64_t number{};
    std::mutex writing;
    bool closed{};
    History history;
    Revision stored_revision{};
    std::optional<Summary> summary;
    Committed current;
    KeptAnswers answers;
    std::mutex loading;
    std::atomic<bool> loaded{};
    std::optional<disk::StoredMarker> stored;  // until it is loaded
    memory::HeldBytes held;
  };
  // Null if no such marker is open.
  [[nodiscard]] std::shared_ptr<Entry> entry_of(const std::string& id) const;
  // The same, read from the journal if necessary.  Also null if it is damaged, or if there is no room to read it.
  [[nodiscard]] std::shared_ptr<Entry> find(const std::string& id) const;
  [[nodiscard]] bool load(const std::string& id, Entry& entry) const;
  void restore(disk::StoredContent content);
  void keep_outside_markers(const std::optional<KeptChange>& change);
  [[nodiscard]] Closed close_quarantined(const std::string& id, const std::optional<KeptAnswer>& answer);

  const Room room_;
  Journal* const journal_;
  const std::string identity_;
  mutable std::mutex mutex_;
  std::uint64_t opened_{};
  mutable std::map<std::string, std::shared_ptr<Entry>> markers_;
  mutable std::map<std::string, std::string> quarantined_;  // why
  std::mutex answering_;  // held while an answer to a call that opens or closes a marker is written
  KeptAnswers answers_;
  memory::HeldBytes held_answers_{room_.account};
};

}  // namespace selvage::server::store
