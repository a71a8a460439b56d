#include "clients/cpp/answer.h"

namespace selvage::client {

std::string CallError::name() const {
  const bool named = details.is_object() && details.contains("name") && details["name"].is_string();
  return named ? details["name"].get<std::string>() : std::string{};
}

Answer answer_in(const Json& response) {
  if (response.contains("result")) return response["result"];
  CallError error{CallCode::kInternalError, "the daemon's answer contains neither a result nor an error", nullptr};
  const Json& reported = response.contains("error") ? response["error"] : Json();
  if (!reported.is_object()) return error;
  if (reported.contains("code") && reported["code"].is_number_integer()) {
    error.code = static_cast<CallCode>(reported["code"].get<int>());
  }
  if (reported.contains("message") && reported["message"].is_string())
    error.message = reported["message"].get<std::string>();
  if (reported.contains("data")) error.details = reported["data"];
  return error;
}

}  // namespace selvage::client
