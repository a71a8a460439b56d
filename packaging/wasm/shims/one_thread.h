// Included before every source: what the libc++ 16 of WebAssembly lacks.  It has no threads, so a mutex locks nothing;
// and it compares vectors with < only.
#pragma once

#include <compare>
#include <cstddef>
#include <vector>

namespace std {

struct mutex {
  void lock() {}
  void unlock() {}
};
template <class Mutex>
struct lock_guard {
  explicit lock_guard(Mutex&) {}
};
template <class Mutex>
lock_guard(Mutex&) -> lock_guard<Mutex>;
template <class Mutex>
struct scoped_lock {
  explicit scoped_lock(Mutex&) {}
};
template <class Mutex>
scoped_lock(Mutex&) -> scoped_lock<Mutex>;

struct defer_lock_t {};
inline constexpr defer_lock_t defer_lock{};
template <class Mutex>
struct unique_lock {
  explicit unique_lock(Mutex&) {}
  unique_lock(Mutex&, defer_lock_t) {}
  void lock() {}
  void unlock() {}
};
template <class Mutex>
unique_lock(Mutex&) -> unique_lock<Mutex>;

template <class T, class Allocator>
constexpr auto operator<=>(const vector<T, Allocator>& a, const vector<T, Allocator>& b)
    -> decltype(a.front() <=> b.front()) {
  for (size_t k = 0; k < a.size() && k < b.size(); ++k) {
    if (const auto order = a[k] <=> b[k]; order != 0) return order;
  }
  return a.size() <=> b.size();
}

}  // namespace std
