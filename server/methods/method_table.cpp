#include "server/methods/method_table.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "server/methods/method_groups.h"

namespace selvage::server::methods {

MethodTable::MethodTable() {
  for (auto group : {engine_methods, marker_methods, watch_methods, change_methods, drag_methods, motion_methods}) {
    for (Method& method : group()) {
      // `marker.get` is in two groups: the server's own adds to that of the command line.
      if (!find(method.name)) methods_.push_back(std::move(method));
    }
  }
}

const Method* MethodTable::find(std::string_view name) const {
  const auto found =
      std::find_if(methods_.begin(), methods_.end(), [name](const Method& method) { return method.name == name; });
  return found == methods_.end() ? nullptr : &*found;
}

void MethodTable::replace(Method method) {
  const auto row =
      std::find_if(methods_.begin(), methods_.end(), [&](const Method& other) { return other.name == method.name; });
  *row = std::move(method);
}

}  // namespace selvage::server::methods
