// selvaged: serves until a signal asks it to stop (SIGTERM, SIGINT), then drains; or answers the calls of a file.
// Exit codes: 0 drained, or every call of the file succeeded; 1 could not serve, did not drain in time, or a call
// failed; 2 bad command line or configuration; 78 the store is of a later version of the program.
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <future>
#include <iostream>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <variant>

#include "protocol/json/fields.h"
#include "server/app/addresses.h"
#include "server/app/daemon.h"
#include "server/app/options.h"
#include "server/app/replay.h"
#include "server/jobs/prompt_thread.h"
#include "server/ops/freed_memory.h"
#include "server/ops/log.h"
#include "server/ops/version.h"
#include "server/store/disk/copy.h"
#include "server/store/disk/schema.h"
#include "server/store/verification.h"

namespace selvage::server::app {
namespace {

// How long the end of the process waits for a log that nobody reads.
constexpr std::chrono::seconds kLogPatience{1};

// Blocks the signals in every thread, so that only wait_to_stop receives them.
sigset_t block_signals() {
  std::signal(SIGPIPE, SIG_IGN);
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) sigaddset(&signals, signal);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signals;
}

// Returns the signal that asks the process to stop.
int wait_to_stop(const sigset_t& signals, const Options& options, Daemon& daemon) {
  for (;;) {
    int signal{};
    if (sigwait(&signals, &signal) != 0) continue;
    if (signal != SIGHUP) return signal;
    ops::reopen_log(options.log.file);
    daemon.reload(options);
  }
}

std::string name_of(const transport::access::Listener& listener) {
  return listener.path.empty() ? address_text({listener.host, listener.port}) : listener.path;
}

// Writes the file in one step, so that a process that waits for it never reads half of it.
void write_ports(const std::string& path, const Daemon& daemon) {
  const std::string temporary = path + ".new";
  std::ofstream file{temporary};
  for (const transport::access::Listener& listener : daemon.listeners()) {
    if (listener.path.empty()) file << listener.port << '\n';
  }
  file.close();
  if (!file || std::rename(temporary.c_str(), path.c_str()) != 0) {
    throw std::runtime_error{"cannot write --port-file " + path};
  }
}

// Ends the process if it has not ended by itself in time, for example because a call does not stop.
class DrainWatchdog {
 public:
  explicit DrainWatchdog(std::chrono::seconds limit)
      : thread_{[this, limit](const std::stop_token& ended) {
          std::unique_lock lock{mutex_};
          if (wake_.wait_for(lock, ended, limit, [&ended] { return ended.stop_requested(); })) return;
          if (ended.stop_requested()) return;
          spdlog::error("not drained after {} s: exiting without the remaining answers", limit.count());
          ops::flush_log(kLogPatience);
          std::_Exit(1);
        }} {}

 private:
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::jthread thread_;
};

// Reports where the daemon listens as soon as it answers calls.  If it cannot, or the report cannot be written, asks
// the process to stop and throws the error.
void announce(const Options& options, Daemon& daemon) {
  try {
    if (!daemon.wait_until_loaded()) return;
    if (!options.port_file.empty()) write_ports(options.port_file, daemon);
    for (const transport::access::Listener& listener : daemon.listeners()) {
      std::cout << "listening on " << name_of(listener) << std::endl;
      spdlog::info("selvaged {} listening on {}, {} workers", ops::kVersion, name_of(listener), options.workers);
    }
  } catch (...) {
    ::kill(::getpid(), SIGTERM);
    throw;
  }
}

// REQUIRES: no thread that answers calls has been started.
void choose_priorities(const Options& options) {
  if (options.real_time == RealTime::kOff) return;
  const bool always = options.real_time == RealTime::kOn;
  const auto level = always ? spdlog::level::warn : spdlog::level::info;
  if (options.workers == 0) {
    spdlog::log(level, "no real-time priorities: with --workers 0 motions run on the I/O thread");
  } else if (jobs::use_real_time(always ? jobs::RealTime::kAlways : jobs::RealTime::kWhenLate)) {
    spdlog::info("real-time priorities for the threads that all clients wait for{}",
                 always ? "" : ", while any of them waits for a processor");
  } else {
    spdlog::log(level, "no real-time priorities: the system allows none, so quick calls may wait for a processor");
  }
}

int serve(const Options& options) {
  const sigset_t signals = block_signals();
  choose_priorities(options);
  Daemon daemon{options};
  // Runs while this thread waits for signals, so that a signal can end the loading.
  std::future<void> announced = std::async(std::launch::async, [&] { announce(options, daemon); });
  const int signal = wait_to_stop(signals, options, daemon);
  if (announced.wait_for(std::chrono::seconds{0}) == std::future_status::ready) announced.get();
  spdlog::info("draining: signal {}", signal);
  const DrainWatchdog watchdog{options.drain + std::chrono::seconds{1}};
  daemon.drain();
  if (announced.valid()) announced.get();
  spdlog::info("drained");
  return 0;
}

// Throws if the file cannot be written.  Creates and changes nothing.
void check_writable(const std::string& option, const std::string& path) {
  if (path.empty()) return;
  const std::string named = option + " " + path + ": ";
  const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
  if (!std::filesystem::is_directory(folder)) throw std::runtime_error{named + "there is no folder " + folder.string()};
  if (std::filesystem::is_directory(path)) throw std::runtime_error{named + "it is a folder"};
  const std::string written = std::filesystem::exists(path) ? path : folder.string();
  if (access(written.c_str(), W_OK) != 0) throw std::runtime_error{named + "it cannot be written"};
}

int check_config(const Options& options) {
  check_writable("--store", options.store);
  check_writable("--log", options.log.file);
  check_writable("--port-file", options.port_file);
  const transport::Transport without_listeners{
      {.access = options.access, .tls = options.tls}, options.limits.transport, {}};
  std::cout << "the configuration is valid\n";
  return 0;
}

std::string text_of_file(const std::string& path) {
  std::ifstream file{path};
  if (!file) throw std::runtime_error{"cannot read " + path};
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

template <class Value>
Value or_throw(Result<Value> result, const std::string& about) {
  if (!result) throw std::runtime_error{about + ": " + protocol::json::describe(result.error())};
  return *std::move(result);
}

int replay_file(const Options& options) {
  Daemon daemon{options};
  daemon.wait_until_loaded();
  const Replay replayed = or_throw(replay(daemon, text_of_file(options.replay_file)), options.replay_file);
  for (const std::string& answer : replayed.answers) std::cout << answer << '\n';
  if (!options.replay_svg.empty()) {
    std::ofstream file{options.replay_svg};
    file << or_throw(draw_last_marker(daemon), "--svg");
    file.close();
    if (!file) throw std::runtime_error{"cannot write " + options.replay_svg};
  }
  return replayed.succeeded ? 0 : 1;
}

int verify_store(const std::string& path) {
  const store::Verification found = store::verify_store(path);
  for (const std::string& damage : found.damage) std::cout << "damaged: " << damage << '\n';
  std::cout << path << ": " << found.markers << " markers are sound, " << found.damage.size() << " faults\n";
  return found.damage.empty() ? 0 : 1;
}

int back_up(const Options& options) {
  const std::uint64_t bytes =
      store::disk::copy_store(options.store, options.backup_file, store::disk::Existing::kRefuse);
  std::cout << options.backup_file << ": " << bytes << " bytes\n";
  return verify_store(options.backup_file);
}

int run(const Options& options) {
  // A check creates no file, not even a log.
  ops::LogSettings log = options.log;
  if (options.task == Options::Task::kCheckConfig) log.file.clear();
  if (options.task == Options::Task::kServe) ops::bound_freed_memory();
  ops::set_up_log(log);
  switch (options.task) {
    case Options::Task::kServe: return serve(options);
    case Options::Task::kCheckConfig: return check_config(options);
    case Options::Task::kReplay: return replay_file(options);
    case Options::Task::kVerifyStore: return verify_store(options.store);
    case Options::Task::kBackUp: return back_up(options);
  }
  return 2;
}

}  // namespace
}  // namespace selvage::server::app

int main(int argc, char** argv) {
  const auto parsed = selvage::server::app::parse_options(argc, argv);
  if (const auto* exit = std::get_if<selvage::server::app::EarlyExit>(&parsed)) {
    (exit->code == 0 ? std::cout : std::cerr) << exit->text;
    return exit->code;
  }
  const auto& options = std::get<selvage::server::app::Options>(parsed);
  try {
    const int code = selvage::server::app::run(options);
    selvage::server::ops::flush_log(selvage::server::app::kLogPatience);
    return code;
  } catch (const selvage::server::store::disk::NewerStore& error) {
    selvage::server::ops::flush_log(selvage::server::app::kLogPatience);
    std::cerr << "selvaged: " << error.what() << "\n";
    return 78;  // EX_CONFIG: starting it again does not help
  } catch (const std::exception& error) {
    selvage::server::ops::flush_log(selvage::server::app::kLogPatience);
    std::cerr << "selvaged: " << error.what() << "\n";
    return options.task == selvage::server::app::Options::Task::kCheckConfig ? 2 : 1;
  }
}
