// A queue that serves sessions round-robin.  Elements of one session come out in the order in which they were pushed;
// between two of them, every other session that has an element gets a turn.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace selvage::server::jobs {

template <class Element>
class FairQueue {
 public:
  void push(std::uint64_t session, Element element) {
    const auto [own, first] = by_session_.try_emplace(session);
    own->second.push_back(std::move(element));
    if (first) turns_.push_back(session);
    ++size_;
  }
  // Takes the first acceptable element of the next session that has one.  Returns nothing if no session has one.
  template <class Accepts>
  [[nodiscard]] std::optional<Element> take(const Accepts& accepts) {
    for (auto turn = turns_.begin(); turn != turns_.end(); ++turn) {
      const std::uint64_t session = *turn;
      const auto own = by_session_.find(session);
      const auto found = std::find_if(own->second.begin(), own->second.end(), accepts);
      if (found == own->second.end()) continue;
      std::optional<Element> element{std::move(*found)};
      own->second.erase(found);
      turns_.erase(turn);
      if (own->second.empty()) {
        by_session_.erase(own);
      } else {
        turns_.push_back(session);
      }
      --size_;
      return element;
    }
    return std::nullopt;
  }
  // Takes all elements that `leaves` accepts.
  template <class Leaves>
  [[nodiscard]] std::vector<Element> take_all(const Leaves& leaves) {
    std::vector<Element> taken;
    for (auto own = by_session_.begin(); own != by_session_.end();) {
      std::deque<Element> stay;
      for (Element& element : own->second) {
        if (leaves(element)) {
          taken.push_back(std::move(element));
        } else {
          stay.push_back(std::move(element));
        }
      }
      own->second = std::move(stay);
      if (own->second.empty()) {
        std::erase(turns_, own->first);
        own = by_session_.erase(own);
      } else {
        ++own;
      }
    }
    size_ -= taken.size();
    return taken;
  }
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (const auto& [session, own] : by_session_) {
      for (const Element& element : own) visit(element);
    }
  }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  std::map<std::uint64_t, std::deque<Element>> by_session_;  // sessions that have at least one element
  std::deque<std::uint64_t> turns_;                          // the same sessions, in turn
  std::size_t size_{};
};

}  // namespace selvage::server::jobs
