// The typed parameters and results of the methods about markers as a whole; those on one marker are in methods/.
// Their JSON is in codec.h; every field is explained in README.md.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/minkowski/cache.h"
#include "protocol/calls/method.h"
#include "protocol/formats/format.h"

namespace selvage::protocol::calls {

// engine.info {}
struct EngineInfo {
  std::string version;
  int workers{};
  std::size_t markers{};  // open
  std::size_t max_request_bytes{};
  std::vector<std::string_view> methods;
  minkowski::CacheCounts cache;
};

// marker.open {"marker": document, "spacing"?, "opId"?}
struct MarkerOpen {
  MarkerFile file;                   // with the spacing applied
  std::optional<std::string> op_id;  // the client's name for the call: a retry of it gets the same answer
};
struct MarkerOpened {
  std::string marker_id;
  Revision revision{};
  std::size_t pieces{};
  double length{};  // in the marker's unit
  double utilisation{};
  bool valid{};
  std::vector<Note> notes;
};

// marker.close {"markerId", "opId"?}
struct MarkerClose {
  std::string marker_id;
  std::optional<std::string> op_id;
};
struct MarkerClosed {
  std::string marker_id;
};

}  // namespace selvage::protocol::calls
