// The limits of the server, as `engine.info` reports them.
#pragma once

#include <chrono>
#include <cstddef>

#include "server/transport/access/service.h"

namespace selvage::server::calls {

struct Limits {
  std::size_t markers_bytes{std::size_t{1232} << 20};  // of all markers, with their histories and kept answers
  std::size_t marker_bytes{std::size_t{256} << 20};    // of one marker, without these
  // The calls that may wait in a queue; calls that are being executed are not counted.
  std::size_t waiting_motions{64};
  std::size_t waiting_reads{256};
  std::size_t waiting_moves{256};  // of drag sessions
  // Motions and long reads are stopped after this time, counted from the call's arrival.
  std::chrono::milliseconds call{std::chrono::minutes{10}};
  transport::access::TransportLimits transport;
};

}  // namespace selvage::server::calls
