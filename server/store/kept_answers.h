// The last answers to calls that carried an `opId`, so that a retry gets the same answer and nothing is done twice. The
// oldest answer is removed first.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <string>

namespace selvage::server::store {

// The text of a result, shared by all who send or keep it.
using SharedText = std::shared_ptr<const std::string>;

struct KeptAnswer {
  std::string op_id, method;
  SharedText result;
};

class KeptAnswers {
 public:
  static constexpr std::size_t kMost = 256;

  // Null if the answer is not kept, or no longer.
  [[nodiscard]] const KeptAnswer* find(const std::string& op_id) const {
    const auto found = by_id_.find(op_id);
    return found == by_id_.end() ? nullptr : &found->second;
  }
  void keep(KeptAnswer answer) {
    const std::string op_id = answer.op_id;
    if (by_id_.insert_or_assign(op_id, std::move(answer)).second) order_.push_back(op_id);
    if (order_.size() <= kMost) return;
    by_id_.erase(order_.front());
    order_.pop_front();
  }

 private:
  std::map<std::string, KeptAnswer> by_id_;
  std::deque<std::string> order_;
};

}  // namespace selvage::server::store
