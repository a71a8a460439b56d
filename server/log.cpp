#include "server/log.h"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <memory>

#include "protocol/json_text.h"

namespace selvage {
namespace {

// A name that came over the wire, fit for one line of a log: quoted and cut when it is not a plain word.
std::string plain(const std::string& name) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-";
  if (name.size() <= 40 && name.find_first_not_of(kPlain) == std::string::npos) return name.empty() ? "-" : name;
  return shortened(Json(name), 40);
}

}  // namespace

void set_up_log(std::string_view level) {
  auto logger = std::make_shared<spdlog::logger>("selvaged", std::make_shared<spdlog::sinks::stderr_sink_mt>());
  logger->set_pattern("%Y-%m-%dT%H:%M:%S.%e %l %v");
  logger->set_level(spdlog::level::from_str(std::string{level}));
  spdlog::set_default_logger(std::move(logger));
}

void log_request(const AnsweredRequest& request) {
  spdlog::info("{} {} {:.1f} ms {} {} B in {} B out", plain(request.method), plain(request.marker),
               request.milliseconds, request.code == 0 ? "ok" : "error " + std::to_string(request.code),
               request.bytes_in, request.bytes_out);
}

}  // namespace selvage
