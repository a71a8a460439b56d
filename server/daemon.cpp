#include "server/daemon.h"

#include <chrono>
#include <memory>
#include <string>
#include <utility>

namespace selvage {
namespace {

// Reads have their own workers, so that none waits behind a motion.
constexpr std::size_t kReadWorkers = 2;
// Nor does a dragging hand.
constexpr std::size_t kHandWorkers = 1;
constexpr std::chrono::seconds kFlushPatience{5};

}  // namespace

Daemon::Daemon(const Options& options, Engine engine)
    : sums_{options.cache_mb << 20},
      journal_{options.store.empty() ? nullptr : std::make_unique<Journal>(options.store, options.durability)},
      store_{options.limits.open_markers, journal_.get()},
      methods_{store_, watchers_, sums_, options.limits, options.workers, std::move(engine)},
      reads_{options.workers == 0 ? 0 : kReadWorkers, options.limits.waiting_reads},
      motions_{options.workers, options.limits.waiting_motions},
      hands_{options.workers == 0 ? 0 : kHandWorkers, options.limits.waiting_moves},
      drags_{store_, methods_, sums_, hands_},
      dispatcher_{methods_, drags_, clock_, reads_, motions_, options.limits.transport.body_bytes},
      transport_{
          options.host, options.port, options.limits.transport,
          Service{.call = [this](std::string message, const std::shared_ptr<Session>& session,
                                 Reply reply) { dispatcher_.receive(std::move(message), session, std::move(reply)); },
                  .health = [] { return std::string{"{\"status\":\"ok\"}"}; },
                  .line_too_long = Dispatcher::too_long(options.limits.transport.body_bytes)}} {}

Daemon::~Daemon() {
  drain();
}

void Daemon::drain() {
  transport_.stop_reading();
  motions_.drain();
  hands_.drain();
  reads_.drain();
  transport_.finish(kFlushPatience);
}

}  // namespace selvage
