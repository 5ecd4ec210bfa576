#include "output/bundled_fonts.h"

#if defined(__linux__)
#include <sys/auxv.h>
#endif

#include <cstdlib>
#include <filesystem>
#include <system_error>

namespace limn::app {

void use_bundled_fonts() {
#if defined(__linux__)
  // As it was called; unlike /proc/self/exe it is there in a bare root too.
  const auto* const called = reinterpret_cast<const char*>(::getauxval(AT_EXECFN));
  if (called == nullptr) return;
  std::error_code failed;
  const std::filesystem::path program = std::filesystem::canonical(called, failed);
  if (failed) return;
  const std::filesystem::path fonts =
      program.parent_path().parent_path() / "share/limn/fonts/fonts.conf";
  if (std::filesystem::exists(fonts, failed)) ::setenv("FONTCONFIG_FILE", fonts.c_str(), 0);
#endif
}

}  // namespace limn::app
