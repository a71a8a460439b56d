// A thread pool: the threads that call for_each(), and pool threads that all callers share.
//
// A caller executes parts itself and waits only for parts that a pool thread has already started.  So it always makes
// progress, whatever other callers and the pool threads do.  Both poll for a moment before they sleep.  A pool thread
// takes a part only if a core is free for it, which is checked before every part.  Parts may call for_each() again.
#pragma once

#include <atomic>
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
  // How many pool threads may work now.  Called by several threads, while the pool is locked.
  using Spare = std::function<std::size_t()>;

  explicit ThreadPool(std::size_t helpers);  // all of them, always
  ThreadPool(std::size_t helpers, Spare spare);
  ~ThreadPool() override;  // REQUIRES: nobody calls for_each() any more
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  // How many pool threads may work now, and the function that says so.
  [[nodiscard]] std::size_t parallelism() const override;
  void for_each(std::size_t count, const Part& part) const override;

 private:
  // The parts of one call of for_each(), which owns it.
  struct Task {
    const Part& part;
    const std::size_t count;
    std::size_t next{};                    // the first that nobody has taken
    std::atomic<std::size_t> under_way{};  // taken, not ended
    std::exception_ptr thrown{};           // by the first part of those that threw
    std::size_t thrower{};                 // that part
    std::condition_variable ended{};       // no part is being executed
  };
  // No thread takes another part of the task.  REQUIRES: the lock is held.
  void close(const Task& task) const;
  // Takes the task's next part and does it.  REQUIRES: there is one; the lock is held, and is again afterwards.
  void do_next(Task& task, std::unique_lock<std::mutex>& lock) const;
  void help(const std::stop_token& end);

  const std::size_t helpers_;
  const Spare spare_;
  mutable std::mutex mutex_;
  mutable std::condition_variable_any work_;   // a task has been added
  mutable std::list<Task*> open_;              // the tasks with parts that nobody has taken
  mutable std::atomic<std::size_t> opened_{};  // how many these are
  std::size_t helping_{};
  std::vector<std::jthread> threads_;
};

}  // namespace selvage::protocol::execution
