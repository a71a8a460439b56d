// The notification $/progress: sent to the caller of a motion with a progress token, after each round.
#pragma once

#include "protocol/calls/params.h"

namespace selvage::protocol::methods::daemon {

struct Progress {
  calls::ProgressToken token;
  int round{};
  double length{};

  static void describe(auto& v, auto& self) {
    v.required("token", self.token, "The call's progressToken.");
    v.required("round", self.round, "The number of the round.");
    v.required("length", self.length, "The marker's length after it.");
  }
};

}  // namespace selvage::protocol::methods::daemon
