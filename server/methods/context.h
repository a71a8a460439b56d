// The parts of the server that its methods work with.
#pragma once

#include <cstddef>

#include "core/base/executor.h"
#include "core/minkowski/cache.h"
#include "server/calls/limits.h"
#include "server/changes/committer.h"
#include "server/changes/connection_markers.h"
#include "server/changes/watchers.h"
#include "server/drags/drag_sessions.h"
#include "server/library/library.h"
#include "server/store/marker_store.h"

namespace selvage::server::methods {

class HandlerTable;

// REQUIRES: all references outlive every call.
struct ServerContext {
  store::MarkerStore& store;
  library::Library& library;
  changes::Watchers& watchers;
  changes::Committer& committer;
  changes::ConnectionMarkers& connection_markers;
  drags::DragSessions& drags;
  SumCache& sums;
  const Executor& executor;  // on which motions run parts of their work in parallel
  const calls::Limits& limits;
  std::size_t workers{};  // for motions
  const HandlerTable& methods;
};

}  // namespace selvage::server::methods
