// One message in progress: its calls, which are executed one at a time, and the answers so far.
//
// Only the thread that executes the current call uses the exchange; it passes it to the thread of the next call.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/rpc/json_rpc.h"
#include "server/calls/open_calls.h"
#include "server/calls/outcome.h"
#include "server/jobs/deadline_clock.h"
#include "server/jobs/reply_once.h"
#include "server/ops/freed_memory.h"
#include "server/ops/log.h"
#include "server/transport/access/service.h"

namespace selvage::server::dispatch {

struct Exchange {
  using Clock = std::chrono::steady_clock;

  ops::FreedMemory freed;  // first, so that it is destroyed last
  protocol::rpc::Incoming incoming;
  std::size_t bytes{};  // of the message
  std::shared_ptr<transport::access::Session> session;
  jobs::ReplyOnce<std::string> reply;
  const ops::OnAnswered& on_answered;
  jobs::DeadlineClock::Time arrived{};
  Clock::time_point began{Clock::now()};
  std::size_t calls_done{};
  bool continue_on_worker{};       // the current call was answered on a thread that must not execute the next one
  bool only_read{};                // the current call changed nothing, so it can be sent again
  std::string marker_id{};         // the marker that the current call is about; empty: none or unknown
  std::vector<std::string> ids{};  // of the calls, where they are numbers that no double holds (verbatim_ids.h)
  std::vector<std::shared_ptr<calls::ListedCall>> listed{};  // of each call, until its turn; null if it has no id
  std::vector<std::string> answers{};
  memory::HeldBytes held{session->account};  // of the answers

  // Adds the answer to the current call, unless that is a notification, and reports it.  A large answer for which there
  // is no room is replaced by an error if the call can be sent again.
  void add_answer(const protocol::rpc::Request& request, calls::Outcome outcome);
  // Of the current call; null if it has no id.
  [[nodiscard]] std::shared_ptr<calls::ListedCall> take_listed() { return std::move(listed[calls_done - 1]); }
  void add_refusal(const protocol::rpc::BadRequest& bad);
  // Whether the batch's answers have become so large that its remaining calls must be refused.
  [[nodiscard]] bool is_full(std::size_t most_bytes) const;
  // There is always room for a small answer.
  [[nodiscard]] bool has_room_for(std::size_t answer_bytes) const;
  // All answers as one text; empty if every call was a notification.
  [[nodiscard]] std::string text();
};

[[nodiscard]] protocol::rpc::RpcError no_room_for_answer(std::size_t limit);
// The answer to a message whose calls are all refused with this error; empty if every call was a notification.
[[nodiscard]] std::string refusal_text(std::string_view message, std::size_t most_bytes,
                                       const std::shared_ptr<transport::access::Session>& session,
                                       const protocol::rpc::RpcError& error, const ops::OnAnswered& on_answered);
// The text of an error that answers a whole message.
[[nodiscard]] std::string error_text(const protocol::rpc::RpcError& error);

}  // namespace selvage::server::dispatch
