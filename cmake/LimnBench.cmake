# Every bench/NAME.cpp is a Google Benchmark program limn_bench_NAME. bench/peers.cpp is a program
# of its own kind: it times the other libraries beside ours, through the adapters of tests/peers.

find_package(benchmark REQUIRED)
file(GLOB bench_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/bench/*.cpp)
if(NOT bench_sources)
  message(STATUS "bench has no sources: no benchmarks are built")
endif()

# The control meshes, which the tests use too.
add_library(limn_bench_meshes STATIC ${PROJECT_SOURCE_DIR}/tests/peers/control_meshes.cpp)
limn_flags(limn_bench_meshes)
target_include_directories(limn_bench_meshes PUBLIC ${PROJECT_SOURCE_DIR}/tests)
target_link_libraries(limn_bench_meshes PUBLIC limn::limn)

foreach(source IN LISTS bench_sources)
  cmake_path(GET source STEM name)
  if(name MATCHES "^peers" AND NOT LIMN_PEERS)
    continue()
  endif()
  add_executable(limn_bench_${name} ${source})
  limn_flags(limn_bench_${name})
  target_link_libraries(limn_bench_${name} PRIVATE limn::limn limn_bench_meshes fmt::fmt)
  target_compile_definitions(limn_bench_${name} PRIVATE
    LIMN_EXAMPLES="${PROJECT_SOURCE_DIR}/examples")
  if(name MATCHES "^peers")
    include(LimnPeers)
    file(GLOB adapters CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/peers/peer_*.cpp)
    target_sources(limn_bench_${name} PRIVATE ${adapters})
    target_link_libraries(limn_bench_${name} PRIVATE
      limn_peer_cgal limn_peer_openmesh limn_peer_opensubdiv CLI11::CLI11)
  else()
    target_link_libraries(limn_bench_${name} PRIVATE
      benchmark::benchmark benchmark::benchmark_main)
  endif()
endforeach()
