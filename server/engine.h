// The core as the server calls it.  Tests put their own functions in its place: one that waits, throws or
// never ends.
#pragma once

#include <functional>

#include "core/marker/validity.h"
#include "core/motion/compact.h"

namespace selvage {

struct Engine {
  std::function<Result<Compaction>(const Marker&, const CompactionSettings&, SumCache&, std::stop_token,
                                   const Observer&)>
      compact = selvage::compact;
  std::function<Validity(const Marker&, SumCache&)> check = selvage::check;
};

}  // namespace selvage
