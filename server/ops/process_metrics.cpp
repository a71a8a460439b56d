#include "server/ops/process_metrics.h"

#include <sys/resource.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>

namespace selvage::server::ops {
namespace {

using enum Metric::Type;

// The fields of /proc/self/stat (man 5 proc) from the third on, because the second, a name, may contain blanks.
struct Stat {
  double user_ticks{}, system_ticks{};  // fields 14 and 15
  double start_ticks{};                 // field 22: after the machine's start
  double virtual_bytes{};               // field 23
  double resident_pages{};              // field 24
};

std::optional<Stat> read_stat() {
  std::ifstream file{"/proc/self/stat"};
  std::string text{std::istreambuf_iterator<char>{file}, {}};
  const std::size_t end_of_name = text.rfind(')');
  if (end_of_name == std::string::npos) return std::nullopt;
  std::istringstream fields{text.substr(end_of_name + 1)};
  Stat stat;
  std::string skipped;
  const auto skip = [&](int count) {
    for (int k = 0; k < count; ++k) fields >> skipped;
  };
  skip(11);
  fields >> stat.user_ticks >> stat.system_ticks;
  skip(6);
  fields >> stat.start_ticks >> stat.virtual_bytes >> stat.resident_pages;
  return fields ? std::optional{stat} : std::nullopt;
}

// When the machine was started, in seconds since 1970.
std::optional<double> boot_time() {
  std::ifstream file{"/proc/stat"};
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("btime ")) return std::stod(line.substr(6));
  }
  return std::nullopt;
}

Metric single(std::string_view name, Metric::Type type, std::string_view help, double value) {
  return {name, type, help, "", {{"", value}}};
}

void add_descriptors(std::vector<Metric>& found) {
  std::error_code error;
  double open = 0;
  for (std::filesystem::directory_iterator at{"/proc/self/fd", error}, end; !error && at != end; at.increment(error)) {
    ++open;
  }
  if (!error)
    found.push_back(single("process_open_fds", kGauge, "Open file descriptors.", open - 1));  // one is our own
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  found.push_back(single("process_max_fds", kGauge, "Maximum number of open file descriptors.",
                         static_cast<double>(limit.rlim_cur)));
}

}  // namespace

std::vector<Metric> process_metrics() {
  std::vector<Metric> found;
  const double ticks = static_cast<double>(::sysconf(_SC_CLK_TCK));  // per second
  if (const auto stat = read_stat()) {
    found.push_back(single("process_cpu_seconds_total", kCounter, "Processor time of the process, user and system.",
                           (stat->user_ticks + stat->system_ticks) / ticks));
    found.push_back(single("process_resident_memory_bytes", kGauge, "Resident memory.",
                           stat->resident_pages * static_cast<double>(::sysconf(_SC_PAGESIZE))));
    found.push_back(single("process_virtual_memory_bytes", kGauge, "Virtual memory.", stat->virtual_bytes));
    if (const auto boot = boot_time()) {
      found.push_back(single("process_start_time_seconds", kGauge, "Start time of the process, in seconds since 1970.",
                             *boot + stat->start_ticks / ticks));
    }
  }
  add_descriptors(found);
  return found;
}

}  // namespace selvage::server::ops
