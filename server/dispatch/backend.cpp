#include "server/dispatch/backend.h"

#include <algorithm>
#include <utility>

namespace selvage::server::dispatch {

Backend::Backend(BackendSettings settings)
    : limits_{settings.limits},
      sums_{settings.cache_bytes},
      store_{limits_.open_markers, settings.journal},
      methods_{settings.methods},
      executor_{std::max<std::size_t>(settings.workers, 1) - 1,
                [this, cores = settings.workers] { return idle_cores(cores); }},
      queues_{settings.workers, limits_},
      drags_{store_, committer_, sums_, queues_.drags, std::move(settings.drag)},
      context_{store_, watchers_, committer_, drags_, sums_, executor_, limits_, settings.workers, methods_},
      dispatcher_{context_, clock_, queues_, std::move(settings.on_answered)} {}

std::size_t Backend::idle_cores(std::size_t cores) const {
  return cores - std::min(cores, queues_.running());
}

}  // namespace selvage::server::dispatch
