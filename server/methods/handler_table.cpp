#include "server/methods/handler_table.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

#include "server/methods/method_groups.h"

namespace selvage::server::methods {
namespace {

std::vector<HandledMethod> own_methods() {
  std::vector<HandledMethod> all;
  for (const auto& group : {engine_methods(), marker_methods(), watch_methods(), change_methods(), drag_methods(),
                            admin_methods(), library_methods()}) {
    std::copy(group.begin(), group.end(), std::back_inserter(all));
  }
  return all;
}

HandledMethod handled(const protocol::calls::Method& method, const std::vector<HandledMethod>& own) {
  const auto found =
      std::find_if(own.begin(), own.end(), [&](const HandledMethod& other) { return other.name == method.name; });
  if (found != own.end()) return *found;
  if (method.on_marker) return {method.name, motion_handler(method)};
  throw std::logic_error{"no handler for the method " + std::string{method.name}};
}

}  // namespace

HandlerTable::HandlerTable(const protocol::methods::MethodTable& methods) {
  constexpr std::string_view kCancel = "$/cancelRequest";  // the dispatcher's own
  const std::vector<HandledMethod> own = own_methods();
  for (const protocol::calls::Method& method : methods.all()) {
    if (method.name == kCancel) continue;
    HandledMethod found = handled(method, own);
    rows_.push_back({method, std::move(found.handle), found.file_use});
  }
}

const HandlerTable::Row* HandlerTable::find(std::string_view name) const {
  const auto found =
      std::find_if(rows_.begin(), rows_.end(), [name](const Row& row) { return row.method.name == name; });
  return found == rows_.end() ? nullptr : &*found;
}

}  // namespace selvage::server::methods
