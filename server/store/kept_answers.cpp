#include "server/store/kept_answers.h"

#include <algorithm>
#include <utility>

namespace selvage::server::store {
namespace {

std::size_t bytes_of(const KeptAnswer& answer) {
  return sizeof(KeptAnswer) + answer.op_id.size() + answer.method.size() + answer.client.size() + answer.result->size();
}

std::string address_of(const KeptAnswer& answer) {
  return answer.client.substr(0, answer.client.rfind(KeptAnswers::kConnection) + 1);
}

}  // namespace

const KeptAnswer* KeptAnswers::find(const std::string& op_id) const {
  const auto found = by_op_.find(op_id);
  return found == by_op_.end() ? nullptr : &by_serial_.at(found->second);
}

std::vector<std::uint64_t> KeptAnswers::forgotten_for(const KeptAnswer& answer) const {
  std::vector<std::uint64_t> forgotten;
  auto counts = of_client_;  // the new answer's client counts as one that has it already
  std::size_t count = by_serial_.size() + 1;
  std::size_t bytes = bytes_ + bytes_of(answer);
  ++counts[answer.client];
  ++counts[address_of(answer)];
  const auto forget = [&](const KeptAnswer& old) {
    forgotten.push_back(old.serial);
    --counts[old.client];
    --counts[address_of(old)];
    --count;
    bytes -= bytes_of(old);
  };
  if (const KeptAnswer* same = find(answer.op_id)) forget(*same);
  const auto is_forgotten = [&](std::uint64_t serial) {
    return std::find(forgotten.begin(), forgotten.end(), serial) != forgotten.end();
  };
  while ((count > kMost || bytes > kMaxBytes) && count > 1) {
    // Of two with the same number of answers, the one with the oldest answer comes first.
    const auto share = [&counts](const KeptAnswer& of) { return std::pair{counts[address_of(of)], counts[of.client]}; };
    const KeptAnswer* victim = nullptr;
    for (const auto& [serial, old] : by_serial_) {
      if (is_forgotten(serial)) continue;
      if (!victim || share(old) > share(*victim)) victim = &old;
    }
    forget(*victim);
  }
  return forgotten;
}

void KeptAnswers::keep(KeptAnswer answer) {
  for (const std::uint64_t serial : forgotten_for(answer)) forget(serial);
  if (answer.serial == 0) answer.serial = next_serial();
  last_serial_ = std::max(last_serial_, answer.serial);
  bytes_ += bytes_of(answer);
  ++of_client_[answer.client];
  ++of_client_[address_of(answer)];
  by_op_[answer.op_id] = answer.serial;
  const std::uint64_t serial = answer.serial;
  by_serial_.insert_or_assign(serial, std::move(answer));
}

void KeptAnswers::forget(std::uint64_t serial) {
  const auto found = by_serial_.find(serial);
  bytes_ -= bytes_of(found->second);
  for (const std::string& who : {found->second.client, address_of(found->second)}) {
    const auto count = of_client_.find(who);
    if (--count->second == 0) of_client_.erase(count);
  }
  by_op_.erase(found->second.op_id);
  by_serial_.erase(found);
}

}  // namespace selvage::server::store
