#include "clients/cli/run/remote_marker.h"

#include <utility>

#include "clients/cli/terminal/files.h"

namespace selvage::cli::run {
namespace {

client::Handlers progress_handlers(RemoteMarker::OnRound on_round) {
  if (!on_round) return {};
  return {.notified = [on_round = std::move(on_round)](std::string_view method, const client::Json& params) {
    if (method != "$/progress") return;
    terminal::ShownRound round{.number = params.value("round", 0), .length = params.value("length", 0.0)};
    if (params.contains("bound")) round.bound = params["bound"].get<double>();
    if (params.contains("nodes")) round.nodes = params["nodes"].get<std::uint64_t>();
    on_round(round);
  }};
}

}  // namespace

client::Json to_wire(const Json& value) {
  return client::Json::parse(protocol::json::to_text(value));
}

Json from_wire(const client::Json& value) {
  return Json::parse(value.dump());
}

terminal::Failure failure_of(const client::CallError& error) {
  using client::CallCode;
  const std::string message = terminal::with_name(error.message, error.name());
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

std::variant<std::unique_ptr<client::Client>, terminal::Failure> connect(const ServerChoice& server,
                                                                         client::Handlers handlers) {
  client::Settings settings;
  settings.trusted = server.trusted;
  if (!server.token_file.empty()) {
    auto text = terminal::read_text(server.token_file);
    if (!text) return terminal::failure_of(text.error());
    settings.token = text->substr(0, text->find_first_of("\r\n"));
  }
  auto client = std::make_unique<client::Client>(server.address, std::move(settings), std::move(handlers));
  // A short call is made first.  A daemon that rejects the token would close the connection while a long request, such
  // as a whole marker, is still being sent, and its error would be lost.
  const client::Answer answer = client->call("engine.info");
  if (!answer) {
    terminal::Failure failure = failure_of(answer.error());
    if (failure.code == terminal::ExitCode::kServer) failure.message.insert(0, server.address + ": ");
    return failure;
  }
  return client;
}

RemoteMarker::~RemoteMarker() {
  if (!id_.empty()) (void)client_->call("marker.close", {{"markerId", id_}});
}

std::optional<terminal::Failure> RemoteMarker::open(const ServerChoice& server, const MarkerFile& file,
                                                    OnRound on_round) {
  auto connected = connect(server, progress_handlers(std::move(on_round)));
  if (auto* failure = std::get_if<terminal::Failure>(&connected)) return std::move(*failure);
  client_ = std::get<std::unique_ptr<client::Client>>(std::move(connected));
  auto document = protocol::formats::marker_document(file, Format::kNative);
  if (!document) return terminal::failure_of(document.error());
  const client::Answer opened = client_->call("marker.open", {{"marker", to_wire(*document)}});
  if (!opened) return failure_of(opened.error());
  id_ = (*opened).value("markerId", "");
  return std::nullopt;
}

std::variant<Json, terminal::Failure> RemoteMarker::call(std::string_view method, Json params,
                                                         const std::stop_token& stop) {
  params["markerId"] = id_;
  client::Call call = client_->begin(method, to_wire(params));
  const std::stop_callback on_stop{stop, [this, id = call.id] { client_->cancel(id); }};
  client::Answer answer = call.answer.get();
  if (!answer) return failure_of(answer.error());
  return from_wire(*answer);
}

std::variant<MarkerFile, terminal::Failure> RemoteMarker::get(const MarkerFile& file) {
  auto got = call("marker.get", Json::object());
  if (auto* failure = std::get_if<terminal::Failure>(&got)) return std::move(*failure);
  auto read = protocol::formats::read_document(std::get<Json>(got)["marker"]);
  if (!read) return terminal::failure_of(read.error());
  read->format = file.format;
  return *std::move(read);
}

std::variant<std::string, terminal::Failure> RemoteMarker::text(std::string_view format) {
  auto got = call("marker.get", {{"format", format}});
  if (auto* failure = std::get_if<terminal::Failure>(&got)) return std::move(*failure);
  const Json& marker = std::get<Json>(got)["marker"];
  if (marker.is_string()) return marker.get<std::string>();
  return to_text(marker, protocol::json::Layout::kIndented) + "\n";
}

}  // namespace selvage::cli::run
