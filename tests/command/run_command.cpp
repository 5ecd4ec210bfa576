#include "run_command.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace limn::test {
namespace fs = std::filesystem;
namespace {

std::string content(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

}  // namespace

void Folder::write(const std::string& name, const std::string& text) const {
  std::ofstream(file(name), std::ios::binary) << text;
}

std::string Folder::read(const std::string& name) const { return content(file(name)); }

int Folder::count() const {
  return static_cast<int>(std::distance(fs::directory_iterator(path_), fs::directory_iterator()));
}

Outcome Folder::shell(const std::string& script) const {
  const Folder streams;
  const std::string line = "cd '" + path_ + "' && ( LIMN='" LIMN_COMMAND "'; " + script + "\n) >'" +
                           streams.file("out") + "' 2>'" + streams.file("err") + "' </dev/null";
  const int status = std::system(line.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), streams.read("out"),
          streams.read("err")};
}

Outcome Folder::limn(const std::string& arguments, const std::string& prefix) const {
  return shell(prefix + " \"$LIMN\" " + arguments);
}

void expect_refused(const Outcome& outcome, const std::vector<std::string>& parts) {
  EXPECT_EQ(outcome.code, 2) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err.substr(0, 6), "limn: ");
  for (const std::string& part : parts)
    EXPECT_NE(outcome.err.find(part), std::string::npos) << part << " not in: " << outcome.err;
}

}  // namespace limn::test
