// Preloaded into a program, makes its monotonic clock the processor time of the process, so that a time limit is one of
// processor time and does not depend on what else the machine does.
//
// A thread that waits until some time of this clock waits as long as the process would need if it used one processor,
// and is woken up once or a few times too early.  Without that, the kernel would compare the time with its own clock,
// which is far ahead, and the thread would use up processor time by waiting again and again.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <pthread.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

static struct timespec now(clockid_t clock) {
  struct timespec time;
  syscall(SYS_clock_gettime, clock, &time);
  return time;
}

int clock_gettime(clockid_t clock, struct timespec* time) {
  return (int)syscall(SYS_clock_gettime, clock == CLOCK_MONOTONIC ? CLOCK_PROCESS_CPUTIME_ID : clock, time);
}

int pthread_cond_clockwait(pthread_cond_t* condition, pthread_mutex_t* mutex, clockid_t clock,
                           const struct timespec* until) {
  typedef int (*Wait)(pthread_cond_t*, pthread_mutex_t*, clockid_t, const struct timespec*);
  static Wait wait;
  if (!wait) wait = (Wait)dlsym(RTLD_NEXT, "pthread_cond_clockwait");
  if (clock != CLOCK_MONOTONIC) return wait(condition, mutex, clock, until);
  const struct timespec used = now(CLOCK_PROCESS_CPUTIME_ID);
  struct timespec end = now(CLOCK_MONOTONIC);
  const long long left = (until->tv_sec - used.tv_sec) * 1000000000LL + until->tv_nsec - used.tv_nsec;
  if (left > 0) {
    const long long nanoseconds = end.tv_nsec + left;
    end.tv_sec += nanoseconds / 1000000000;
    end.tv_nsec = nanoseconds % 1000000000;
  }
  return wait(condition, mutex, clock, &end);
}
