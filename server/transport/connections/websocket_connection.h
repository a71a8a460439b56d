// A WebSocket on a connection that came as HTTP: a JSON-RPC message per text message, both ways.
//
// The server pings; a client that neither sends nor answers pings is cut off, and so is a message that does not end in
// time.  Close codes: 1001 the server is going down; 1002, 1007 and 1009 for what breaks the protocol, is not UTF-8 or
// is longer than the limit; 1003 for a binary message.  No compression.  A client that closes stops its calls.
#pragma once

#include "server/transport/connections/connection.h"

#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>

namespace selvage::server::transport::connections {

// `upgrade`: the request that asked for it, already judged.
boost::asio::awaitable<void> serve_websocket(
    std::shared_ptr<Connection> connection, const ConnectionTerms& terms,
    const boost::beast::http::request<boost::beast::http::string_body>& upgrade);

}  // namespace selvage::server::transport::connections
