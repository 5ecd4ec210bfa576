# The command `limn`: bin/limn below the build folder; and the three papers made anew, which it
# and the tests use.

file(GLOB papers_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/apps/papers/*.cpp)
if(NOT LIMN_FUZZ)
  add_library(limn_papers STATIC ${papers_sources})
  limn_flags(limn_papers)
  limn_sanitize_folders(limn_papers)
  target_include_directories(limn_papers PUBLIC ${PROJECT_SOURCE_DIR}/apps)
  target_link_libraries(limn_papers PUBLIC limn::limn fmt::fmt nlohmann_json::nlohmann_json)
  limn_optimise_less(limn_papers)
  limn_precompile(limn_papers <fmt/core.h> <nlohmann/json.hpp>)
  limn_unite(limn_papers ${PROJECT_SOURCE_DIR}/apps)
endif()

file(GLOB command_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/apps/limn/*.cpp
  ${PROJECT_SOURCE_DIR}/apps/limn/options/*.cpp ${PROJECT_SOURCE_DIR}/apps/limn/output/*.cpp)
if(LIMN_FUZZ)
  # Only the library and the fuzzers.
elseif(command_sources)
  add_executable(limn_command ${command_sources} ${limn_page_file})
  target_include_directories(limn_command PRIVATE ${PROJECT_SOURCE_DIR}/apps/limn)
  limn_flags(limn_command)
  limn_sanitize_folders(limn_command)
  set_target_properties(limn_command PROPERTIES OUTPUT_NAME limn)
  target_compile_definitions(limn_command PRIVATE LIMN_VERSION="${PROJECT_VERSION}")
  target_link_libraries(limn_command PRIVATE
    limn_papers CLI11::CLI11 FastFloat::fast_float fmt::fmt nlohmann_json::nlohmann_json)
  limn_optimise_less(limn_command)
  # Names of functions are for debuggers: RelWithDebInfo and Debug have them.
  target_link_options(limn_command PRIVATE $<$<CONFIG:Release>:LINKER:--gc-sections,--strip-all>)
  limn_precompile(limn_command <CLI/CLI.hpp> <fmt/core.h> <nlohmann/json.hpp>)
  limn_unite(limn_command ${PROJECT_SOURCE_DIR}/apps/limn)
else()
  message(STATUS "apps/limn has no sources: the command is not built")
endif()
