/// libFuzzer target: the input is several scheme files, parted by lines "---", which may extend one
/// another as "0.toml", "1.toml", …, or shipped schemes. Nothing may crash or take long, and a
/// refusal has a place in the first file.
///
///     ./scheme_chain_fuzz -max_len=8192 -timeout=10 CORPUS

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "limn/scheme/file/scheme_files.h"

namespace {

void check(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\n", what);
  std::abort();
}

std::vector<std::string> files_of(const std::string& text) {
  const std::string mark = "\n---\n";
  std::vector<std::string> files;
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find(mark, begin);
    files.push_back(text.substr(begin, end == text.npos ? end : end - begin + 1));
    if (end == text.npos) return files;
    begin = end + mark.size();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<std::string> files =
      files_of(std::string(reinterpret_cast<const char*>(data), size));
  const auto load = [&](const std::string& name,
                        const std::string&) -> limn::Result<limn::SchemeText> {
    for (std::size_t i = 0; i < files.size(); ++i)
      if (const std::string path = std::to_string(i) + ".toml"; name == path)
        return limn::SchemeText{files[i], path, path};
    // in a folder that is not there, so that only shipped schemes are found
    return limn::load_scheme_text(name, "/no-such-folder/fuzz.toml");
  };
  const limn::Result<limn::Scheme> scheme = limn::parse_scheme(files.front(), "0.toml", load);
  if (scheme) {
    check(scheme->split != nullptr, "a scheme has a split");
    return 0;
  }
  const limn::Error& error = scheme.error();
  check(!error.message.empty(), "an error has a message");
  check(error.file == "0.toml", "the fault is in the first file, or in what it extends");
  for (const char c : error.text())
    check(static_cast<unsigned char>(c) >= ' ' || c == '\n', "a message is lines of text");
  return 0;
}
