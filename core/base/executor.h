// Executor: the interface through which a caller lends the core more threads than the calling one.  The core starts no
// threads itself.
//
// An executor runs the parts of one task, several at a time.  Each part writes only to its own storage, and the results
// are combined in the order of the parts.  Results are therefore identical to the byte for any number of threads.
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
  // The largest number of parts that run at the same time, including one on the calling thread; at least 1.
  [[nodiscard]] virtual std::size_t parallelism() const = 0;
  // Calls part(0), ..., part(count - 1), each exactly once, in any order and possibly concurrently.  Returns when all
  // have finished.
  // An exception thrown by a part is rethrown to the caller once the running parts have finished; if several parts
  // throw, the exception of the part that threw first is rethrown.
  virtual void for_each(std::size_t count, const Part& part) const = 0;
  // Called from time to time while a part works, on the thread of the part.  The core has no clock: an executor with a
  // limit on time reads it here, and requests a stop when the time is up.
  virtual void on_step() const {}
};

// Runs all parts in order on the calling thread.
[[nodiscard]] const Executor& serial();

// Returns everything that append(k, out) appends to `out` for k = 0, ..., count - 1, in that order.  The calls are
// divided into parts of `block` consecutive indices.
// REQUIRES: block > 0; append may be called concurrently for different k.
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
    std::vector<Value> own;  // local to the thread, which avoids false sharing
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
