#include "clients/cpp/answer.h"

namespace selvage::client {

std::string CallError::name() const {
  const bool named = details.is_object() && details.contains("name") && details["name"].is_string();
  return named ? details["name"].get<std::string>() : std::string{};
}

Answer answer_in(const Json& response) {
  if (response.contains("result")) return response["result"];
  CallError error{CallCode::kInternalError, "the daemon's answer holds neither a result nor an error", nullptr};
  const Json& said = response.contains("error") ? response["error"] : Json();
  if (!said.is_object()) return error;
  if (said.contains("code") && said["code"].is_number_integer()) {
    error.code = static_cast<CallCode>(said["code"].get<int>());
  }
  if (said.contains("message") && said["message"].is_string()) error.message = said["message"].get<std::string>();
  if (said.contains("data")) error.details = said["data"];
  return error;
}

}  // namespace selvage::client
