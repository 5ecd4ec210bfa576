# The library: every source below src/limn, and the shipped schemes as one generated source.

file(GLOB_RECURSE limn_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/limn/*.cpp)
# Only these are installed. The others are for the sources, the command and the tests.
file(STRINGS ${PROJECT_SOURCE_DIR}/cmake/public_headers.txt limn_headers REGEX "^limn/")
list(TRANSFORM limn_headers PREPEND ${PROJECT_SOURCE_DIR}/src/)
set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
             ${PROJECT_SOURCE_DIR}/cmake/public_headers.txt)
if(LIMN_FUZZ)
  # The fuzzers read files and refine meshes by the plain engine: no need to instrument the rest.
  list(FILTER limn_sources EXCLUDE REGEX
       "/limn/(figure|regular|spectrum|limit|fairness|fast|surface|tune|study|search|report)/")
endif()

# The command names every scheme file, so that it also runs again when one is added or removed.
file(GLOB scheme_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/schemes/*.toml)
set(shipped_files ${PROJECT_BINARY_DIR}/generated/limn/scheme/shipped_files.cpp)
add_custom_command(
  OUTPUT ${shipped_files}
  COMMAND ${CMAKE_COMMAND} -D OUT=${shipped_files} -P ${PROJECT_SOURCE_DIR}/cmake/EmbedSchemes.cmake
          -- ${scheme_files}
  DEPENDS ${scheme_files} ${PROJECT_SOURCE_DIR}/cmake/EmbedSchemes.cmake
  COMMENT "Embedding the shipped schemes"
  VERBATIM)
add_custom_target(shipped_files DEPENDS ${shipped_files})

add_library(limn ${limn_sources} ${shipped_files})
add_library(limn::limn ALIAS limn)
limn_flags(limn)
set_target_properties(limn PROPERTIES
  VERSION ${PROJECT_VERSION}
  SOVERSION ${PROJECT_VERSION_MAJOR}
  POSITION_INDEPENDENT_CODE ON)
target_sources(limn PUBLIC
  FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/src FILES ${limn_headers})
target_include_directories(limn PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>)
# Libraries that only our sources use, as headers, are no business of those who use an installed limn.
target_link_libraries(limn
  PUBLIC Eigen3::Eigen
  PRIVATE fmt::fmt Threads::Threads
          $<BUILD_INTERFACE:Boost::headers>
          $<BUILD_INTERFACE:nlohmann_json::nlohmann_json>
          $<BUILD_INTERFACE:FastFloat::fast_float>)
target_include_directories(limn SYSTEM PRIVATE ${LIMN_TOML_INCLUDE_DIR})
# Square roots in vectors: they need not set errno.
set_source_files_properties(${PROJECT_SOURCE_DIR}/src/limn/fast/kernel/patch_step.cpp
  PROPERTIES COMPILE_OPTIONS -fno-math-errno)
limn_sanitize_folders(limn)

limn_precompile(limn <Eigen/Dense> <fmt/core.h>)

if(LIMN_SANITIZE STREQUAL thread)
  # It does not see how TBB's tasks synchronise.
  set_source_files_properties(${PROJECT_SOURCE_DIR}/src/limn/base/parallel.cpp
    PROPERTIES COMPILE_DEFINITIONS LIMN_PLAIN_THREADS=1)
elseif(LIMN_HAS_TBB)
  target_compile_definitions(limn PRIVATE LIMN_HAS_TBB=1)
  target_link_libraries(limn PRIVATE TBB::tbb)
endif()
if(LIMN_HAS_CAIRO)
  target_compile_definitions(limn PRIVATE LIMN_HAS_CAIRO=1)
  target_link_libraries(limn PRIVATE PkgConfig::limn_cairo)
endif()
if(LIMN_HAS_EMBREE)
  target_compile_definitions(limn PRIVATE LIMN_HAS_EMBREE=1)
  target_link_libraries(limn PRIVATE embree)
endif()
if(LIMN_HAS_SPECTRA)
  target_compile_definitions(limn PRIVATE LIMN_HAS_SPECTRA=1)
  target_include_directories(limn SYSTEM PRIVATE ${LIMN_SPECTRA_INCLUDE_DIR})
endif()
if(LIMN_HAS_ARB)
  target_compile_definitions(limn PRIVATE LIMN_HAS_ARB=1)
  target_link_libraries(limn PRIVATE limn_arb)
endif()
if(LIMN_HAS_FLINT)
  target_compile_definitions(limn PRIVATE LIMN_HAS_FLINT=1)
  target_link_libraries(limn PRIVATE limn_flint)
endif()
# limn_studies_use(LIBRARY SOURCE DEFINITION [LINKED]): each library is seen by one source, and the
# others are compiled as without it. LINKED is what is linked, where that is not LIBRARY.
function(limn_studies_use library source definition)
  set(linked ${library})
  if(ARGC GREATER 3)
    set(linked ${ARGV3})
  endif()
  get_target_property(includes ${library} INTERFACE_INCLUDE_DIRECTORIES)
  list(REMOVE_ITEM includes ${CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES} includes-NOTFOUND)
  set_source_files_properties(${PROJECT_SOURCE_DIR}/src/limn/search/${source} PROPERTIES
    COMPILE_DEFINITIONS ${definition}=1
    INCLUDE_DIRECTORIES "${includes}")
  target_link_libraries(limn PRIVATE $<LINK_ONLY:${linked}>)
endfunction()
if(LIMN_HAS_SQLITE)
  limn_studies_use(SQLite::SQLite3 store.cpp LIMN_HAS_SQLITE)
endif()
if(LIMN_HAS_NLOPT)
  limn_studies_use(limn_nlopt local_method.cpp LIMN_HAS_NLOPT)
endif()
if(LIMN_HAS_PAGMO)
  limn_studies_use(Pagmo::pagmo evolution_method.cpp LIMN_HAS_PAGMO ${limn_pagmo})
endif()
limn_unite(limn ${PROJECT_SOURCE_DIR}/src)
