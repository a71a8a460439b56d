#include "server/ops/log.h"

#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/dist_sink.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <memory>
#include <vector>

#include "protocol/json/json_text.h"

namespace selvage::server::ops {
namespace {

constexpr std::string_view kPattern = "%Y-%m-%dT%H:%M:%S.%e %l %v";

spdlog::sink_ptr sink_for(const std::string& file) {
  if (file.empty()) return std::make_shared<spdlog::sinks::stderr_sink_mt>();
  return std::make_shared<spdlog::sinks::basic_file_sink_mt>(file);
}

// A name from a client, made safe for one line of the log: quoted and shortened if it is not a plain word.
std::string plain(const std::string& name) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-";
  if (name.size() <= 40 && name.find_first_not_of(kPlain) == std::string::npos) return name.empty() ? "-" : name;
  return protocol::json::shortened(Json(name), 40);
}

}  // namespace

void set_up_log(std::string_view level, const std::string& file) {
  auto sinks = std::make_shared<spdlog::sinks::dist_sink_mt>();
  sinks->add_sink(sink_for(file));
  auto logger = std::make_shared<spdlog::logger>("selvaged", std::move(sinks));
  logger->set_pattern(std::string{kPattern});
  logger->set_level(spdlog::level::from_str(std::string{level}));
  logger->flush_on(spdlog::level::trace);  // so that the last line can be read while the daemon runs
  spdlog::set_default_logger(std::move(logger));
}

void reopen_log(const std::string& file) {
  if (file.empty()) return;
  const auto sinks = std::dynamic_pointer_cast<spdlog::sinks::dist_sink_mt>(spdlog::default_logger()->sinks().front());
  try {
    auto fresh = sink_for(file);
    fresh->set_pattern(std::string{kPattern});
    sinks->set_sinks({std::move(fresh)});
    spdlog::info("log reopened");
  } catch (const std::exception& error) {
    spdlog::error("the log cannot be reopened: {}", error.what());
  }
}

void log_request(const AnsweredRequest& request) {
  spdlog::info("{} {} {:.1f} ms {} {} B in {} B out", plain(request.method), plain(request.marker),
               request.milliseconds, request.code == 0 ? "ok" : "error " + std::to_string(request.code),
               request.bytes_in, request.bytes_out);
}

}  // namespace selvage::server::ops
