#include "server/daemon.h"

#include <chrono>
#include <memory>
#include <string>
#include <utility>

namespace selvage {
namespace {

// Reads have their own workers, so that none waits behind a motion.
constexpr std::size_t kReadWorkers = 2;
constexpr std::chrono::seconds kFlushPatience{5};

}  // namespace

Daemon::Daemon(const Options& options, Engine engine)
    : sums_{options.cache_mb << 20},
      store_{options.limits.open_markers},
      methods_{store_, sums_, options.limits, options.workers, std::move(engine)},
      reads_{options.workers == 0 ? 0 : kReadWorkers, options.limits.waiting_reads},
      motions_{options.workers, options.limits.waiting_motions},
      dispatcher_{methods_, reads_, motions_, options.limits.transport.body_bytes},
      transport_{options.host, options.port, options.limits.transport,
                 Service{.call =
                             [this](std::string message, const std::shared_ptr<Session>& session, Reply reply) {
                               dispatcher_.receive(std::move(message), session->gone, std::move(reply));
                             },
                         .health = [] { return std::string{"{\"status\":\"ok\"}"}; },
                         .line_too_long = Dispatcher::too_long(options.limits.transport.body_bytes)}} {}

Daemon::~Daemon() {
  drain();
}

void Daemon::drain() {
  transport_.stop_reading();
  motions_.drain();
  reads_.drain();
  transport_.finish(kFlushPatience);
}

}  // namespace selvage
