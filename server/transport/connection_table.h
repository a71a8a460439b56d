// The open connections, and which of them makes room for another when there are too many.
//
// A connection that has not sent a whole request yet, or that waits for the client's next HTTP request, may be closed
// to make room.  It is chosen from the address with the most connections, so that a client that opens many does not
// close those of others.  Among these, connections that have not sent a request come first, the oldest of them first.
// Everything here belongs to the I/O thread.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "server/transport/access/refusal.h"
#include "server/transport/access/service.h"
#include "server/transport/connections/connection.h"

namespace selvage::server::transport {

class ConnectionTable {
 public:
  using Entry = std::shared_ptr<connections::Connection>;
  explicit ConnectionTable(const access::TransportLimits& limits) : limits_{limits} {}

  // Makes room for a connection from this address, closing another one if necessary.  Returns why there is none.
  // `on_closed` is called for the one that is closed.  The address is empty for Unix sockets, which are not limited by
  // address.
  [[nodiscard]] std::optional<access::Refusal> make_room(const std::string& address,
                                                         const std::function<void(const Entry&)>& on_closed);
  void insert(Entry connection, const std::string& address);
  void erase(const Entry& connection);

  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  [[nodiscard]] auto begin() const { return entries_.begin(); }
  [[nodiscard]] auto end() const { return entries_.end(); }

 private:
  // The connection to close; if `address` is given, one from this address.  Null if none may be closed.
  [[nodiscard]] Entry choose(const std::string* address) const;

  const access::TransportLimits& limits_;
  std::map<Entry, std::string> entries_;  // with their addresses
  std::map<std::string, std::size_t> of_address_;
};

}  // namespace selvage::server::transport
