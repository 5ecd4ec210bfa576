#pragma once
/// Reading JSON that must hold certain keys and no others. Private to certify/.

#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "limn/base/error.h"

namespace limn::certify {

using Json = nlohmann::ordered_json;

/// Reads one object, key by key; what is left over at its end is a fault.
class JsonReader {
 public:
  JsonReader(const Json& json, std::string place) : json_(json), place_(std::move(place)) {
    if (!json.is_object()) fail("an object is needed here");
  }
  [[nodiscard]] const std::optional<Error>& fault() const { return fault_; }

  void fail(const std::string& what) {
    if (!fault_) fault_ = Error{place_ + ": " + what};
  }
  void take(const std::optional<Error>& fault) {
    if (!fault_ && fault) fault_ = fault;
  }
  [[nodiscard]] bool has(const char* key) const { return json_.is_object() && json_.contains(key); }
  [[nodiscard]] std::string at(const char* key) const { return place_ + "/" + key; }

  const Json& get(const char* key) {
    static const Json none;
    read_.insert(key);
    if (has(key)) return json_.at(key);
    fail(fmt::format("'{}' is missing", key));
    return none;
  }
  std::string text(const char* key) {
    const Json& value = get(key);
    if (!value.is_string()) fail(fmt::format("'{}' is to be a text", key));
    return value.is_string() ? value.get<std::string>() : std::string();
  }
  double number(const char* key) { return number_of(get(key), key); }
  int whole(const char* key) { return whole_of(get(key), key); }
  std::vector<int> wholes(const char* key) {
    std::vector<int> result;
    for (const Json& one : list(key)) result.push_back(whole_of(one, key));
    return result;
  }
  std::vector<double> numbers(const char* key) {
    std::vector<double> result;
    for (const Json& one : list(key)) result.push_back(number_of(one, key));
    return result;
  }
  const Json& list(const char* key) {
    static const Json none = Json::array();
    const Json& value = get(key);
    if (!value.is_array()) fail(fmt::format("'{}' is to be a list", key));
    return value.is_array() ? value : none;
  }
  /// No more keys are known.
  void end(const std::set<std::string>& ignored = {}) {
    if (!json_.is_object()) return;
    for (const auto& [key, value] : json_.items())
      if (read_.count(key) == 0 && ignored.count(key) == 0)
        fail(fmt::format("unknown key '{}'", key));
  }

 private:
  int whole_of(const Json& value, const char* key) {
    const bool fits = value.is_number_integer() && std::abs(value.get<double>()) < 2e9;
    if (!fits) fail(fmt::format("'{}' is to be a whole number", key));
    return fits ? value.get<int>() : 0;
  }
  double number_of(const Json& value, const char* key) {
    if (!value.is_number()) fail(fmt::format("'{}' is to be a number", key));
    return value.is_number() ? value.get<double>() : 0;
  }

  const Json& json_;
  std::string place_;
  std::set<std::string> read_;
  std::optional<Error> fault_;
};

}  // namespace limn::certify
