#include "server/transport/connection_table.h"

#include <limits>
#include <tuple>
#include <utility>

namespace selvage::server::transport {

std::optional<access::Refusal> ConnectionTable::make_room(const std::string& address,
                                                          const std::function<void(const Entry&)>& on_closed) {
  const auto own = of_address_.find(address);
  const bool too_many = !address.empty() && own != of_address_.end() && own->second >= limits_.connections_per_address;
  if (!too_many && entries_.size() < limits_.connections) return std::nullopt;
  const Entry chosen = choose(too_many ? &address : nullptr);
  if (!chosen) return too_many ? access::Refusal::kAddress : access::Refusal::kConnections;
  erase(chosen);
  chosen->cut();
  on_closed(chosen);
  return std::nullopt;
}

void ConnectionTable::insert(Entry connection, const std::string& address) {
  ++of_address_[address];
  entries_.emplace(std::move(connection), address);
}

void ConnectionTable::erase(const Entry& connection) {
  const auto entry = entries_.find(connection);
  if (entry == entries_.end()) return;
  const auto count = of_address_.find(entry->second);
  if (--count->second == 0) of_address_.erase(count);
  entries_.erase(entry);
}

ConnectionTable::Entry ConnectionTable::choose(const std::string* address) const {
  using Standing = connections::Connection::Standing;
  Entry chosen;
  // Least first: of the address with the most connections; without a request before idle; the oldest.
  std::tuple<std::size_t, bool, connections::Connection::Time> rank;
  for (const auto& [connection, from] : entries_) {
    if (connection->standing() == Standing::kServed || (address != nullptr && from != *address)) continue;
    const std::tuple rank_here{std::numeric_limits<std::size_t>::max() - of_address_.at(from),
                               connection->standing() == Standing::kIdle, connection->standing_since()};
    if (chosen && rank_here >= rank) continue;
    chosen = connection;
    rank = rank_here;
  }
  return chosen;
}

}  // namespace selvage::server::transport
