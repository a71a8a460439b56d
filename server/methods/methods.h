// Every method of the server, given a thread to do it on.  No sockets, no queues: params in, result or error out.
//
// A method is one of the server's own, in the table of methods.cpp and in marker_calls.cpp and change_calls.cpp, or one
// that works on a marker, from the table that the command line runs too (protocol/marker_methods.h); motion_calls.cpp
// runs those.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "protocol/methods/marker_methods.h"
#include "protocol/rpc/json_rpc.h"
#include "server/calls/limits.h"
#include "server/calls/open_call.h"
#include "server/calls/outcome.h"
#include "server/methods/watchers.h"
#include "server/store/marker_store.h"

namespace selvage::server::methods {

// A call, now that it has a thread.
struct CallTurn {
  calls::OpenCall& call;
  std::stop_token stop;  // hand back the best so far, for whatever reason
};

// Where a method runs: at once on the thread that read the call; on a worker for reads, which long ones leave some of
// to others; on a worker for motions in its marker's lane, of which long ones do likewise; or where the dragging hand
// is served.
enum class RunsOn { kAtOnce, kRead, kStudy, kStep, kMotion, kDrag };
// Nothing when there is no method of this name.
[[nodiscard]] std::optional<RunsOn> runs_on(std::string_view method);

// The OpenRPC document of all methods, as text.
[[nodiscard]] std::string openrpc_text();

// A change that is ready to be committed, and what is answered when it is.
struct ReadyChange {
  std::string_view method;
  const std::string& marker_id;
  const store::Committed& before;
  MarkerFile after;
  store::Origin origin{};
  const std::optional<std::string>& op_id;
  const Json& fields;  // of the answer: all but markerId and revision
};

class Methods {
 public:
  Methods(store::MarkerStore& store, Watchers& watchers, SumCache& sums, const calls::Limits& limits,
          std::size_t workers, protocol::calls::Engine engine, const Executor& executor = serial())
      : store_{store},
        watchers_{watchers},
        sums_{sums},
        limits_{limits},
        workers_{workers},
        engine_{std::move(engine)},
        executor_{executor} {}

  // REQUIRES: place_of knows the method, and it is none of the drags'.
  [[nodiscard]] calls::Outcome call(std::string_view method, const Json& params, const CallTurn& turn);

  // The answer kept of an earlier call of this opId; nothing when there is none.  `marker_id` as of
  // MarkerStore::answer.
  [[nodiscard]] std::optional<calls::Outcome> replay(const std::string& marker_id,
                                                     const std::optional<std::string>& op_id,
                                                     std::string_view method) const;
  // Makes the change the marker's next revision, tells those who watch it, and answers.
  [[nodiscard]] calls::Outcome commit(ReadyChange change, const CallTurn& turn);
  // The answer to a call that changed nothing, kept when it has an opId.
  [[nodiscard]] calls::Outcome unchanged(std::string_view method, const std::string& marker_id,
                                         const std::optional<std::string>& op_id, Json result);
  // Is the marker that these parameters name so large that reading it may take long?
  [[nodiscard]] bool large(const Json& params) const;
  [[nodiscard]] const protocol::calls::Engine& engine() const { return engine_; }

  [[nodiscard]] calls::Outcome engine_info(const Json& params, const CallTurn& turn);
  [[nodiscard]] calls::Outcome rpc_discover(const Json& params, const CallTurn& turn);
  [[nodiscard]] calls::Outcome marker_open(const Json& params, const CallTurn& turn);
  [[nodiscard]] calls::Outcome marker_list(const Json& params, const CallTurn& turn);
  [[nodiscard]] calls::Outcome marker_get(const Json& params, const CallTurn& turn);
  [[nodiscard]] calls::Outcome marker_close(const Json& params, const CallTurn& turn);
  [[nodiscard]] calls::Outcome marker_watch(const Json& params, const CallTurn& turn);
  [[nodiscard]] calls::Outcome marker_unwatch(const Json& params, const CallTurn& turn);
  [[nodiscard]] calls::Outcome marker_apply(const Json& params, const CallTurn& turn);
  [[nodiscard]] calls::Outcome marker_undo(const Json& params, const CallTurn& turn);
  [[nodiscard]] calls::Outcome marker_redo(const Json& params, const CallTurn& turn);

 private:
  [[nodiscard]] calls::Outcome call_on_marker(const protocol::calls::MarkerMethod& method, const Json& params,
                                              const CallTurn& turn);
  [[nodiscard]] calls::Outcome way_back(std::string_view method, const Json& params, const CallTurn& turn,
                                        store::Way way);

  store::MarkerStore& store_;
  Watchers& watchers_;
  SumCache& sums_;
  const calls::Limits limits_;
  const std::size_t workers_;
  const protocol::calls::Engine engine_;
  const Executor& executor_;  // of every motion
};

}  // namespace selvage::server::methods
