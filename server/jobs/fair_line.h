// A line in which sessions take turns: what one of them has put in comes out in its order, but between two of its own
// everybody else who waits has one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <utility>

namespace selvage::server::jobs {

template <class Thing>
class FairLine {
 public:
  void push(std::uint64_t session, Thing thing) {
    const auto [own, first] = by_session_.try_emplace(session);
    own->second.push_back(std::move(thing));
    if (first) turns_.push_back(session);
    ++size_;
  }
  // The first thing that suits, of the first session in turn that has one; nothing when nobody has.
  template <class Suits>
  [[nodiscard]] std::optional<Thing> take(const Suits& suits) {
    for (auto turn = turns_.begin(); turn != turns_.end(); ++turn) {
      const std::uint64_t session = *turn;
      const auto own = by_session_.find(session);
      const auto found = std::find_if(own->second.begin(), own->second.end(), suits);
      if (found == own->second.end()) continue;
      std::optional<Thing> thing{std::move(*found)};
      own->second.erase(found);
      turns_.erase(turn);
      if (own->second.empty()) {
        by_session_.erase(own);
      } else {
        turns_.push_back(session);
      }
      --size_;
      return thing;
    }
    return std::nullopt;
  }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  std::map<std::uint64_t, std::deque<Thing>> by_session_;  // those with something in the line
  std::deque<std::uint64_t> turns_;                        // the same, in turn
  std::size_t size_{};
};

}  // namespace selvage::server::jobs
