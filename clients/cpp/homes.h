// The instances of the daemon in which the ids of markers have their meaning.
//
// A daemon without a store gives the ids of markers to other markers when it is started again.  So the client remembers
// the instance that returned an id, or in which it was first used.  In another one it refuses the id until that returns
// it or the program vouches for it (learn).
#pragma once

#include <map>
#include <string>

#include "clients/cpp/answer.h"

namespace selvage::client {

class Homes {
 public:
  // From now on, calls go to this instance of the daemon.  Empty: the daemon does not tell it, so every id may be used.
  void move_to(std::string instance) { current_ = std::move(instance); }

  // Whether the marker may be used.  An id that is used for the first time has its meaning in the current instance.
  [[nodiscard]] bool may_use(const std::string& marker) {
    std::string& home = instances_[marker];
    if (home.empty()) home = current_;
    return current_.empty() || home == current_;
  }

  // The id was told in another way, such as by another client.
  void learn(const std::string& marker) { instances_[marker] = current_; }

  // The result of marker.open or marker.list, which tells ids: they have their meaning in the current instance.
  void learn_from(const Json& result) {
    if (!result.is_object()) return;
    learn_id(result);
    if (!result.contains("markers") || !result["markers"].is_array()) return;
    for (const Json& row : result["markers"]) learn_id(row);
  }

 private:
  void learn_id(const Json& named) {
    const bool has_id = named.is_object() && named.contains("markerId") && named["markerId"].is_string();
    if (has_id) learn(named["markerId"].get<std::string>());
  }

  std::string current_;
  std::map<std::string, std::string> instances_;  // by the marker's id
};

}  // namespace selvage::client
