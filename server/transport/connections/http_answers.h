// Accepts or refuses an HTTP request by its header alone, and makes every answer that is not the result of a call.
//
// Pages of allowed origins may read the answers (CORS, https://fetch.spec.whatwg.org/#http-cors-protocol): a preflight,
// which has no token, is answered with status 204, and every answer to such a page names its origin.
#pragma once

#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>

#include <optional>
#include <string>
#include <string_view>

#include "server/transport/connections/connection.h"

namespace selvage::server::transport::connections {

using HttpRequest = boost::beast::http::request<boost::beast::http::string_body>;
using HttpResponse = boost::beast::http::response<boost::beast::http::string_body>;

// An answer after which the connection may be used for another request.
[[nodiscard]] HttpResponse make_answer(boost::beast::http::status status, std::string_view type, std::string body);
// An answer after which the connection is closed: the bytes after a refused request may not be another request.
[[nodiscard]] HttpResponse refuse(boost::beast::http::status status, std::string reason);

// The refusal of a request by its header; nothing if the request is accepted.  The body need not have been read.
[[nodiscard]] std::optional<HttpResponse> refusal_of(const HttpRequest& request, const ConnectionContext& context,
                                                     bool needs_token);
// The refusal of a header that could not be read; nothing if the connection has ended.
[[nodiscard]] std::optional<HttpResponse> refusal_of(boost::system::error_code error,
                                                     const access::TransportLimits& limits);

// REQUIRES for the rest: an accepted request.
// A request for an upgrade to a WebSocket.
[[nodiscard]] bool is_upgrade(const HttpRequest& request);
// The answer to a request for a page or a file, or to a preflight; nothing for a call.  The answer to HEAD contains the
// body of the answer to GET, which is not sent.
[[nodiscard]] std::optional<HttpResponse> page_for(const HttpRequest& request, const access::Service& service);

// Allows a page of an allowed origin to read this answer, whether or not the request was accepted.
void allow_origin(HttpResponse& answer, const HttpRequest& request, const access::Access& access);

}  // namespace selvage::server::transport::connections
