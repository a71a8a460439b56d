// What the server takes at most.  engine.info tells them.
#pragma once

#include <chrono>
#include <cstddef>

#include "server/transport/access/service.h"

namespace selvage::server::calls {

struct Limits {
  std::size_t open_markers{1000};
  std::size_t waiting_motions{64};  // beyond those that run
  std::size_t waiting_reads{256};
  std::size_t waiting_moves{256};  // of dragging hands
  // From the arrival of a call that may take long to the best it has by then.
  std::chrono::milliseconds call{std::chrono::minutes{10}};
  transport::access::TransportLimits transport;
};

}  // namespace selvage::server::calls
