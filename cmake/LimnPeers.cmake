# Targets limn_peer_cgal, limn_peer_openmesh, limn_peer_opensubdiv: other libraries that the tests
# and benchmarks compare with. Their headers are system headers (no warnings from them), and
# their licences bind only those programs, never the library or the command.
include_guard()

# limn_find_peer(NAME HEADER LIBRARY…)
function(limn_find_peer name header)
  add_library(limn_peer_${name} INTERFACE)
  find_path(LIMN_${name}_INCLUDE_DIR ${header} REQUIRED)
  target_include_directories(limn_peer_${name} SYSTEM INTERFACE ${LIMN_${name}_INCLUDE_DIR})
  foreach(library IN LISTS ARGN)
    find_library(LIMN_${name}_${library} ${library} REQUIRED)
    target_link_libraries(limn_peer_${name} INTERFACE ${LIMN_${name}_${library}})
  endforeach()
endfunction()

# Debian's own CMake files for OpenSubdiv name files that its package does not hold, hence paths.
limn_find_peer(cgal CGAL/version.h gmp mpfr)
limn_find_peer(openmesh OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh OpenMeshCore OpenMeshTools)
limn_find_peer(opensubdiv opensubdiv/version.h osdCPU)
target_link_libraries(limn_peer_cgal INTERFACE Boost::headers Eigen3::Eigen)
