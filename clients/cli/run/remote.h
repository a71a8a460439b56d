// A daemon as commands use it: one marker opened there, called upon, and closed again.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <variant>

#include "clients/cli/run/server_option.h"
#include "clients/cli/terminal/exit_code.h"
#include "clients/cpp/client.h"
#include "protocol/formats/format.h"

namespace selvage::cli::run {

// Why a command cannot go on, as it is told on stderr.
struct Refusal {
  std::string message;
  terminal::ExitCode code{};
};
// Of an error of this process.
[[nodiscard]] Refusal refusal_of(const Error& error);
// Of an error that a daemon answered with, or that kept it from answering.
[[nodiscard]] Refusal refusal_of(const client::CallError& error);
[[nodiscard]] terminal::ExitCode fail(const Refusal& refusal);  // tells it

// A client of the daemon, which has answered once.
[[nodiscard]] std::variant<std::unique_ptr<client::Client>, Refusal> reach(const ServerChoice& server,
                                                                           client::Handlers handlers = {});

class RemoteMarker {
 public:
  using OnRound = std::function<void(int round, double length)>;  // called on another thread

  RemoteMarker() = default;
  ~RemoteMarker();  // closes the marker
  RemoteMarker(const RemoteMarker&) = delete;
  RemoteMarker& operator=(const RemoteMarker&) = delete;

  // Called first.
  [[nodiscard]] std::optional<Refusal> open(const ServerChoice& server, const MarkerFile& file, OnRound on_round = {});
  // The call's result.  A stop request cancels it.  `params`: markerId is filled in.
  [[nodiscard]] std::variant<Json, Refusal> call(std::string_view method, Json params,
                                                 const std::stop_token& stop = {});
  // The marker as it is now there; beside what it says, `file` is what was opened.
  [[nodiscard]] std::variant<MarkerFile, Refusal> get(const MarkerFile& file);
  // Its text in any form, as write_marker gives it.
  [[nodiscard]] std::variant<std::string, Refusal> text(Format format);

 private:
  std::unique_ptr<client::Client> client_;
  std::string id_;
};

// The text of a marker in any form, written here or by a daemon.
[[nodiscard]] std::variant<std::string, Refusal> text_of(const MarkerFile& file, Format format,
                                                         const ServerChoice& server);

}  // namespace selvage::cli::run
