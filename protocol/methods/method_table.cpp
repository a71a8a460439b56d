#include "protocol/methods/method_table.h"

#include <algorithm>
#include <array>
#include <utility>

#include "protocol/edits/changes.h"
#include "protocol/methods/daemon/markers.h"
#include "protocol/methods/daemon/progress.h"
#include "protocol/methods/dragging/drag_messages.h"

#define METHOD(room, name)            \
  namespace selvage::protocol::room { \
  calls::Method name();               \
  }
#include "protocol/methods/methods.def"
#undef METHOD

namespace selvage::protocol::methods {
namespace {

std::vector<calls::Method> all_methods() {
  return {
#define METHOD(room, name) protocol::room::name(),
#include "protocol/methods/methods.def"
#undef METHOD
  };
}

auto same_name(std::string_view name) {
  return [name](const calls::Method& method) { return method.name == name; };
}

}  // namespace

const calls::Method* MethodTable::find(std::string_view name) const {
  const auto found = std::find_if(methods_.begin(), methods_.end(), same_name(name));
  return found == methods_.end() ? nullptr : &*found;
}

void MethodTable::replace(calls::Method method) {
  *std::find_if(methods_.begin(), methods_.end(), same_name(method.name)) = std::move(method);
}

const MethodTable& method_table() {
  static const MethodTable kAll{all_methods()};
  return kAll;
}

std::span<const Notification> notifications() {
  static constexpr std::array kAll{
      Notification{"marker.changed", "A watched marker has a new revision.",
                   &schema::describe<edits::ChangedNotification>},
      Notification{"marker.closed", "A watched marker was closed.", &schema::describe<daemon::MarkerIdParams>},
      Notification{"marker.dragged", "The pieces of a watched marker that other connections drag have changed.",
                   &schema::describe<dragging::DraggedNotification>},
      Notification{"$/progress", "A round of a motion is done.", &schema::describe<daemon::Progress>}};
  return kAll;
}

}  // namespace selvage::protocol::methods
