# Every bench/NAME.cpp is a Google Benchmark program limn_bench_NAME. The folder bench/peers is a
# program of its own kind: it times the other libraries beside ours, through the adapters of
# tests/peers.

find_package(benchmark REQUIRED)

# The control meshes, which the tests use too.
add_library(limn_bench_meshes STATIC ${PROJECT_SOURCE_DIR}/tests/peers/control_meshes.cpp)
limn_flags(limn_bench_meshes)
target_include_directories(limn_bench_meshes PUBLIC ${PROJECT_SOURCE_DIR}/tests)
target_link_libraries(limn_bench_meshes PUBLIC limn::limn)

# limn_add_bench(NAME SOURCE…)
function(limn_add_bench name)
  add_executable(limn_bench_${name} ${ARGN})
  limn_flags(limn_bench_${name})
  target_link_libraries(limn_bench_${name} PRIVATE limn::limn limn_bench_meshes fmt::fmt)
endfunction()

file(GLOB bench_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/bench/*.cpp)
foreach(source IN LISTS bench_sources)
  cmake_path(GET source STEM name)
  limn_add_bench(${name} ${source})
  target_link_libraries(limn_bench_${name} PRIVATE
    benchmark::benchmark benchmark::benchmark_main)
  if(name STREQUAL "file_to_file")
    target_compile_definitions(limn_bench_${name} PRIVATE LIMN_COMMAND="$<TARGET_FILE:limn_command>")
    add_dependencies(limn_bench_${name} limn_command)
  endif()
endforeach()

if(LIMN_PEERS)
  include(LimnPeers)
  file(GLOB peer_sources CONFIGURE_DEPENDS
    ${PROJECT_SOURCE_DIR}/bench/peers/*.cpp ${PROJECT_SOURCE_DIR}/tests/peers/peer_*.cpp)
  limn_add_bench(peers ${peer_sources})
  target_link_libraries(limn_bench_peers PRIVATE
    limn_peer_cgal limn_peer_openmesh limn_peer_opensubdiv CLI11::CLI11)
endif()
