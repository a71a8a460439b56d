// More threads than processors, all of them busy.
#pragma once

#include <atomic>
#include <thread>
#include <vector>

namespace selvage::test {

// They end with this object.
class Crowd {
 public:
  Crowd() {
    const unsigned threads = std::thread::hardware_concurrency() + 1;
    for (unsigned k = 0; k < threads; ++k) {
      busy_.emplace_back([this] {
        while (!ended_) continue;
      });
    }
  }
  ~Crowd() { ended_ = true; }
  Crowd(const Crowd&) = delete;
  Crowd& operator=(const Crowd&) = delete;

 private:
  std::atomic<bool> ended_{};
  std::vector<std::jthread> busy_;
};

}  // namespace selvage::test
