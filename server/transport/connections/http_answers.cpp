#include "server/transport/connections/http_answers.h"

#include <boost/beast/http.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include <algorithm>
#include <array>
#include <functional>

namespace selvage::server::transport::connections {
namespace {

namespace http = boost::beast::http;
using Error = boost::system::error_code;

std::string_view view(boost::beast::string_view text) {
  return {text.data(), text.size()};
}
boost::beast::string_view beast(std::string_view text) {
  return {text.data(), text.size()};
}

bool is_once(const HttpRequest& request, http::field field) {
  return request.count(field) == 1;
}

// The resources, and the methods that each allows.
struct Resource {
  std::string_view target;
  std::string_view methods;                               // besides OPTIONS
  std::function<std::string()> access::Service::*page{};  // the body of GET; null for the first two
  std::string_view type{};
  bool needs_token{true};  // health probes of containers have none
};
constexpr std::string_view kRpc = "/rpc";
constexpr std::string_view kWebSocket = "/ws";
constexpr std::string_view kReady = "/readyz";
constexpr std::array kResources{
    Resource{kRpc, "POST"},
    Resource{kWebSocket, "GET"},
    Resource{"/healthz", "GET, HEAD", &access::Service::health, "application/json", false},
    Resource{kReady, "GET, HEAD", &access::Service::ready, "text/plain", false},
    Resource{"/metrics", "GET, HEAD", &access::Service::metrics, "text/plain; version=0.0.4"},
    Resource{"/openrpc.json", "GET, HEAD", &access::Service::openrpc, "application/json"},
};

// Null if this service has no such resource.
const Resource* find_resource(const HttpRequest& request, const access::Service& service) {
  const std::string_view target = view(request.target());
  const auto* const found = std::find_if(kResources.begin(), kResources.end(), [&](const Resource& resource) {
    const bool served = resource.page != nullptr ? static_cast<bool>(service.*resource.page) : service.call != nullptr;
    return resource.target == target && served;
  });
  return found == kResources.end() ? nullptr : found;
}

bool allows(const Resource& resource, http::verb verb) {
  switch (verb) {
    case http::verb::options: return true;
    case http::verb::head: return resource.methods == "GET, HEAD";
    case http::verb::get: return resource.methods.starts_with("GET");
    case http::verb::post: return resource.methods == "POST";
    default: return false;
  }
}

// The file that a GET or HEAD request asks for, or null.
const access::StaticFile* find_file(const HttpRequest& request, const access::Service& service) {
  const bool reads = request.method() == http::verb::get || request.method() == http::verb::head;
  return service.file && reads ? service.file(view(request.target())) : nullptr;
}

HttpResponse file_answer(const access::StaticFile& file) {
  HttpResponse answer = make_answer(http::status::ok, file.type, std::string{file.gzip});
  answer.set(http::field::content_encoding, "gzip");
  answer.set(http::field::cache_control, file.forever ? "public, max-age=31536000, immutable" : "no-cache");
  answer.set("Referrer-Policy", "no-referrer");
  if (!file.policy.empty()) answer.set("Content-Security-Policy", beast(file.policy));
  return answer;
}

HttpResponse page_answer(const Resource& resource, const access::Service& service) {
  std::string body = (service.*resource.page)();
  if (resource.target != kReady) return make_answer(http::status::ok, resource.type, std::move(body));
  if (body.empty()) return make_answer(http::status::ok, resource.type, "ready\n");
  return make_answer(http::status::service_unavailable, resource.type, std::move(body) + "\n");
}

// The answer to OPTIONS: the allowed methods and, for a preflight, the headers that a page may send.
HttpResponse options_answer(const Resource& resource, const HttpRequest& request) {
  HttpResponse answer = make_answer(http::status::no_content, "text/plain", {});
  answer.erase(http::field::content_type);
  const std::string methods = std::string{resource.methods} + ", OPTIONS";
  answer.set(http::field::allow, methods);
  if (request.count(http::field::access_control_request_method) == 0) return answer;
  answer.set(http::field::access_control_allow_methods, methods);
  answer.set(http::field::access_control_allow_headers, "Authorization, Content-Type");
  answer.set(http::field::access_control_max_age, "600");
  // A public page may call a server in a private network (https://wicg.github.io/private-network-access).
  if (request["Access-Control-Request-Private-Network"] == "true") {
    answer.set("Access-Control-Allow-Private-Network", "true");
  }
  return answer;
}

bool has_token(const HttpRequest& request, const access::Access& access) {
  return is_once(request, http::field::authorization) &&
         authorization_matches(access, view(request[http::field::authorization]));
}

// Refuses hosts and origins of foreign sites, and requests without the token.
std::optional<HttpResponse> refusal_of_caller(const HttpRequest& request, const access::Access& access,
                                              bool needs_token) {
  if (!is_once(request, http::field::host) || !host_allowed(access, view(request[http::field::host]))) {
    return refuse(http::status::forbidden, "The Host header must name this machine.");
  }
  const auto origins = request.equal_range(http::field::origin);
  for (auto origin = origins.first; origin != origins.second; ++origin) {
    if (!origin_allowed(access, view(origin->value()), view(request[http::field::host]))) {
      return refuse(http::status::forbidden, "Pages of another origin may not call this server.");
    }
  }
  if (needs_token && !has_token(request, access)) {
    HttpResponse answer = refuse(http::status::unauthorized, "Send the token: Authorization: Bearer TOKEN.");
    answer.set(http::field::www_authenticate, "Bearer");
    return answer;
  }
  return std::nullopt;
}

// Refuses an upgrade that is not a correct WebSocket request.
std::optional<HttpResponse> refusal_of_upgrade(const HttpRequest& request) {
  if (!boost::beast::websocket::is_upgrade(request)) {
    HttpResponse answer = refuse(http::status::upgrade_required, "Ask for an upgrade to websocket.");
    answer.set(http::field::upgrade, "websocket");
    return answer;
  }
  if (request.count(http::field::content_length) != 0) {
    return refuse(http::status::bad_request, "An upgrade has no body.");
  }
  return std::nullopt;
}

// Whether a request needs no token.  Health probes have none, and browsers send none with a preflight.  A web page
// cannot add a header to its upgrade request either; then the first message on the WebSocket contains the token.
bool is_open(const Resource& resource, const HttpRequest& request) {
  if (!resource.needs_token || request.method() == http::verb::options) return true;
  return resource.target == kWebSocket && request.count(http::field::authorization) == 0;
}

}  // namespace

HttpResponse make_answer(http::status status, std::string_view type, std::string body) {
  HttpResponse answer{status, 11};
  answer.set(http::field::content_type, beast(type));
  answer.set(http::field::cache_control, "no-store");
  answer.set("X-Content-Type-Options", "nosniff");
  answer.body() = std::move(body);
  answer.keep_alive(true);
  return answer;
}

HttpResponse refuse(http::status status, std::string reason) {
  HttpResponse answer = make_answer(status, "text/plain", std::move(reason) + "\n");
  answer.keep_alive(false);
  return answer;
}

std::optional<HttpResponse> refusal_of(const HttpRequest& request, const ConnectionContext& context, bool needs_token) {
  const Resource* resource = find_resource(request, context.service);
  const bool is_file = resource == nullptr && find_file(request, context.service) != nullptr;
  const bool open = is_file || (resource != nullptr && is_open(*resource, request));
  if (auto refusal = refusal_of_caller(request, context.access, needs_token && !open)) return refusal;
  if (request.count(http::field::transfer_encoding) != 0) {
    return refuse(http::status::length_required, "Send the body with a Content-Length, not a Transfer-Encoding.");
  }
  if (is_file) return std::nullopt;
  if (resource == nullptr) {
    return refuse(http::status::not_found,
                  "The server has POST /rpc, and GET of /ws, /healthz, /readyz, /metrics and /openrpc.json.");
  }
  if (!allows(*resource, request.method())) {
    HttpResponse answer = refuse(http::status::method_not_allowed, "Use " + std::string{resource->methods} + ".");
    answer.set(http::field::allow, std::string{resource->methods} + ", OPTIONS");
    return answer;
  }
  if (request.method() == http::verb::options) return std::nullopt;
  if (resource->target == kRpc && !is_once(request, http::field::content_length)) {
    return refuse(http::status::length_required, "Send a Content-Length.");
  }
  return resource->target == kWebSocket ? refusal_of_upgrade(request) : std::nullopt;
}

std::optional<HttpResponse> refusal_of(Error error, const access::TransportLimits& limits) {
  if (error == http::error::header_limit || error == http::error::buffer_overflow) {
    return refuse(http::status::request_header_fields_too_large,
                  "The header is longer than " + std::to_string(limits.header_bytes) + " bytes.");
  }
  if (error == http::error::body_limit) {
    return refuse(http::status::payload_too_large,
                  "The body is longer than " + std::to_string(limits.body_bytes) + " bytes.");
  }
  if (error == http::error::end_of_stream || error == http::error::partial_message) return std::nullopt;
  if (error.category() == http::make_error_code(http::error::bad_method).category()) {
    return refuse(http::status::bad_request, "This is not HTTP: " + error.message() + ".");
  }
  return std::nullopt;  // the socket failed
}

bool is_upgrade(const HttpRequest& request) {
  return view(request.target()) == kWebSocket && request.method() == http::verb::get;
}

std::optional<HttpResponse> page_for(const HttpRequest& request, const access::Service& service) {
  const Resource* const resource = find_resource(request, service);
  if (resource == nullptr) return file_answer(*find_file(request, service));
  if (request.method() == http::verb::options) return options_answer(*resource, request);
  if (resource->page != nullptr) return page_answer(*resource, service);
  return std::nullopt;
}

void allow_origin(HttpResponse& answer, const HttpRequest& request, const access::Access& access) {
  if (!is_once(request, http::field::origin)) return;
  const auto origin = request[http::field::origin];
  if (!origin_allowed(access, view(origin), view(request[http::field::host]))) return;
  answer.set(http::field::access_control_allow_origin, origin);
  answer.set(http::field::vary, "Origin");
}

}  // namespace selvage::server::transport::connections
