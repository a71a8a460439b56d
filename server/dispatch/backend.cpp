#include "server/dispatch/backend.h"

#include <algorithm>
#include <string>
#include <utility>

namespace selvage::server::dispatch {
namespace {

constexpr jobs::JobQueue::Milliseconds kLongestQuickWait{1000};

}  // namespace

Backend::Backend(BackendSettings settings)
    : limits_{settings.limits},
      sums_{settings.cache_bytes},
      store_{{std::make_shared<memory::ByteAccount>(limits_.markers_bytes), limits_.marker_bytes},
             settings.journal,
             std::move(settings.loading)},
      library_{settings.journal},
      methods_{settings.methods},
      executor_{std::max<std::size_t>(settings.workers, 1) - 1,
                [this, cores = settings.workers] { return idle_cores(cores); }},
      queues_{settings.workers, limits_, clock_},
      drags_{store_, committer_, watchers_, sums_, queues_.drags, std::move(settings.drag)},
      context_{store_,    library_, watchers_,        committer_, connection_markers_, drags_, sums_,
               executor_, limits_,  settings.workers, methods_},
      dispatcher_{context_, clock_, queues_, std::move(settings.on_answered)} {}

// The jobs end first, then the alarms, because both may use the members that are destroyed after them.
Backend::~Backend() {
  queues_.drain();
  clock_.stop();
}

std::string Backend::why_not_ready() const {
  if (const std::string failure = store_.failure(); !failure.empty()) return "the store cannot be written: " + failure;
  if (queues_.motions.waiting() >= queues_.motions.capacity()) return "the queue of motions is full";
  if (queues_.reads.waiting() >= queues_.reads.capacity()) return "the queue of reads is full";
  const auto wait = queues_.longest_quick_wait();
  if (wait <= kLongestQuickWait) return {};
  return "interactive calls have been waiting for " + std::to_string(static_cast<int>(wait.count())) + " ms";
}

std::size_t Backend::idle_cores(std::size_t cores) const {
  return cores - std::min(cores, queues_.running());
}

}  // namespace selvage::server::dispatch
