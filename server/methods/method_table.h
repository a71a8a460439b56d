// The table of all methods of the server: the name of each, how it is scheduled and the function that decodes its
// calls.
//
// A method is either one of the server's own or one that works on a marker and that the command line also runs
// (protocol/methods/marker_methods.h).  Tests replace rows to put their own functions in the place of a motion.
#pragma once

#include <string_view>
#include <vector>

#include "server/methods/parsed_call.h"

namespace selvage::server::methods {

class MethodTable {
 public:
  MethodTable();

  // Null if there is no method of this name.
  [[nodiscard]] const Method* find(std::string_view name) const;
  [[nodiscard]] const std::vector<Method>& methods() const { return methods_; }
  // REQUIRES: the table has a method of this name.
  void replace(Method method);

 private:
  std::vector<Method> methods_;
};

}  // namespace selvage::server::methods
