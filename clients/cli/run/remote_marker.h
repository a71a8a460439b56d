// A marker that this process has opened on a daemon; the destructor closes it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <variant>

#include "clients/cli/run/server_choice.h"
#include "clients/cli/terminal/failure.h"
#include "clients/cli/terminal/progress.h"
#include "clients/cpp/client.h"
#include "protocol/formats/format.h"

namespace selvage::cli::run {

// The client library has a JSON type of its own, since it shares no code with the engine.
[[nodiscard]] client::Json to_wire(const Json& value);
[[nodiscard]] Json from_wire(const client::Json& value);

// Makes a failure of an error that a daemon returned, or that prevented an answer.
[[nodiscard]] terminal::Failure failure_of(const client::CallError& error);

// Connects to the daemon and waits until it has answered a first call.
[[nodiscard]] std::variant<std::unique_ptr<client::Client>, terminal::Failure> connect(const ServerChoice& server,
                                                                                       client::Handlers handlers = {});

class RemoteMarker {
 public:
  using OnRound = std::function<void(const terminal::ShownRound&)>;  // called on another thread

  RemoteMarker() = default;
  ~RemoteMarker();
  RemoteMarker(const RemoteMarker&) = delete;
  RemoteMarker& operator=(const RemoteMarker&) = delete;

  // REQUIRES: called before all other functions.
  [[nodiscard]] std::optional<terminal::Failure> open(const ServerChoice& server, const MarkerFile& file,
                                                      OnRound on_round = {});
  // The call's result; a stop request cancels the call.  markerId is added to `params`.
  [[nodiscard]] std::variant<Json, terminal::Failure> call(std::string_view method, Json params,
                                                           const std::stop_token& stop = {});
  // The current state of the marker on the daemon, with the format of `file`.
  [[nodiscard]] std::variant<MarkerFile, terminal::Failure> get(const MarkerFile& file);
  // The text of the marker in any format, as write_marker would return it.
  [[nodiscard]] std::variant<std::string, terminal::Failure> text(std::string_view format);

 private:
  std::unique_ptr<client::Client> client_;
  std::string id_;
};

}  // namespace selvage::cli::run
