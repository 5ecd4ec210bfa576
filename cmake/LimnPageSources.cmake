# What the page's core is made of, for the native build and for emscripten's (web/core/CMakeLists.txt):
# page_core_sources, of which one holds the example meshes; and limn_version.
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH limn_root)

file(GLOB page_core_sources CONFIGURE_DEPENDS ${limn_root}/web/core/*.cpp)
list(FILTER page_core_sources EXCLUDE REGEX "/bindings\\.cpp$")

file(GLOB example_mesh_files CONFIGURE_DEPENDS ${limn_root}/web/core/meshes/*.obj
     ${limn_root}/examples/*.obj)
set(embedded_meshes ${PROJECT_BINARY_DIR}/generated/page/embedded_meshes.cpp)
add_custom_command(
  OUTPUT ${embedded_meshes}
  COMMAND ${CMAKE_COMMAND} -D OUT=${embedded_meshes} -D HEADER=core/example_meshes.h
          -D NAMESPACE=limn::page -D TYPE=EmbeddedMesh -D FUNCTION=embedded_meshes
          -P ${limn_root}/cmake/EmbedSchemes.cmake -- ${example_mesh_files}
  DEPENDS ${example_mesh_files} ${limn_root}/cmake/EmbedSchemes.cmake
  COMMENT "Embedding the page's example meshes"
  VERBATIM)
list(APPEND page_core_sources ${embedded_meshes})

file(STRINGS ${limn_root}/CMakeLists.txt limn_version REGEX "^  VERSION ")
string(REGEX REPLACE "^  VERSION " "" limn_version "${limn_version}")
