#include "protocol/describe/openrpc.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "protocol/methods/method_table.h"
#include "protocol/schema/wire.h"

namespace selvage::protocol::describe {
namespace {

using schema::FieldDescription;
using Kind = schema::Type::Kind;

std::optional<Error> mistake_in(const calls::Method& method, const Json& params) {
  const auto read = method.read(params);
  return read ? std::nullopt : std::optional{read.error()};
}

// A value of the type that every decoder accepts.
Json sample(const schema::Type& type) {
  switch (type.kind) {
    case Kind::kPair: return Json::array({1, 2});
    case Kind::kEither: return sample(type.parts[0]);
    case Kind::kConstant: return type.text;
    case Kind::kBoolean: return true;
    case Kind::kString: return "x";
    case Kind::kObject:
      return Json::parse(R"({"format":"selvage-marker","version":1,"strip":{"width":9},
        "shapes":[{"id":"s","outline":[[0,0],[1,0],[1,1]]}],"pieces":[{"id":"a","shape":"s","at":[0,0]}]})");
    case Kind::kList:
      if (type.parts[0].kind == Kind::kNamed && type.parts[0].component().name == "Edit") {
        return Json::array({{{"op", "remove"}, {"piece", "a"}}});
      }
      return Json::array({sample(type.parts[0])});
    case Kind::kNamed: {
      const schema::Component& component = type.component();
      if (!component.words.empty()) return component.words[0];
      if (component.same_as) return sample(*component.same_as);
      Json object = Json::object();
      for (const FieldDescription& field : component.fields) object[std::string{field.name}] = sample(field.type);
      return object;
    }
    default: return 1;
  }
}

// The value of a parameter; a list has as many entries as it must have.
Json sample(const FieldDescription& param) {
  Json value = sample(param.type);
  while (param.limits.entries && value.size() < param.limits.entries->least) value.push_back(Json(value[0]));
  return value;
}

Json required_params(const calls::Method& method) {
  Json params = Json::object();
  for (const FieldDescription& param : method.params()) {
    if (param.required) params[std::string{param.name}] = sample(param);
  }
  if (method.name == "motion.openGap") params["point"] = Json::array({1, 2});  // or a region
  return params;
}

TEST(Descriptors, OfEveryMethodAreComplete) {
  for (const calls::Method& method : methods::method_table().all()) {
    EXPECT_FALSE(method.summary.empty()) << method.name << " has no summary";
    EXPECT_FALSE(method.results().empty()) << method.name;
    for (const auto& list : {method.params(), method.results()}) {
      std::set<std::string_view> names;
      for (const FieldDescription& field : list) {
        EXPECT_TRUE(names.insert(field.name).second) << method.name << " " << field.name;
        EXPECT_FALSE(field.meaning.empty()) << method.name << " " << field.name;
      }
    }
  }
}

TEST(Descriptors, RequiredParametersSufficeAndAreNamedWhenMissing) {
  for (const calls::Method& method : methods::method_table().all()) {
    const Json enough = required_params(method);
    const auto wrong = mistake_in(method, enough);
    EXPECT_FALSE(wrong) << method.name << " " << wrong->message << " " << wrong->field;
    for (const FieldDescription& param : method.params()) {
      if (!param.required) continue;
      Json params = enough;
      params.erase(std::string{param.name});
      const auto missing = mistake_in(method, params);
      ASSERT_TRUE(missing) << method.name << " " << param.name;
      EXPECT_EQ(missing->code, ErrorCode::kMissingField) << method.name << " " << param.name;
      EXPECT_EQ(missing->field, "/" + std::string{param.name}) << method.name;
    }
  }
}

TEST(Descriptors, EveryParameterIsReadAndChecked) {
  Json unknown = Json::object();
  unknown["nonsense"] = 1;
  for (const calls::Method& method : methods::method_table().all()) {
    if (method.name == "$/cancelRequest") continue;  // any id is accepted
    for (const FieldDescription& param : method.params()) {
      Json params = required_params(method);
      if (param.name == "region") params.erase("point");
      params[std::string{param.name}] = sample(param);
      const auto wrong = mistake_in(method, params);
      // Which of cloth's rules are allowed depends on the marker.
      const bool open = param.group == "cloth";
      EXPECT_TRUE(open || !wrong) << method.name << " " << param.name << " " << (wrong ? wrong->message : "");
      params[std::string{param.name}] = Json::array({unknown});
      const auto refused = mistake_in(method, params);
      ASSERT_TRUE(refused) << method.name << " " << param.name;
      EXPECT_EQ(refused->field.rfind("/" + std::string{param.name}, 0), 0U) << method.name << " " << refused->field;
    }
  }
}

TEST(Descriptors, UnknownParametersAreRefused) {
  std::set<std::string_view> names{"nonsense"};  // and all parameters of other methods
  for (const calls::Method& method : methods::method_table().all()) {
    for (const FieldDescription& param : method.params()) names.insert(param.name);
  }
  for (const calls::Method& method : methods::method_table().all()) {
    const auto own = method.params();
    for (const std::string_view name : names) {
      if (std::any_of(own.begin(), own.end(), [name](const auto& param) { return param.name == name; })) continue;
      Json params = required_params(method);
      params[std::string{name}] = 1;
      const auto refused = mistake_in(method, params);
      ASSERT_TRUE(refused) << method.name << " takes " << name << ", which its descriptor does not name";
      EXPECT_EQ(refused->code, ErrorCode::kUnknownField) << method.name << " " << name;
    }
  }
}

TEST(Descriptors, OnlyTheWordsOfAnEnumerationAreAllowed) {
  for (const calls::Method& method : methods::method_table().all()) {
    for (const FieldDescription& param : method.params()) {
      const auto words = schema::words_of(param.type);
      Json params = required_params(method);
      for (const std::string_view word : words) {
        params[std::string{param.name}] = word;
        if (param.group == "cloth") continue;  // which of them are allowed depends on the marker
        EXPECT_FALSE(mistake_in(method, params)) << method.name << " " << param.name << " " << word;
      }
      params[std::string{param.name}] = "nonsense";
      EXPECT_TRUE(words.empty() || mistake_in(method, params)) << method.name << " " << param.name;
    }
  }
}

// A law of the visitors: decoding an encoded message gives the same message.
TEST(Descriptors, EncodedParametersDecodeToTheSame) {
  for (const calls::Method& method : methods::method_table().all()) {
    if (!method.canonical) continue;
    const auto once = method.canonical(required_params(method));
    ASSERT_TRUE(once) << method.name << " " << once.error().message;
    EXPECT_EQ(*method.canonical(*once), *once) << method.name;
  }
}

TEST(Descriptors, DefaultsAreAllowedValues) {
  for (const calls::Method& method : methods::method_table().all()) {
    for (const FieldDescription& param : method.params()) {
      if (param.required || param.fallback.is_null()) continue;
      Json params = required_params(method);
      params[std::string{param.name}] = param.fallback;
      EXPECT_FALSE(mistake_in(method, params)) << method.name << " " << param.name;
    }
  }
}

void collect_references(const Json& schema, std::set<std::string>& found) {
  if (schema.is_object() && schema.contains("$ref")) found.insert(schema["$ref"].get<std::string>());
  for (const auto& [key, inside] : schema.items()) collect_references(inside, found);
  for (const Json& inside : schema) collect_references(inside, found);
}

TEST(OpenRpc, EveryReferenceLeadsSomewhereAndEveryTypeIsUsed) {
  const Json document = openrpc_document("1.2.3");
  EXPECT_EQ(document["openrpc"], "1.2.6");
  EXPECT_EQ(document["info"]["version"], "1.2.3");
  std::set<std::string> used;
  collect_references(document, used);
  std::set<std::string> there;
  for (const char* kind : {"schemas", "errors"}) {
    for (const auto& [name, component] : document["components"][kind].items()) {
      there.insert(std::string{"#/components/"} + kind + "/" + name);
    }
  }
  EXPECT_EQ(used, there);
}

const Json& named(const Json& list, std::string_view name) {
  for (const Json& entry : list) {
    if (entry["name"] == name) return entry;
  }
  throw std::runtime_error{"there is no " + std::string{name}};
}

TEST(OpenRpc, GivesLimitsDefaultsAndErrors) {
  const Json document = openrpc_document("1.2.3");
  const Json& nest = named(document["methods"], "marker.nest");
  const Json& searches = named(nest["params"], "searches")["schema"];
  EXPECT_EQ(searches["minimum"], 1);
  EXPECT_EQ(searches["maximum"], 64);
  EXPECT_FALSE(searches.contains("default"));
  EXPECT_EQ(named(nest["params"], "seed")["schema"]["default"], 1);
  const auto answers = [](const Json& method, const std::string& error) {
    const Json wanted{{"$ref", "#/components/errors/" + error}};
    return std::any_of(method["errors"].begin(), method["errors"].end(),
                       [&](const Json& one) { return one == wanted; });
  };
  EXPECT_TRUE(answers(nest, "MotionRefused"));
  EXPECT_TRUE(answers(nest, "RevisionMismatch"));
  EXPECT_FALSE(answers(named(document["methods"], "engine.info"), "UnknownMarker"));
  EXPECT_EQ(document["components"]["errors"]["Busy"]["code"], -32010);
  for (const char* name : {"marker.undo", "marker.redo", "marker.check", "marker.hold", "marker.regions", "library.add",
                           "marker.nestSheets", "plan.cut"}) {
    EXPECT_TRUE(answers(named(document["methods"], name), "MotionRefused")) << name;
  }
  EXPECT_FALSE(answers(named(document["methods"], "marker.apply"), "MotionRefused"));
  EXPECT_TRUE(answers(named(document["methods"], "drag.move"), "Superseded"));
  EXPECT_FALSE(answers(named(document["methods"], "drag.end"), "Superseded"));
  EXPECT_EQ(document["components"]["errors"]["Superseded"]["code"], -32802);
  EXPECT_TRUE(answers(named(document["methods"], "marker.list"), "Cancelled"));  // as part of a batch
}

TEST(OpenRpc, SaysThatLengthsAreCountedInBytes) {
  const Json document = openrpc_document("1.2.3");
  const Json& op_id = named(named(document["methods"], "marker.undo")["params"], "opId");
  EXPECT_EQ(op_id["schema"]["maxLength"], 128);
  EXPECT_NE(op_id["description"].text().find("bytes of UTF-8"), std::string::npos);
}

TEST(OpenRpc, TypesBecomeSchemas) {
  using schema::Type;
  using schema::Wire;
  EXPECT_EQ(json::to_text(type_schema(schema::either({{Kind::kNumber}, {Kind::kNull}}))),
            R"({"anyOf":[{"type":"number"},{"type":"null"}]})");
  EXPECT_EQ(json::to_text(type_schema({.kind = Kind::kConstant, .text = "add"})), R"({"const":"add"})");
  EXPECT_EQ(json::to_text(type_schema(Wire<std::vector<calls::Point>>::type())),
            R"({"type":"array","items":{"$ref":"#/components/schemas/Point"}})");
  EXPECT_EQ(type_schema(schema::pair_of({Kind::kNumber}))["maxItems"], 2);
}

}  // namespace
}  // namespace selvage::protocol::describe
