// The open markers, each at its last committed revision, with its undo and redo history and the last answers for
// retries.
//
// A committed marker never changes: readers share it while a motion works on the next revision and while that is
// written to the journal.  Ids are "m1", "m2", ... in the order of opening and are never used twice; revisions of a
// marker count from 1.  With a journal, readers see a revision only when it is on disk.  Every function may be called
// from any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/scene/laid_out.h"
#include "protocol/calls/params.h"
#include "protocol/execution/made_once.h"
#include "server/store/history.h"
#include "server/store/journal.h"
#include "server/store/kept_answers.h"

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

// Why no marker was opened: the limit is reached, or the journal failed.
enum class NotOpened { kLimit, kNotWritten };

struct NextRevision {
  MarkerFile file;
  Origin origin{};
  std::optional<KeptAnswer> answer{};  // of the call that makes it, when it has an opId
  // Called when it has become the current revision; for one marker in the order of revisions.
  std::function<void(const Committed&)> on_committed{};
};

// The result of a commit.  kNotWritten: the journal failed and nothing was changed.
struct Commit {
  enum class Outcome { kDone, kMismatch, kClosed, kNotWritten } outcome{};
  Revision revision{};  // the current one, which is the new one after kDone
};

class MarkerStore {
 public:
  // Opens all markers of the journal, if there is one.
  explicit MarkerStore(std::size_t limit, Journal* journal = nullptr);

  // `answer` makes the answer to keep for retries from the opened marker, or none.
  using OpenAnswer = std::function<std::optional<KeptAnswer>(const OpenMarker&)>;
  [[nodiscard]] std::variant<OpenMarker, NotOpened> open(MarkerFile file, const OpenAnswer& answer = {});
  // Nothing if no such marker is open.
  [[nodiscard]] std::optional<Committed> current(const std::string& id) const;
  [[nodiscard]] std::vector<OpenMarker> all() const;  // in the order of ids

  // Makes the file the revision after `base` if `base` is still the current revision.
  [[nodiscard]] Commit commit(const std::string& id, Revision base, NextRevision next);
  // What undoing or redoing one step would commit.
  struct UndoResult {
    Committed from;                          // the current revision
    std::optional<MarkerFile> file;          // nothing if there is no step
    std::size_t undo_steps{}, redo_steps{};  // of the current revision
  };
  // Nothing if no such marker is open.
  [[nodiscard]] std::optional<UndoResult> peek(const std::string& id, UndoDirection direction) const;
  // Returns false if no such marker is open.  `on_closed` is called when the marker is closed.
  [[nodiscard]] bool close(const std::string& id, const std::optional<KeptAnswer>& answer = {},
                           const std::function<void()>& on_closed = {});

  // The kept answer to a call on a marker or, if the id is empty, to a call that opened or closed a marker.
  [[nodiscard]] std::optional<KeptAnswer> answer(const std::string& id, const std::string& op_id) const;
  // Keeps the answer to a call that changed nothing.  Returns false if it could not be written.
  [[nodiscard]] bool keep(const std::string& id, const KeptAnswer& answer);

  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] std::size_t limit() const { return limit_; }
  // Whether markers survive the end of the process.
  [[nodiscard]] bool is_durable() const { return journal_ != nullptr; }

 private:
  // The store's mutex protects `current` and `answers`; `writing` protects the rest.  `writing` is locked first, and
  // held while the journal writes.
  struct Entry {
    std::mutex writing;
    bool closed{};
    History history;
    Committed current;
    KeptAnswers answers;
  };
  [[nodiscard]] std::shared_ptr<Entry> find(const std::string& id) const;

  const std::size_t limit_;
  Journal* const journal_;
  mutable std::mutex mutex_;
  std::uint64_t opened_{};
  std::size_t opening_{};  // markers that are being written to the journal
  std::map<std::string, std::shared_ptr<Entry>> markers_;
  KeptAnswers answers_;
};

}  // namespace selvage::server::store
