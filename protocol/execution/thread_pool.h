// A crew of threads: whoever calls each(), and helpers that all callers share.
//
// A caller does parts itself and waits for those only that a helper has under way: it always gets on, whoever else
// calls and however little the helpers do.  A helper takes a part only while there is a core free for it, asked before
// every part.  Parts may call each() again.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <list>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

#include "core/base/executor.h"

namespace selvage::protocol::execution {

class ThreadPool final : public Executor {
 public:
  // How many helpers may work now; called by several threads, and with the crew locked.
  using Spare = std::function<std::size_t()>;

  explicit ThreadPool(std::size_t helpers);  // all of them, always
  ThreadPool(std::size_t helpers, Spare spare);
  ~ThreadPool() override;  // REQUIRES: nobody calls each() any more
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  // The helpers that may work now, and who asks.
  [[nodiscard]] std::size_t parallelism() const override;
  void for_each(std::size_t count, const Part& part) const override;

 private:
  // Parts to be done; lives in each().
  struct Task {
    const Part& part;
    const std::size_t count;
    std::size_t next{};               // the first that nobody has taken
    std::size_t under_way{};          // taken, not ended
    std::exception_ptr thrown{};      // by the first part of those that threw
    std::size_t thrower{};            // that part
    std::condition_variable ended{};  // none is under way
  };
  // Takes the task's next part and does it.  REQUIRES: there is one; the lock is held, and is again afterwards.
  void do_next(Task& task, std::unique_lock<std::mutex>& lock) const;
  void help(const std::stop_token& end);

  const std::size_t helpers_;
  const Spare spare_;
  mutable std::mutex mutex_;
  mutable std::condition_variable_any work_;  // a task has come
  mutable std::list<Task*> open_;             // with parts that nobody has taken
  std::size_t helping_{};
  std::vector<std::jthread> threads_;
};

}  // namespace selvage::protocol::execution
