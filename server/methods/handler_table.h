// The methods of the server: each method of the protocol with its handler.
//
// Tests pass a table of the protocol's methods in which they replace some rows by their own functions, which wait,
// throw exceptions or never end.
#pragma once

#include <string_view>
#include <vector>

#include "protocol/methods/method_table.h"
#include "server/methods/handler.h"

namespace selvage::server::methods {

class HandlerTable {
 public:
  struct Row {
    protocol::calls::Method method;
    Handler handle;
    FileUse file_use{};
  };

  explicit HandlerTable(const protocol::methods::MethodTable& methods = protocol::methods::method_table());

  // Null if there is no method of this name.
  [[nodiscard]] const Row* find(std::string_view name) const;
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

 private:
  std::vector<Row> rows_;
};

}  // namespace selvage::server::methods
