// JSON-RPC calls to a daemon on this machine.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "protocol/json/json_text.h"
#include "server/app/options.h"
#include "tests/server/dispatch/stub_methods.h"
#include "tests/server/wire/wire.h"
#include "tests/support/repository.h"

namespace selvage::test {

inline server::app::Options on_free_port(std::size_t workers) {
  server::app::Options options;
  options.port = 0;
  options.workers = workers;
  return options;
}

// The answer's bytes; empty if there is none.
inline std::string post_call(Wire& wire, const std::string& method, const std::string& params = "{}") {
  return wire.post(call(1, method, params)).value_or(HttpAnswer{}).body;
}
// The answer's result.  If it is an error, null and a test failure.
inline Json result_of(const std::string& answer) {
  Json parsed = answer.empty() ? Json() : Json::parse(answer);
  if (!parsed.contains("result")) {
    ADD_FAILURE() << (answer.empty() ? "no answer" : answer);
    return nullptr;
  }
  return parsed["result"];
}
inline int code_of(const std::string& answer) {
  const Json parsed = answer.empty() ? Json() : Json::parse(answer);
  return parsed.contains("error") ? parsed["error"]["code"].get<int>() : 0;
}

inline std::string file_text(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream{path}.rdbuf();
  return text.str();
}
inline std::string garment(const std::string& name) {
  return garment_text(name);
}

inline std::string open_params(const std::string& document) {
  return R"({"marker":)" + document + "}";
}
inline std::string id_params(const std::string& id, const std::string& more = "") {
  return R"({"markerId":")" + id + "\"" + more + "}";
}
// Opens a marker and returns its id.
inline std::string open_marker(Wire& wire, const std::string& document) {
  const Json opened = result_of(post_call(wire, "marker.open", open_params(document)));
  return opened.is_null() ? std::string{} : opened["markerId"].get<std::string>();
}

}  // namespace selvage::test
