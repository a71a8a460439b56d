#include "protocol/execution/thread_pool.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace selvage::protocol::execution {
namespace {

// Waits until it is ready, for a short time at most.  Many tasks follow one another, with parts of less than a
// millisecond, and a thread that sleeps would take a good part of that to wake up.
template <class Ready>
void poll(const Ready& ready) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::microseconds kLongest{200};
  const Clock::time_point end = Clock::now() + kLongest;
  while (!ready() && Clock::now() < end) std::this_thread::yield();
}

}  // namespace

ThreadPool::ThreadPool(std::size_t helpers) : ThreadPool{helpers, [helpers] { return helpers; }} {}

ThreadPool::ThreadPool(std::size_t helpers, Spare spare) : helpers_{helpers}, spare_{std::move(spare)} {
  threads_.reserve(helpers);
  for (std::size_t i = 0; i < helpers; ++i) {
    threads_.emplace_back([this](const std::stop_token& end) { help(end); });
  }
}

ThreadPool::~ThreadPool() = default;

std::size_t ThreadPool::parallelism() const {
  return 1 + std::min(helpers_, spare_());
}

void ThreadPool::for_each(std::size_t count, const Part& part) const {
  if (count == 0) return;
  Task task{.part = part, .count = count};
  std::unique_lock lock{mutex_};
  open_.push_back(&task);
  opened_ = open_.size();
  if (count > 1) work_.notify_all();
  while (task.next < task.count) do_next(task, lock);
  if (task.under_way > 0) {
    lock.unlock();
    poll([&task] { return task.under_way == 0; });
    lock.lock();
  }
  task.ended.wait(lock, [&task] { return task.under_way == 0; });
  if (task.thrown) std::rethrow_exception(task.thrown);
}

void ThreadPool::close(const Task& task) const {
  std::erase(open_, &task);
  opened_ = open_.size();
}

void ThreadPool::do_next(Task& task, std::unique_lock<std::mutex>& lock) const {
  const std::size_t number = task.next++;
  ++task.under_way;
  if (task.next == task.count) close(task);
  lock.unlock();
  std::exception_ptr thrown;
  try {
    task.part(number);
  } catch (...) {
    thrown = std::current_exception();
  }
  lock.lock();
  if (thrown) {
    if (!task.thrown || number < task.thrower) {
      task.thrown = thrown;
      task.thrower = number;
    }
    close(task);
    task.next = task.count;  // the remaining parts are not needed any more
  }
  if (--task.under_way == 0) task.ended.notify_one();
}

void ThreadPool::help(const std::stop_token& end) {
  std::unique_lock lock{mutex_};
  while (work_.wait(lock, end, [this] { return !open_.empty() && helping_ < spare_(); })) {
    ++helping_;
    Task& task = *open_.front();
    open_.splice(open_.end(), open_, open_.begin());  // callers take turns
    do_next(task, lock);
    --helping_;
    if (open_.empty()) {
      lock.unlock();
      poll([this] { return opened_ > 0; });
      lock.lock();
    }
  }
}

}  // namespace selvage::protocol::execution
