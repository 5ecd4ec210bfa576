# What every target of ours is compiled with. Nothing here depends on the machine that builds:
# the result runs on any processor of the architecture.

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE RelWithDebInfo CACHE STRING "Kind of build" FORCE)
endif()

# ccache, where it is: told that precompiled headers are ours, and to name files from here, so that
# what one clone compiled serves another.
find_program(LIMN_CCACHE ccache)
if(LIMN_CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros
      CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${LIMN_CCACHE})
endif()

# A linker that takes a sixth of the time, where it is; for development, not for what is installed.
find_program(LIMN_LLD ld.lld)
if(LIMN_LLD AND PROJECT_IS_TOP_LEVEL AND CMAKE_BUILD_TYPE STREQUAL Debug
   AND NOT LIMN_SANITIZE AND NOT LIMN_FUZZ)
  add_link_options(-fuse-ld=lld)
endif()

if(LIMN_LINT)
  # The hash of the checks in the command line has everything linted again when they change.
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/.clang-tidy)
  file(SHA1 ${PROJECT_SOURCE_DIR}/.clang-tidy checks)
  set(CMAKE_CXX_CLANG_TIDY ${LIMN_LINT} --quiet --extra-arg=-DLIMN_LINT_CHECKS=${checks})
endif()

# limn_precompile(TARGET [HEADER…]): it reads the standard headers that most sources include, and
# these HEADERs, compiled once. Not for clang-tidy, and not with clang, whose precompiled headers no
# cache keeps; there, and where each header is compiled by itself, a missing #include is seen.
option(LIMN_PRECOMPILE "Compile with precompiled headers (g++)" OFF)
function(limn_precompile target)
  if(NOT LIMN_PRECOMPILE OR LIMN_LINT OR NOT CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    return()
  endif()
  target_precompile_headers(${target} PRIVATE
    <algorithm> <array> <cmath> <complex> <functional> <limits> <map> <memory> <numeric> <optional>
    <random> <set> <span> <string> <string_view> <utility> <variant> <vector> ${ARGN})
  # Inlined from a precompiled header, the standard library is no system header to these any more.
  target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow)
  # g++ refuses a precompiled header that was made with other options.
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_source_file_property(options ${source} COMPILE_OPTIONS)
    if(options)
      set_source_files_properties(${source} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
    endif()
  endforeach()
endfunction()

# limn_optimise_less(TARGET): for what calls the library and prints: the headers of options and JSON
# take a quarter less time to compile so and make a third less code, and nothing waits for it.
function(limn_optimise_less target)
  if(CMAKE_BUILD_TYPE STREQUAL Release)
    target_compile_options(${target} PRIVATE -Os)
  endif()
endfunction()

set(LIMN_SANITIZERS -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
if(LIMN_SANITIZE STREQUAL thread)
  set(LIMN_SANITIZERS -fsanitize=thread -fno-omit-frame-pointer)
endif()
if(NOT LIMN_FUZZ)
  # Instrumented, code of std::regex looks to GCC 12 as though it read what was never written.
  list(APPEND LIMN_SANITIZERS -Wno-maybe-uninitialized)
  if(NOT LIMN_SANITIZE STREQUAL thread)
    # Instrumented, Eigen would align by itself, and free what other code (not instrumented, as
    # pagmo and the folders left out) had aligned by malloc, and the other way round.
    list(APPEND LIMN_SANITIZERS -DEIGEN_MALLOC_ALREADY_ALIGNED=1)
  endif()
endif()

# limn_flags(TARGET): C++20 without extensions, warnings, and the sanitizers that are on.
function(limn_flags target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  # Code that can also be linked into the Python module; hidden, so that it costs the others nothing.
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF
    POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wcast-qual -Woverloaded-virtual
    $<$<BOOL:${LIMN_WERROR}>:-Werror>)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # At -O3, GCC 12 gives these for std::string (its bug 105651) and for Boost's numbers.
    target_compile_options(${target} PRIVATE
      $<$<NOT:$<CONFIG:Debug>>:-Wno-restrict -Wno-maybe-uninitialized>)
  endif()
  if(LIMN_SANITIZE)
    if(NOT LIMN_SANITIZE_FOLDERS)
      target_compile_options(${target} PRIVATE ${LIMN_SANITIZERS})
    endif()
    target_link_options(${target} PRIVATE ${LIMN_SANITIZERS})
  endif()
  if(LIMN_FUZZ)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link ${LIMN_SANITIZERS})
    target_link_options(${target} PRIVATE -fsanitize=fuzzer-no-link ${LIMN_SANITIZERS})
  endif()
endfunction()

# limn_sanitize_folders(TARGET): where LIMN_SANITIZE_FOLDERS says which, its sources in these are
# compiled with the sanitizers. The others are what any other build makes, so that a cache has them.
# The thread sanitizer must see all that synchronises, and need not see tests, which run on one
# thread.
function(limn_sanitize_folders target)
  if(NOT LIMN_SANITIZE OR NOT LIMN_SANITIZE_FOLDERS)
    return()
  endif()
  list(JOIN LIMN_SANITIZE_FOLDERS "|" folders)
  get_target_property(sources ${target} SOURCES)
  set(trees "src/limn|tests")
  set(synchronises "")
  if(LIMN_SANITIZE STREQUAL thread)
    set(trees "src/limn")
  endif()
  foreach(source IN LISTS sources)
    if(LIMN_SANITIZE STREQUAL thread AND source MATCHES "/src/limn/")
      file(STRINGS ${source} synchronises REGEX "std::(atomic|mutex|thread|jthread|condition_variable|call_once)")
    endif()
    if(source MATCHES "/(${trees})/(${folders})/" OR synchronises
       OR (source MATCHES "/apps/" AND "command" IN_LIST LIMN_SANITIZE_FOLDERS))
      set_property(SOURCE ${source} APPEND PROPERTY COMPILE_OPTIONS ${LIMN_SANITIZERS})
    endif()
  endforeach()
endfunction()
