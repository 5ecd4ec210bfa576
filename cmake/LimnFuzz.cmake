# Every fuzz/NAME_fuzz.cpp is a libFuzzer program NAME_fuzz (so it defines LLVMFuzzerTestOneInput).
# The ctest of that name runs it for LIMN_FUZZ_SECONDS from a fixed seed; what it learns stays in
# corpus/NAME below the build folder, and an input that breaks it is left in findings/ there.

set(LIMN_FUZZ_SECONDS 20 CACHE STRING "How long ctest runs each fuzzer")
if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  message(FATAL_ERROR "LIMN_FUZZ needs clang++ as the compiler: use the preset `fuzz`")
endif()

# Inputs to start from: mesh and scheme files of ours, and those that once broke something.
set(seed_folders "")
foreach(folder tests/data schemes examples)
  if(EXISTS ${PROJECT_SOURCE_DIR}/${folder})
    list(APPEND seed_folders ${PROJECT_SOURCE_DIR}/${folder})
  endif()
endforeach()
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/findings)

file(GLOB fuzz_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/fuzz/*_fuzz.cpp)
if(NOT fuzz_sources)
  message(STATUS "fuzz has no sources: no fuzzers are built")
endif()
foreach(source IN LISTS fuzz_sources)
  cmake_path(GET source STEM target)
  string(REGEX REPLACE "_fuzz$" "" name ${target})
  set(found_before ${PROJECT_SOURCE_DIR}/fuzz/corpus/${name})
  if(NOT EXISTS ${found_before})
    set(found_before "")
  endif()
  add_executable(${target} ${source})
  limn_flags(${target})
  target_link_libraries(${target} PRIVATE limn::limn)
  target_link_options(${target} PRIVATE -fsanitize=fuzzer)
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/corpus/${name})
  add_test(NAME fuzz:${name}
    COMMAND ${target}
      -seed=1 -max_total_time=${LIMN_FUZZ_SECONDS} -max_len=65536 -timeout=30 -rss_limit_mb=2048
      -print_final_stats=1 -artifact_prefix=${PROJECT_BINARY_DIR}/findings/${name}-
      ${PROJECT_BINARY_DIR}/corpus/${name} ${found_before} ${seed_folders})
  math(EXPR timeout "${LIMN_FUZZ_SECONDS} + 60")
  set_tests_properties(fuzz:${name} PROPERTIES TIMEOUT ${timeout} LABELS fuzz)
endforeach()
