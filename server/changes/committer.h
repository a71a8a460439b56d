// How every change of a marker becomes its next revision: by an edit, an undo, a motion or a drag.
//
// A call that carries an `opId` and has been answered before gets the same answer again.  A call is settled before its
// change is committed, so that it can no longer be cancelled.  Watchers of the marker are notified of each revision, in
// order.  Every function may be called from any thread.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "server/calls/open_call.h"
#include "server/calls/outcome.h"
#include "server/changes/watchers.h"
#include "server/store/marker_store.h"

namespace selvage::server::changes {

// A change that is ready to be committed, and the call's answer if that succeeds.  The references are only used during
// the call of commit().
struct ReadyChange {
  std::string_view method;
  const std::string& marker_id;
  const store::Committed& before;
  MarkerFile after;
  store::Origin origin{};
  const std::optional<std::string>& op_id;
  Json result;  // of the call, with the revision after `before`
};

class Committer {
 public:
  // REQUIRES: both outlive the committer.
  Committer(store::MarkerStore& store, Watchers& watchers) : store_{store}, watchers_{watchers} {}

  // The kept answer to an earlier call with this `opId`, or an error if that was a call of another method or with other
  // parameters.  Returns nothing if there was no such call.  `marker_id` is empty for calls that open or close markers.
  [[nodiscard]] std::optional<calls::Outcome> earlier_answer(const std::string& marker_id,
                                                             const std::optional<std::string>& op_id,
                                                             std::string_view method,
                                                             const calls::OpenCall& call) const;
  // The form of the answer that is kept for retries.
  [[nodiscard]] static store::KeptAnswer kept_answer(const std::string& op_id, std::string_view method,
                                                     store::SharedText result, const calls::OpenCall& call);
  // Commits the change, notifies the watchers and returns the answer.  That is an error, and the marker is unchanged,
  // if the call was abandoned, the marker has a different revision by now, or the store cannot be written.
  [[nodiscard]] calls::Outcome commit(ReadyChange change, calls::OpenCall& call);
  // The answer to a call that changed nothing.  It is kept for retries if the call has an `opId`.
  [[nodiscard]] calls::Outcome keep_unchanged(std::string_view method, const std::string& marker_id,
                                              const std::optional<std::string>& op_id, Json result,
                                              const calls::OpenCall& call);

 private:
  store::MarkerStore& store_;
  Watchers& watchers_;
};

}  // namespace selvage::server::changes
