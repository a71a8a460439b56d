// The table of all methods: the one that the daemon and the command line both run.
//
// A new method is one file that defines a function returning its calls::Method, and one line in methods.def.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "protocol/calls/method.h"

namespace selvage::protocol::methods {

class MethodTable {
 public:
  explicit MethodTable(std::vector<calls::Method> methods) : methods_{std::move(methods)} {}

  [[nodiscard]] std::span<const calls::Method> all() const { return methods_; }
  // Null when there is none of this name.
  [[nodiscard]] const calls::Method* find(std::string_view name) const;
  // Replaces the method with the same name.  Tests insert methods that wait, throw or never end.  REQUIRES: there is
  // one.
  void replace(calls::Method method);

 private:
  std::vector<calls::Method> methods_;
};

[[nodiscard]] const MethodTable& method_table();
[[nodiscard]] inline const calls::Method* find_method(std::string_view name) {
  return method_table().find(name);
}

// A notification that the daemon sends.
struct Notification {
  std::string_view name, summary;
  std::vector<schema::FieldDescription> (*params)(){};
};
[[nodiscard]] std::span<const Notification> notifications();

}  // namespace selvage::protocol::methods
