// The last answers to calls that carried an `opId`, so that a retry gets the same answer and nothing is done twice.
//
// There are at most kMost answers of at most kMaxBytes together.  The first to be forgotten is the oldest answer of the
// connection with the most answers, among the connections of the address with the most answers.  So no client can
// displace the answers to a client that has fewer, whether it keeps one connection or opens a new one for every call.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace selvage::server::store {

// The text of a result, shared by everything that sends or keeps it.
using SharedText = std::shared_ptr<const std::string>;

struct KeptAnswer {
  std::string op_id, method;
  SharedText result;
  std::string client{};    // who made the call: an address, kConnection, the number of a connection
  std::int64_t params{};   // a checksum of its parameters; 0: not known
  std::uint64_t serial{};  // larger than those of all earlier answers; set when it is kept
};

class KeptAnswers {
 public:
  static constexpr char kConnection = '#';
  static constexpr std::size_t kMost = 256;
  static constexpr std::size_t kMaxBytes = std::size_t{8} << 20;

  // Null if the answer was never kept or has been forgotten.
  [[nodiscard]] const KeptAnswer* find(const std::string& op_id) const;
  [[nodiscard]] std::uint64_t next_serial() const { return last_serial_ + 1; }
  // The serials of the answers that will be forgotten when this one is kept.
  [[nodiscard]] std::vector<std::uint64_t> forgotten_for(const KeptAnswer& answer) const;
  // Keeps the answer, and forgets what forgotten_for() says.  An answer without a serial gets the next one.
  void keep(KeptAnswer answer);
  [[nodiscard]] std::size_t count() const { return by_serial_.size(); }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

 private:
  void forget(std::uint64_t serial);

  std::map<std::uint64_t, KeptAnswer> by_serial_;
  std::map<std::string, std::uint64_t> by_op_;
  std::map<std::string, std::size_t> of_client_;  // the number of answers, by client and by address
  std::size_t bytes_{};
  std::uint64_t last_serial_{};
};

}  // namespace selvage::server::store
