// The faults that a trial has found.
#pragma once

#include <cstdio>
#include <exception>
#include <mutex>
#include <string>
#include <string_view>

namespace selvage::trials {

class Faults {
 public:
  // May be called from any thread; the first faults are printed immediately.
  void add(const std::string& what) {
    const std::lock_guard lock{mutex_};
    if (++count_ <= kPrinted) std::fprintf(stderr, "FAULT: %s\n", what.substr(0, kLongest).c_str());
  }
  void expect(bool holds, const std::string& otherwise) {
    if (!holds) add(otherwise);
  }
  // Runs `work`; an exception is a fault.
  template <class Work>
  void guard(std::string_view who, const Work& work) {
    try {
      work();
    } catch (const std::exception& error) {
      add(std::string{who} + ": " + error.what());
    }
  }
  [[nodiscard]] std::size_t count() const {
    const std::lock_guard lock{mutex_};
    return count_;
  }

 private:
  static constexpr std::size_t kPrinted = 20, kLongest = 1000;
  mutable std::mutex mutex_;
  std::size_t count_{};
};

}  // namespace selvage::trials
