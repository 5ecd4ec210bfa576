#pragma once
/// What the built command prints with --json.

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

namespace limn::test {

inline nlohmann::json command_json(const std::string& arguments) {
  const std::string line = std::string(LIMN_COMMAND) + " " + arguments + " --json 2>/dev/null";
  std::FILE* const pipe = popen(line.c_str(), "r");
  if (pipe == nullptr) return {};
  std::string text;
  std::array<char, 65536> piece{};
  for (std::size_t n = 0; (n = std::fread(piece.data(), 1, piece.size(), pipe)) > 0;)
    text.append(piece.data(), n);
  pclose(pipe);
  return nlohmann::json::parse(text, nullptr, false);
}

}  // namespace limn::test
