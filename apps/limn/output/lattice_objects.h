#pragma once
/// What is said of each lattice of a scheme, in one JSON object.

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "limn/scheme/lattice_schemes.h"

namespace limn::app {

/// {"scheme", …} where there is one lattice; {"scheme", "lattices": [{"lattice", …}, …]} where
/// there are two.
class LatticeObjects {
 public:
  LatticeObjects(const std::string& name, bool several) : several_(several) {
    object_["scheme"] = name;
  }

  /// `found` of one of lattice_schemes; its own "scheme" is left out.
  void add(const Scheme& scheme, nlohmann::ordered_json found) {
    found.erase("scheme");
    if (!several_) return object_.update(found);
    nlohmann::ordered_json one{{"lattice", scheme::lattice_name(scheme.split->lattice)}};
    one.update(found);
    object_["lattices"].push_back(std::move(one));
  }
  [[nodiscard]] const nlohmann::ordered_json& object() const { return object_; }

 private:
  bool several_;
  nlohmann::ordered_json object_;
};

}  // namespace limn::app
