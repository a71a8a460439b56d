// A WebSocket on a connection that began as HTTP: one JSON-RPC message per text message, in both directions.
//
// The server sends pings and disconnects a client that neither sends messages nor answers pings, or whose message does
// not end in time.  Close codes: 1001 the server is shutting down; 1002 a protocol error; 1003 a binary message; 1007
// invalid UTF-8; 1009 a message longer than the limit.  No compression.  When a client closes, its calls are stopped.
#pragma once

#include "server/transport/connections/connection.h"

#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>

namespace selvage::server::transport::connections {

// `upgrade`: the request for the upgrade, which has been checked.
boost::asio::awaitable<void> serve_websocket(
    std::shared_ptr<Connection> connection, const ConnectionContext& context,
    const boost::beast::http::request<boost::beast::http::string_body>& upgrade);

}  // namespace selvage::server::transport::connections
