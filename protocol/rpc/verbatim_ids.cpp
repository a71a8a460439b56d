#include "protocol/rpc/verbatim_ids.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <variant>

#include "protocol/rpc/json_rpc.h"

namespace selvage::protocol::rpc {
namespace {

const Json* id_of(const Call& call) {
  if (const auto* request = std::get_if<Request>(&call)) return request->id ? &*request->id : nullptr;
  return &std::get<BadRequest>(call).id;
}

// Follows the parser's events and keeps the texts of the numbers that are ids of calls.
class IdReader {
 public:
  using Library = nlohmann::json;
  using number_integer_t = Library::number_integer_t;
  using number_unsigned_t = Library::number_unsigned_t;
  using number_float_t = Library::number_float_t;
  using string_t = Library::string_t;
  using binary_t = Library::binary_t;

  IdReader(bool batch, std::size_t calls) : call_depth_{batch ? 2 : 1}, ids_(calls) {}

  bool null() { return value(); }
  bool boolean(bool) { return value(); }
  bool number_integer(number_integer_t) { return value(); }
  bool number_unsigned(number_unsigned_t) { return value(); }
  bool number_float(number_float_t, const string_t& text) {
    if (is_id_ && depth_ == call_depth_ && call_ < ids_.size()) ids_[call_] = text;
    return value();
  }
  bool string(string_t&) { return value(); }
  bool binary(binary_t&) { return value(); }
  bool start_object(std::size_t) { return open(); }
  bool start_array(std::size_t) { return open(); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  bool key(const string_t& name) {
    is_id_ = depth_ == call_depth_ && name == "id";
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) { return false; }

  [[nodiscard]] std::vector<std::string> take() && { return std::move(ids_); }

 private:
  // A value has ended; one of the batch's own values is a call.
  bool value() {
    is_id_ = false;
    if (depth_ == call_depth_ - 1) ++call_;
    return true;
  }
  bool open() {
    ++depth_;
    is_id_ = false;
    return true;
  }
  bool close() {
    --depth_;
    return value();
  }

  const int call_depth_;
  std::vector<std::string> ids_;
  int depth_{};
  std::size_t call_{};
  bool is_id_{};  // the next value is an id
};

}  // namespace

bool has_inexact_ids(const Incoming& incoming) {
  return std::any_of(incoming.calls.begin(), incoming.calls.end(), [](const Call& call) {
    const Json* id = id_of(call);
    return id != nullptr && id->kind() == Json::Kind::kDecimal;
  });
}

std::vector<std::string> verbatim_ids(std::string_view text, const Incoming& incoming) {
  IdReader reader{incoming.batch, incoming.calls.size()};
  nlohmann::json::sax_parse(text, &reader);
  return std::move(reader).take();
}

}  // namespace selvage::protocol::rpc
