// A line in which sessions take turns: what one of them has put in comes out in its order, but between two of its own
// everybody else who waits has one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <utility>

namespace selvage {

template <class Thing>
class FairLine {
 public:
  void push(std::uint64_t session, Thing thing) {
    const auto [own, first] = by_session_.try_emplace(session);
    own->second.push_back(std::move(thing));
    if (first) turns_.push_back(session);
    ++size_;
  }
  // REQUIRES: not empty.
  [[nodiscard]] Thing pop() {
    const std::uint64_t session = turns_.front();
    turns_.pop_front();
    const auto own = by_session_.find(session);
    Thing thing = std::move(own->second.front());
    own->second.pop_front();
    if (own->second.empty()) {
      by_session_.erase(own);
    } else {
      turns_.push_back(session);
    }
    --size_;
    return thing;
  }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  std::map<std::uint64_t, std::deque<Thing>> by_session_;  // those with something in the line
  std::deque<std::uint64_t> turns_;                        // the same, in turn
  std::size_t size_{};
};

}  // namespace selvage
