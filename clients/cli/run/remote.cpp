#include "clients/cli/run/remote.h"

#include <iostream>
#include <utility>

#include "clients/cli/terminal/files.h"
#include "protocol/json/fields.h"

namespace selvage::cli::run {
namespace {

client::Handlers rounds_to(RemoteMarker::OnRound on_round) {
  if (!on_round) return {};
  return {.notified = [tell = std::move(on_round)](std::string_view method, const Json& params) {
    if (method == "$/progress") tell(params.value("round", 0), params.value("length", 0.0));
  }};
}

}  // namespace

Refusal refusal_of(const Error& error) {
  return {protocol::json::describe(error) + " [" + std::string{wire_name(error.code)} + "]",
          terminal::exit_code_of(error)};
}

Refusal refusal_of(const client::CallError& error) {
  using client::CallCode;
  const std::string name = error.name();
  const std::string message = error.message + (name.empty() ? "" : " [" + name + "]");
  switch (error.code) {
    case CallCode::kInvalidParams:
    case CallCode::kUnknownMarker:
    case CallCode::kRevisionMismatch: return {message, terminal::ExitCode::kBadInput};
    case CallCode::kBadAddress: return {"--server: " + message, terminal::ExitCode::kBadUsage};
    case CallCode::kMotionRefused: return {message, terminal::ExitCode::kRefused};
    case CallCode::kCancelled: return {message, terminal::ExitCode::kCancelled};
    default: return {message, terminal::ExitCode::kServer};
  }
}

terminal::ExitCode fail(const Refusal& refusal) {
  std::cerr << "selvage: " << refusal.message << "\n";
  return refusal.code;
}

std::variant<std::unique_ptr<client::Client>, Refusal> reach(const ServerChoice& server, client::Handlers handlers) {
  client::Settings settings;
  settings.trusted = server.trusted;
  if (!server.token_file.empty()) {
    auto text = terminal::read_text(server.token_file);
    if (!text) return refusal_of(text.error());
    settings.token = text->substr(0, text->find_first_of("\r\n"));
  }
  auto client = std::make_unique<client::Client>(server.address, std::move(settings), std::move(handlers));
  // Little is asked first: a daemon whose token was not shown says so, but does not hear out a whole marker before.
  const client::Answer greeted = client->call("engine.info");
  if (!greeted) return refusal_of(greeted.error());
  return client;
}

RemoteMarker::~RemoteMarker() {
  if (!id_.empty()) (void)client_->call("marker.close", {{"markerId", id_}});
}

std::optional<Refusal> RemoteMarker::open(const ServerChoice& server, const MarkerFile& file, OnRound on_round) {
  auto reached = reach(server, rounds_to(std::move(on_round)));
  if (auto* refusal = std::get_if<Refusal>(&reached)) return std::move(*refusal);
  client_ = std::get<std::unique_ptr<client::Client>>(std::move(reached));
  auto document = protocol::formats::marker_document(file, Format::kNative);
  if (!document) return refusal_of(document.error());
  const client::Answer opened = client_->call("marker.open", {{"marker", *std::move(document)}});
  if (!opened) return refusal_of(opened.error());
  id_ = (*opened).value("markerId", "");
  return std::nullopt;
}

std::variant<Json, Refusal> RemoteMarker::call(std::string_view method, Json params, const std::stop_token& stop) {
  params["markerId"] = id_;
  client::Call call = client_->begin(method, std::move(params));
  const std::stop_callback on_stop{stop, [this, id = call.id] { client_->cancel(id); }};
  client::Answer answer = call.answer.get();
  if (!answer) return refusal_of(answer.error());
  return *answer;
}

std::variant<MarkerFile, Refusal> RemoteMarker::get(const MarkerFile& file) {
  auto got = call("marker.get", Json::object());
  if (auto* refusal = std::get_if<Refusal>(&got)) return std::move(*refusal);
  auto read = protocol::formats::read_document(std::get<Json>(got)["marker"]);
  if (!read) return refusal_of(read.error());
  read->format = file.format;
  return *std::move(read);
}

std::variant<std::string, Refusal> RemoteMarker::text(Format format) {
  auto got = call("marker.get", {{"format", name_of(format)}});
  if (auto* refusal = std::get_if<Refusal>(&got)) return std::move(*refusal);
  const Json& marker = std::get<Json>(got)["marker"];
  if (marker.is_string()) return marker.get<std::string>();
  return to_text(marker, protocol::json::Layout::kIndented) + "\n";
}

std::variant<std::string, Refusal> text_of(const MarkerFile& file, Format format, const ServerChoice& server) {
  if (!server) {
    auto text = protocol::formats::write_marker(file, format);
    if (!text) return refusal_of(text.error());
    return *std::move(text);
  }
  RemoteMarker remote;
  if (auto refusal = remote.open(server, file)) return *std::move(refusal);
  return remote.text(format);
}

}  // namespace selvage::cli::run
