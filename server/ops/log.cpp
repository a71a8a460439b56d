#include "server/ops/log.h"

#include <fcntl.h>
#include <spdlog/sinks/sink.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <ctime>
#include <memory>
#include <system_error>
#include <utility>

#include "protocol/json/json_text.h"
#include "server/ops/log_writer.h"

namespace selvage::server::ops {
namespace {

using Time = std::chrono::system_clock::time_point;

std::shared_ptr<const OpenFile> open_file(const std::string& file) {
  const int descriptor = file.empty() ? ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 0)
                                      : ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (descriptor >= 0) return std::make_shared<OpenFile>(descriptor);
  throw std::system_error{errno, std::generic_category(), file.empty() ? "stderr" : "--log " + file};
}

// "2026-11-22T11:14:22.125Z"
std::string time_text(Time time) {
  const auto since = std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count();
  const std::time_t seconds = since / 1000;
  std::tm parts{};
  ::gmtime_r(&seconds, &parts);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", parts.tm_year + 1900, parts.tm_mon + 1,
                     parts.tm_mday, parts.tm_hour, parts.tm_min, parts.tm_sec, since % 1000);
}

std::string_view name_of(spdlog::level::level_enum level) {
  const auto name = spdlog::level::to_string_view(level);
  return {name.data(), name.size()};
}

// A name from a client, made safe for one line of the log: quoted and shortened if it is not a plain word.
std::string plain(const std::string& name) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-";
  if (name.size() <= 40 && name.find_first_not_of(kPlain) == std::string::npos) return name.empty() ? "-" : name;
  return protocol::json::shortened(Json(name), 40);
}

std::string line_text(LogFormat format, Time time, spdlog::level::level_enum level, std::string_view message,
                      Json::Parts more = {}) {
  if (format == LogFormat::kText) return fmt::format("{} {} {}", time_text(time), name_of(level), message);
  Json line{{"time", time_text(time)}, {"level", name_of(level)}, {"message", message}};
  line.update(Json::object(more));
  return protocol::json::to_text(line);
}

// The destination of spdlog's messages, and of log lines that have more fields than a message.
class QueueSink final : public spdlog::sinks::sink {
 public:
  QueueSink(const std::string& file, LogFormat format)
      : format_{format}, writer_{open_file(file), [format](std::uint64_t lines) {
                                   const std::string message = fmt::format(
                                       "{} lines are missing here: the log could not be written fast enough", lines);
                                   return line_text(format, std::chrono::system_clock::now(), spdlog::level::warn,
                                                    message, {{"dropped", lines}});
                                 }} {}

  void log(const spdlog::details::log_msg& message) override {
    writer_.add(line_text(format_, message.time, message.level, {message.payload.data(), message.payload.size()}));
  }
  void add(spdlog::level::level_enum level, std::string_view message, Json::Parts more) {
    writer_.add(line_text(format_, std::chrono::system_clock::now(), level, message, more));
  }
  void flush() override {}
  void set_pattern(const std::string&) override {}
  void set_formatter(std::unique_ptr<spdlog::formatter>) override {}

  [[nodiscard]] LogFormat format() const { return format_; }
  [[nodiscard]] LogWriter& writer() { return writer_; }

 private:
  const LogFormat format_;
  LogWriter writer_;
};

// Null if set_up_log has not been called, as in tests.
std::shared_ptr<QueueSink> queue() {
  return std::dynamic_pointer_cast<QueueSink>(spdlog::default_logger()->sinks().front());
}

// Lines of text have the values of `more` in their message.
void add_line(spdlog::level::level_enum level, std::string_view as_text, std::string_view as_json, Json::Parts more) {
  const auto sink = queue();
  if (sink && sink->format() == LogFormat::kJson) {
    sink->add(level, as_json, more);
  } else {
    spdlog::default_logger_raw()->log(level, as_text);
  }
}

}  // namespace

void set_up_log(const LogSettings& settings) {
  auto logger =
      std::make_shared<spdlog::logger>("selvaged", std::make_shared<QueueSink>(settings.file, settings.format));
  logger->set_level(spdlog::level::from_str(settings.level));
  spdlog::set_default_logger(std::move(logger));
}

void reopen_log(const std::string& file) {
  const auto sink = queue();
  if (file.empty() || !sink) return;
  try {
    auto fresh = open_file(file);
    sink->writer().flush(std::chrono::seconds{1});  // into the old file
    sink->writer().change_file(std::move(fresh));
    spdlog::info("log reopened");
  } catch (const std::exception& error) {
    spdlog::error("the log cannot be reopened: {}", error.what());
  }
}

void flush_log(std::chrono::milliseconds time) {
  if (const auto sink = queue()) sink->writer().flush(time);
}

std::uint64_t dropped_log_lines() {
  const auto sink = queue();
  return sink ? sink->writer().dropped() : 0;
}

void log_request(const AnsweredRequest& request) {
  if (!spdlog::should_log(spdlog::level::info)) return;
  const std::string outcome = request.code == 0 ? "ok" : "error " + std::to_string(request.code);
  const std::string peer = request.peer.empty() ? "-" : request.peer;
  const std::string id = request.request.empty() ? "-" : request.request;
  const std::string text = fmt::format("{} {} {:.1f} ms {} {} B in {} B out, {} session {} id {}",
                                       plain(request.method), plain(request.marker), request.milliseconds, outcome,
                                       request.bytes_in, request.bytes_out, peer, request.session, id);
  add_line(spdlog::level::info, text, "call",
           {{"method", request.method},
            {"marker", request.marker},
            {"ms", std::round(request.milliseconds * 1000) / 1000},
            {"code", request.code},
            {"peer", request.peer},
            {"session", request.session},
            {"request", request.request},
            {"bytesIn", request.bytes_in},
            {"bytesOut", request.bytes_out}});
}

void log_refusal(const RefusedCaller& refused) {
  const std::string text =
      fmt::format("refused {}: {}; {} more since the last such line", refused.peer, refused.reason, refused.withheld);
  add_line(spdlog::level::warn, text, "refused",
           {{"peer", refused.peer}, {"reason", refused.reason}, {"withheld", refused.withheld}});
}

}  // namespace selvage::server::ops
