# Every folder below tests/ that holds a *_test.cpp becomes one program, of all its sources:
# tests/mesh → limn_test_mesh, tests/mesh/io → limn_test_mesh_io. Every suite in it is a ctest of
# its own, called FOLDER:Suite; one test of it runs by --gtest_filter=Suite.Name of the program.
# A new file or folder needs no edit here.
# Sources in tests/support, if any, are linked to all of them.

find_package(GTest REQUIRED)
find_package(rapidcheck REQUIRED)
include(LimnDocuments)  # tests of what documents say

add_library(limn_test_support INTERFACE)
# One set of precompiled headers serves all test programs.
set(nothing ${PROJECT_BINARY_DIR}/generated/nothing.cpp)
file(CONFIGURE OUTPUT ${nothing} CONTENT "")
add_library(limn_test_precompiled OBJECT ${nothing})
limn_flags(limn_test_precompiled)
target_link_libraries(limn_test_precompiled PRIVATE
  limn::limn GTest::gtest rapidcheck rapidcheck_gtest)
limn_precompile(limn_test_precompiled <gtest/gtest.h> <rapidcheck/gtest.h>)
function(limn_reuse_precompiled target)
  get_target_property(precompiled limn_test_precompiled PRECOMPILE_HEADERS)
  if(precompiled)
    target_precompile_headers(${target} REUSE_FROM limn_test_precompiled)
    target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow)
  endif()
endfunction()
file(GLOB support_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/support/*.cpp)
if(support_sources)
  add_library(limn_test_support_sources STATIC ${support_sources})
  limn_flags(limn_test_support_sources)
  target_link_libraries(limn_test_support_sources PRIVATE limn_test_support)
  limn_reuse_precompiled(limn_test_support_sources)
  target_link_libraries(limn_test_support INTERFACE $<LINK_ONLY:limn_test_support_sources>)
endif()
target_include_directories(limn_test_support INTERFACE ${PROJECT_SOURCE_DIR}/tests)
target_link_libraries(limn_test_support INTERFACE
  limn::limn fmt::fmt nlohmann_json::nlohmann_json
  GTest::gtest GTest::gtest_main rapidcheck rapidcheck_gtest)

if(LIMN_SANITIZE)
  target_compile_definitions(limn_test_support INTERFACE LIMN_SANITIZED)
endif()

file(GLOB_RECURSE test_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/*_test.cpp)
set(test_folders ${test_sources})
list(TRANSFORM test_folders REPLACE "/[^/]*$" "")
list(REMOVE_DUPLICATES test_folders)

# limn_discover_tests(TARGET PREFIX LABEL): each suite in it is a ctest PREFIX:Suite. Sanitizers
# make programs up to ten times as slow, which must not end a test.
function(limn_discover_tests target prefix label)
  set(seconds 900)
  if(LIMN_SANITIZE)
    set(seconds 6000)
  endif()
  set(suites ${PROJECT_BINARY_DIR}/tests/${target})
  file(GENERATE OUTPUT ${suites}.cmake CONTENT
"set(PROGRAM \"$<TARGET_FILE:${target}>\")
set(PREFIX ${prefix})
set(LABEL ${label})
set(SECONDS ${seconds})
set(LIST \"${suites}.txt\")
include(\"${PROJECT_SOURCE_DIR}/cmake/AddSuites.cmake\")
")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${suites}.cmake)
endfunction()

foreach(folder IN LISTS test_folders)
  cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR}/tests OUTPUT_VARIABLE name)
  if(name MATCHES "^consumer" OR (name MATCHES "^peers" AND NOT LIMN_PEERS))
    continue()
  endif()
  string(REGEX REPLACE "/.*" "" folder_of_source ${name})
  if(LIMN_SANITIZE_FOLDERS AND NOT folder_of_source IN_LIST LIMN_SANITIZE_FOLDERS)
    continue()
  endif()
  string(REPLACE "/" "_" target limn_test_${name})
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  add_executable(${target} ${sources})
  limn_flags(${target})
  limn_sanitize_folders(${target})
  # The macros of GoogleTest provoke these: EXPECT_… after a bare `if`, a lambda's `info`.
  target_compile_options(${target} PRIVATE -Wno-dangling-else -Wno-shadow)
  target_link_libraries(${target} PRIVATE limn_test_support)
  limn_reuse_precompiled(${target})
  if(name MATCHES "^peers")
    include(LimnPeers)
    target_link_libraries(${target} PRIVATE
      limn_peer_cgal limn_peer_openmesh limn_peer_opensubdiv)
  endif()
  # Only where files of the tree are read: whoever compiles elsewhere then finds the rest in ccache.
  if(name MATCHES "^(mesh/io|peers|scheme|command|page)")
    target_compile_definitions(${target} PRIVATE
      LIMN_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data"
      LIMN_SCHEMES="${PROJECT_SOURCE_DIR}/schemes"
      LIMN_EXAMPLES="${PROJECT_SOURCE_DIR}/examples")
  endif()
  if(name MATCHES "^page")
    target_link_libraries(${target} PRIVATE limn_page_core)
  endif()
  if(name MATCHES "^(apps|command|page)" AND TARGET limn_command)
    target_compile_definitions(${target} PRIVATE LIMN_COMMAND="$<TARGET_FILE:limn_command>")
    add_dependencies(${target} limn_command)
  endif()
  limn_discover_tests(${target} ${name} ${name})
endforeach()

# The fast engine without vector instructions: its sources and tests once more, with one lane.
if(NOT LIMN_SANITIZE_FOLDERS)
  file(GLOB_RECURSE one_lane_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/limn/fast/*.cpp
       ${PROJECT_SOURCE_DIR}/tests/fast/*_test.cpp)
  add_executable(limn_test_fast_one_lane ${one_lane_sources})
  limn_flags(limn_test_fast_one_lane)
  target_compile_definitions(limn_test_fast_one_lane PRIVATE LIMN_ONE_LANE)
  target_compile_options(limn_test_fast_one_lane PRIVATE -Wno-dangling-else -Wno-shadow)
  target_link_libraries(limn_test_fast_one_lane PRIVATE limn_test_support)
  limn_reuse_precompiled(limn_test_fast_one_lane)
  limn_unite(limn_test_fast_one_lane ${PROJECT_SOURCE_DIR}/src)
  limn_discover_tests(limn_test_fast_one_lane fast_one_lane fast)
endif()

# All headers of the library in one source, the public ones and the others: no two have names that clash.
if(PROJECT_IS_TOP_LEVEL AND NOT LIMN_SANITIZE)
  file(GLOB_RECURSE all_headers RELATIVE ${PROJECT_SOURCE_DIR}/src CONFIGURE_DEPENDS
    ${PROJECT_SOURCE_DIR}/src/limn/*.h)
  list(TRANSFORM all_headers REPLACE "(.+)" "#include \"\\1\"")
  list(JOIN all_headers "\n" all_headers)
  set(together ${PROJECT_BINARY_DIR}/tests/headers_together.cpp)
  file(GENERATE OUTPUT ${together} CONTENT "${all_headers}\n")
  add_library(limn_headers_together OBJECT ${together})
  limn_flags(limn_headers_together)
  target_include_directories(limn_headers_together PRIVATE $<TARGET_PROPERTY:limn,INCLUDE_DIRECTORIES>)
  target_compile_definitions(limn_headers_together PRIVATE $<TARGET_PROPERTY:limn,COMPILE_DEFINITIONS>)
endif()

# Somebody else's project that finds an installed limn; sanitizers would have to be theirs too.
if(PROJECT_IS_TOP_LEVEL AND NOT LIMN_SANITIZE)
  add_test(NAME consumer:find_package
    COMMAND ${CMAKE_COMMAND} -D BUILD=${PROJECT_BINARY_DIR} -D COMPILER=${CMAKE_CXX_COMPILER}
            -P ${PROJECT_SOURCE_DIR}/tests/consumer/run.cmake)
  set_tests_properties(consumer:find_package PROPERTIES TIMEOUT 180 LABELS consumer)
endif()

# The rules of tools/floors.txt, that their checker finds what it should, and citations.
find_package(Python3 COMPONENTS Interpreter)
if(Python3_FOUND)
  add_test(NAME tools:floors_hold
    COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/check_floors)
  add_test(NAME tools:check_floors
    COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tests/tools/check_floors_test.py)
  add_test(NAME tools:public_headers
    COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/check_public_headers)
  add_test(NAME tools:citations
    COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tests/tools/citations_test.py)
  add_test(NAME tools:api_reference
    COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/api_reference ${PROJECT_BINARY_DIR}/docs)
  add_test(NAME tools:api_reference_maker
    COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tests/tools/api_reference_test.py)
  set_tests_properties(tools:api_reference tools:api_reference_maker PROPERTIES SKIP_RETURN_CODE 77)
  set_tests_properties(tools:floors_hold tools:check_floors tools:public_headers tools:citations
    tools:api_reference tools:api_reference_maker PROPERTIES TIMEOUT 60 LABELS tools)
endif()
