# Every bench/NAME.cpp is a Google Benchmark program limn_bench_NAME; bench/peers*.cpp also see
# the other libraries that they time beside ours.

find_package(benchmark REQUIRED)
file(GLOB bench_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/bench/*.cpp)
if(NOT bench_sources)
  message(STATUS "bench has no sources: no benchmarks are built")
endif()
foreach(source IN LISTS bench_sources)
  cmake_path(GET source STEM name)
  if(name MATCHES "^peers" AND NOT LIMN_PEERS)
    continue()
  endif()
  add_executable(limn_bench_${name} ${source})
  limn_flags(limn_bench_${name})
  target_link_libraries(limn_bench_${name} PRIVATE
    limn::limn fmt::fmt benchmark::benchmark benchmark::benchmark_main)
  target_compile_definitions(limn_bench_${name} PRIVATE
    LIMN_EXAMPLES="${PROJECT_SOURCE_DIR}/examples")
  if(name MATCHES "^peers")
    include(LimnPeers)
    target_link_libraries(limn_bench_${name} PRIVATE
      limn_peer_cgal limn_peer_openmesh limn_peer_opensubdiv)
  endif()
endforeach()
