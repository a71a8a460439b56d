#include "protocol/describe/openrpc.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>

#include "protocol/calls/codec.h"
#include "protocol/describe/daemon_methods.h"
#include "protocol/describe/schemas.h"
#include "protocol/edits/changes.h"
#include "protocol/methods/marker_methods.h"
#include "protocol/methods/readings/drag_messages.h"

namespace selvage::protocol::describe {
namespace {

using Reading = std::function<std::optional<Error>(const Json&)>;

template <class Value>
std::optional<Error> mistake_in(const Result<Value>& read) {
  return read ? std::nullopt : std::optional{read.error()};
}

struct Told {
  ToldMethod method;
  Reading read;  // the method's decoder
};

std::vector<Told> all_told() {
  std::vector<Told> all;
  for (const calls::MarkerMethod& method : methods::marker_methods()) {
    all.push_back({told(method), [&method](const Json& params) { return mistake_in(method.read(params)); }});
  }
  const std::map<std::string_view, Reading> decoders{
      {"engine.info", [](const Json& params) { return mistake_in(calls::decode_no_params(params)); }},
      {"rpc.discover", [](const Json& params) { return mistake_in(calls::decode_no_params(params)); }},
      {"marker.open", [](const Json& params) { return mistake_in(calls::decode_marker_open(params)); }},
      {"marker.list", [](const Json& params) { return mistake_in(calls::decode_no_params(params)); }},
      {"marker.close", [](const Json& params) { return mistake_in(calls::decode_marker_close(params)); }},
      {"marker.watch", [](const Json& params) { return mistake_in(calls::decode_marker_id(params)); }},
      {"marker.unwatch", [](const Json& params) { return mistake_in(calls::decode_marker_id(params)); }},
      {"marker.apply", [](const Json& params) { return mistake_in(edits::decode_marker_apply(params)); }},
      {"marker.undo", [](const Json& params) { return mistake_in(edits::decode_change(params)); }},
      {"marker.redo", [](const Json& params) { return mistake_in(edits::decode_change(params)); }},
      {"drag.begin", [](const Json& params) { return mistake_in(methods::readings::decode_drag_begin(params)); }},
      {"drag.move", [](const Json& params) { return mistake_in(methods::readings::decode_drag_move(params)); }},
      {"drag.end", [](const Json& params) { return mistake_in(methods::readings::decode_drag_end(params)); }}};
  for (const NamedWords& own : daemon_words()) {
    const auto decoder = decoders.find(own.name);
    if (decoder != decoders.end()) all.push_back({told(own.name, own.words), decoder->second});
  }
  EXPECT_EQ(all.size(),
            methods::marker_methods().size() + daemon_words().size() - 1);  // the dispatcher reads $/cancelRequest
  return all;
}

// A value of the type that every decoder takes, or one that is of another type.
Json sample(std::string_view type) {
  if (type.ends_with("[2]")) return Json::array({1, 2});
  if (type == "Force[]") return Json::array({{{"piece", "a"}, {"force", {1, 0}}}});
  if (type == "Edit[]") return Json::array({{{"op", "remove"}, {"piece", "a"}}});
  for (const ChoiceType& choice : choice_types()) {
    if (choice.name == type) return choice.words[0];
  }
  for (const NamedType& named : named_types()) {
    if (named.name == type) return sample(named.type.substr(0, named.type.find('|')));
  }
  if (type.starts_with('\'')) return type.substr(1, type.find('\'', 1) - 1);
  if (type == "boolean") return true;
  if (type == "string") return "x";
  if (type == "object") {
    return Json::parse(R"({"format":"selvage-marker","version":1,"strip":{"width":9},
        "shapes":[{"id":"s","outline":[[0,0],[1,0],[1,1]]}],"pieces":[{"id":"a","shape":"s","at":[0,0]}]})");
  }
  return 1;
}

Json required_params(const ToldMethod& method) {
  Json params = Json::object();
  for (const calls::Word& word : method.params) {
    if (word.required) params[std::string{word.name}] = sample(word.type);
  }
  if (method.name == "motion.openGap") params["point"] = Json::array({1, 2});  // or a region
  return params;
}

TEST(Words, AreToldOfEveryMethod) {
  for (const Told& each : all_told()) {
    EXPECT_FALSE(each.method.summary.empty()) << each.method.name << " has no words";
    EXPECT_TRUE(!each.method.results.empty()) << each.method.name;
    for (const auto* list : {&each.method.params, &each.method.results}) {
      std::set<std::string_view> names;
      for (const calls::Word& word : *list) {
        EXPECT_TRUE(names.insert(word.name).second) << each.method.name << " " << word.name;
        EXPECT_FALSE(word.meaning.empty()) << each.method.name << " " << word.name;
      }
    }
  }
}

TEST(Words, WhatIsRequiredIsEnoughAndNamedWhenItIsMissing) {
  for (const auto& [method, read] : all_told()) {
    const Json enough = required_params(method);
    const auto wrong = read(enough);
    EXPECT_FALSE(wrong) << method.name << " " << wrong->message << " " << wrong->field;
    for (const calls::Word& word : method.params) {
      if (!word.required) continue;
      Json params = enough;
      params.erase(std::string{word.name});
      const auto missing = read(params);
      ASSERT_TRUE(missing) << method.name << " " << word.name;
      EXPECT_EQ(missing->code, ErrorCode::kMissingField) << method.name << " " << word.name;
      EXPECT_EQ(missing->field, "/" + std::string{word.name}) << method.name;
    }
  }
}

TEST(Words, EveryParameterIsReadAndChecked) {
  for (const auto& [method, read] : all_told()) {
    for (const calls::Word& word : method.params) {
      Json params = required_params(method);
      if (word.name == "region") params.erase("point");
      params[std::string{word.name}] = sample(word.type);
      const auto wrong = read(params);
      EXPECT_FALSE(wrong) << method.name << " " << word.name << " " << wrong->message;
      params[std::string{word.name}] = Json::array({Json::object()});
      const auto refused = read(params);
      ASSERT_TRUE(refused) << method.name << " " << word.name;
      EXPECT_EQ(refused->field.rfind("/" + std::string{word.name}, 0), 0U) << method.name << " " << refused->field;
    }
  }
}

TEST(Words, WhatTheyDoNotNameIsRefused) {
  std::set<std::string_view> names{"nonsense"};  // and all that are words of other methods
  for (const Told& each : all_told()) {
    for (const calls::Word& word : each.method.params) names.insert(word.name);
  }
  for (const auto& [method, read] : all_told()) {
    for (const std::string_view name : names) {
      const auto is_it = [name](const calls::Word& word) { return word.name == name; };
      if (std::any_of(method.params.begin(), method.params.end(), is_it)) continue;
      Json params = required_params(method);
      params[std::string{name}] = 1;
      const auto refused = read(params);
      ASSERT_TRUE(refused) << method.name << " takes " << name << ", which its words do not tell";
      EXPECT_EQ(refused->code, ErrorCode::kUnknownField) << method.name << " " << name;
    }
  }
}

TEST(Words, AWordOfAChoiceIsAllowedAndNoOther) {
  for (const auto& [method, read] : all_told()) {
    for (const calls::Word& word : method.params) {
      for (const ChoiceType& choice : choice_types()) {
        if (choice.name != word.type) continue;
        Json params = required_params(method);
        for (const std::string_view each : choice.words) {
          params[std::string{word.name}] = each;
          EXPECT_FALSE(read(params)) << method.name << " " << word.name << " " << each;
        }
        params[std::string{word.name}] = "nonsense";
        EXPECT_TRUE(read(params)) << method.name << " " << word.name;
      }
    }
  }
}

void collect_references(const Json& schema, std::set<std::string>& found) {
  if (schema.is_object() && schema.contains("$ref")) found.insert(schema["$ref"].get<std::string>());
  if (!schema.is_structured()) return;
  for (const Json& inside : schema) collect_references(inside, found);
}

TEST(OpenRpc, EveryReferenceLeadsSomewhereAndEveryTypeIsUsed) {
  std::vector<ToldMethod> methods;
  for (const Told& each : all_told()) methods.push_back(each.method);
  const Json document = openrpc_document("1.2.3", methods);
  EXPECT_EQ(document["openrpc"], "1.2.6");
  EXPECT_EQ(document["info"]["version"], "1.2.3");
  std::set<std::string> used;
  collect_references(document, used);
  std::set<std::string> there;
  for (const auto& [name, schema] : document["components"]["schemas"].items()) {
    there.insert("#/components/schemas/" + name);
  }
  EXPECT_EQ(used, there);
}

TEST(OpenRpc, TypesBecomeSchemas) {
  EXPECT_EQ(json::to_text(type_schema("number|null")), R"({"anyOf":[{"type":"number"},{"type":"null"}]})");
  EXPECT_EQ(json::to_text(type_schema("'add'")), R"({"const":"add"})");
  EXPECT_EQ(json::to_text(type_schema("Point[]")), R"({"type":"array","items":{"$ref":"#/components/schemas/Point"}})");
  EXPECT_EQ(type_schema("number[2]")["maxItems"], 2);
}

}  // namespace
}  // namespace selvage::protocol::describe
