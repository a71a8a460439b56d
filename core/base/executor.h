// Hands: how a caller lends the core more threads than the one it calls on.  The core itself starts none.
//
// A crew does the parts of one task, several at once.  Each part leaves what it finds in a place of its own, and what
// is found is put together in the order of the parts: the same bytes however many hands there are.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <vector>

namespace selvage {

class Executor {
 public:
  using Part = std::function<void(std::size_t)>;

  virtual ~Executor() = default;
  // How many parts it may do at once, whoever asks included; at least 1.
  [[nodiscard]] virtual std::size_t parallelism() const = 0;
  // Calls part(0), ..., part(count - 1), each once, in any order and several at once; returns when the last has ended.
  // What a part throws is thrown here, once the parts under way have ended; of several, what the first of them threw.
  virtual void for_each(std::size_t count, const Part& part) const = 0;
};

// The crew of one hand: the caller's thread, one part after another.
[[nodiscard]] const Executor& serial();

// What append(k, out) appends to `out` for k = 0, ..., count - 1, in this order.  So many in a row as `block` says are
// one part of the crew's.  REQUIRES: block > 0; append may be called for several k at once.
template <class Value, class Append>
[[nodiscard]] std::vector<Value> gathered(const Executor& executor, std::size_t count, std::size_t block,
                                          const Append& append) {
  std::vector<Value> all;
  const std::size_t parts = (count + block - 1) / block;
  if (executor.parallelism() == 1 || parts < 2) {
    for (std::size_t k = 0; k < count; ++k) append(k, all);
    return all;
  }
  std::vector<std::vector<Value>> found(parts);
  executor.for_each(parts, [&](std::size_t part) {
    std::vector<Value> own;  // beside no other thread's
    const std::size_t end = std::min(count, (part + 1) * block);
    for (std::size_t k = part * block; k < end; ++k) append(k, own);
    found[part] = std::move(own);
  });
  std::size_t size = 0;
  for (const auto& own : found) size += own.size();
  all.reserve(size);
  for (auto& own : found) all.insert(all.end(), std::move_iterator(own.begin()), std::move_iterator(own.end()));
  return all;
}

}  // namespace selvage
