// The markers that are open, each at its last committed revision, with what is kept beside it: what can be undone, and
// the last answers for retries.
//
// A committed marker never changes: readers share it while a motion works on the next one, and while that one is
// written to the journal.  Ids are "m1", "m2", ... in the order of opening and are never used twice; revisions of a
// marker count from 1.  With a journal, a revision is there for readers only once it is on disk.  Every function may be
// called from any thread.
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

#include "protocol/calls/messages.h"
#include "server/store/history.h"
#include "server/store/journal.h"
#include "server/store/kept_answers.h"

namespace selvage::server::store {

// At which revision each piece last moved, and the marker last changed in any other way.
struct Stamps {
  Revision whole{1};
  std::vector<Revision> pieces;
};

struct Committed {
  Revision revision{};
  std::shared_ptr<const MarkerFile> file;  // the marker, and what its document said beside it
  std::shared_ptr<const Stamps> stamps;
  std::shared_ptr<const protocol::execution::MadeOnce<std::string>> text;  // of marker.get
  std::shared_ptr<const protocol::execution::MadeOnce<scene::LaidOut>>
      laid_out;  // for motions of a piece, of which there may be many
};

struct OpenMarker {
  std::string id;
  Committed now;
};

// Why none was opened: as many as may be are open, or the journal failed.
enum class NotOpened { kLimit, kNotWritten };

struct NextRevision {
  MarkerFile file;
  Origin origin{};
  std::optional<KeptAnswer> answer{};  // of the call that makes it, when it has an opId
  // Called with it once it is there; for one marker in the order of revisions.
  std::function<void(const Committed&)> tell{};
};

// How a commit went.  Not written: the journal failed, nothing was changed.
struct Commit {
  enum class Outcome { kDone, kMismatch, kClosed, kNotWritten } outcome{};
  Revision revision{};  // the current one: the new one when done
};

class MarkerStore {
 public:
  // With a journal: all that it holds is open at once.
  explicit MarkerStore(std::size_t limit, Journal* journal = nullptr);

  // `answer`, when given, makes the answer to keep of the marker that was opened, or none.
  using OpenAnswer = std::function<std::optional<KeptAnswer>(const OpenMarker&)>;
  [[nodiscard]] std::variant<OpenMarker, NotOpened> open(MarkerFile file, const OpenAnswer& answer = {});
  // Nothing when no such marker is open.
  [[nodiscard]] std::optional<Committed> current(const std::string& id) const;
  [[nodiscard]] std::vector<OpenMarker> all() const;  // by id

  // Makes the file the revision after `base`, if `base` is still the current one.
  [[nodiscard]] Commit commit(const std::string& id, Revision base, NextRevision next);
  // What undoing or redoing would commit, and on which revision; no file when there is nothing to.  Nothing when no
  // such marker is open.
  struct Return {
    Committed from;
    std::optional<MarkerFile> file;
    std::size_t undo_steps{}, redo_steps{};  // before it
  };
  [[nodiscard]] std::optional<Return> way_back(const std::string& id, Way way) const;
  // False when no such marker is open.  `tell` as of NextRevision.
  [[nodiscard]] bool close(const std::string& id, const std::optional<KeptAnswer>& answer = {},
                           const std::function<void()>& tell = {});

  // The kept answers of a marker; of id "": those to calls that opened and closed markers.
  [[nodiscard]] std::optional<KeptAnswer> answer(const std::string& id, const std::string& op_id) const;
  // Keeps the answer to a call that changed nothing.  False when it could not be written.
  [[nodiscard]] bool keep(const std::string& id, const KeptAnswer& answer);

  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] std::size_t limit() const { return limit_; }

 private:
  // `current` and `answers` under the store's mutex; the rest under `writing`, which is taken first and held while the
  // journal writes.
  struct Held {
    std::mutex writing;
    bool closed{};
    History history;
    Committed current;
    KeptAnswers answers;
  };
  [[nodiscard]] std::shared_ptr<Held> held(const std::string& id) const;

  const std::size_t limit_;
  Journal* const journal_;
  mutable std::mutex mutex_;
  std::uint64_t opened_{};
  std::size_t opening_{};  // being written to the journal
  std::map<std::string, std::shared_ptr<Held>> markers_;
  KeptAnswers answers_;
};

}  // namespace selvage::server::store
