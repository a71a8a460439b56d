// What the server does with a call whose parameters have been decoded.
#pragma once

#include <functional>
#include <memory>
#include <string_view>

#include "protocol/calls/parsed_call.h"
#include "server/calls/open_call.h"
#include "server/calls/outcome.h"
#include "server/methods/context.h"

namespace selvage::server::methods {

// Answers the call, now or later; at most once.
using Handler = std::function<void(protocol::calls::ParsedCall parsed, const ServerContext& server,
                                   const std::shared_ptr<calls::OpenCall>& call)>;

// How a method that changes no open marker uses the store's file, for which it may have to wait.
enum class FileUse { kNone, kWrites, kCopies };

struct HandledMethod {
  std::string_view name;
  Handler handle;
  FileUse file_use{};
};

// The handler that consists of one function of the method's own parameters:
// Outcome run(Params&, const ServerContext&, OpenCall&).
template <class Params, auto run>
void handle_with(protocol::calls::ParsedCall parsed, const ServerContext& server,
                 const std::shared_ptr<calls::OpenCall>& call) {
  Params params = parsed.take_params<Params>();
  call->answer(run(params, server, *call));
}

}  // namespace selvage::server::methods
