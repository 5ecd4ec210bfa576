# The packages of section [product] of packages.txt; those of the tests and benchmarks are
# found in LimnTests.cmake and LimnBench.cmake.

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(FastFloat REQUIRED)
find_package(CLI11 REQUIRED)
find_package(Boost 1.74 REQUIRED)  # headers only
find_path(LIMN_TOML_INCLUDE_DIR toml++/toml.h REQUIRED)  # as headers, whatever its package builds
find_package(Threads REQUIRED)

set(LIMN_HAS_TBB OFF)
if(LIMN_TBB)
  find_package(TBB QUIET)
  if(TBB_FOUND)
    set(LIMN_HAS_TBB ON)
  else()
    message(STATUS "oneTBB not found: loops run on one thread")
  endif()
endif()

set(LIMN_HAS_CAIRO OFF)
if(LIMN_FIGURES)
  find_package(PkgConfig QUIET)
  if(PkgConfig_FOUND)
    pkg_check_modules(limn_cairo QUIET IMPORTED_TARGET cairo>=1.16)
  endif()
  if(limn_cairo_FOUND)
    set(LIMN_HAS_CAIRO ON)
  else()
    message(STATUS "cairo not found: no figures are drawn")
  endif()
endif()

set(LIMN_HAS_EMBREE OFF)
if(LIMN_RAYS)
  find_package(embree 3 CONFIG QUIET)
  if(embree_FOUND)
    set(LIMN_HAS_EMBREE ON)
  else()
    message(STATUS "Embree 3 not found: no smooth surfaces are drawn")
  endif()
endif()

# limn_find_c_library(NAME HEADER MISSING LIBRARY…): a C library that comes without a description for
# CMake, by its header and the first of these names: the target limn_NAME, which limnConfig.cmake
# makes anew, and LIMN_HAS_NAME in capitals; MISSING says what there is not without it.
function(limn_find_c_library name header missing)
  string(TOUPPER ${name} upper)
  find_path(LIMN_${upper}_INCLUDE_DIR ${header})
  find_library(LIMN_${upper}_LIBRARY NAMES ${ARGN})
  if(LIMN_${upper}_INCLUDE_DIR AND LIMN_${upper}_LIBRARY)
    set(LIMN_HAS_${upper} ON PARENT_SCOPE)
    add_library(limn_${name} INTERFACE IMPORTED GLOBAL)
    target_include_directories(limn_${name} SYSTEM INTERFACE ${LIMN_${upper}_INCLUDE_DIR})
    target_link_libraries(limn_${name} INTERFACE ${LIMN_${upper}_LIBRARY})
  else()
    message(STATUS "${name} not found: ${missing}")
  endif()
endfunction()

set(LIMN_HAS_FLINT OFF)
if(LIMN_FORMULAS)
  limn_find_c_library(flint flint/fmpq_mpoly_factor.h "no formulas for eigenvalues" flint)
endif()

set(LIMN_HAS_ARB OFF)
if(LIMN_PROOFS AND LIMN_HAS_FLINT)
  limn_find_c_library(arb arb.h "no proofs" flint-arb arb)  # Debian's name, and that of others
endif()

set(LIMN_HAS_SPECTRA OFF)
if(LIMN_SPECTRA)
  find_path(LIMN_SPECTRA_INCLUDE_DIR Spectra/SymEigsSolver.h)  # headers only
  if(LIMN_SPECTRA_INCLUDE_DIR)
    set(LIMN_HAS_SPECTRA ON)
  else()
    message(STATUS "Spectra not found: no modes of large meshes")
  endif()
endif()

set(LIMN_HAS_SQLITE OFF)
set(LIMN_HAS_NLOPT OFF)
set(LIMN_HAS_PAGMO OFF)
if(LIMN_STUDIES)
  find_package(SQLite3 QUIET)
  if(SQLite3_FOUND)
    set(LIMN_HAS_SQLITE ON)
  else()
    message(STATUS "SQLite not found: studies are not kept")
  endif()
  limn_find_c_library(nlopt nlopt.h "no local searches in studies" nlopt)
  find_package(pagmo QUIET)
  if(pagmo_FOUND)
    set(LIMN_HAS_PAGMO ON)
    # When the shared library is loaded, it fills tables of test problems: 60 ms and 34 MB for every
    # program. Of the archive only what is called is linked; but it cannot be linked into the Python
    # module, as its code must know where it is.
    set(limn_pagmo Pagmo::pagmo)
    find_library(LIMN_PAGMO_ARCHIVE libpagmo.a)
    mark_as_advanced(LIMN_PAGMO_ARCHIVE)
    if(LIMN_PAGMO_ARCHIVE)
      add_library(limn_pagmo_archive STATIC IMPORTED)
      set_target_properties(limn_pagmo_archive PROPERTIES
        IMPORTED_LOCATION ${LIMN_PAGMO_ARCHIVE}
        INTERFACE_LINK_LIBRARIES "Threads::Threads;Boost::serialization;TBB::tbb")
      string(CONCAT limn_pagmo "$<BUILD_INTERFACE:$<IF:$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>,"
        "limn_pagmo_archive,Pagmo::pagmo>>$<INSTALL_INTERFACE:Pagmo::pagmo>")
    endif()
  else()
    message(STATUS "pagmo not found: no global searches and no fronts by evolution in studies")
  endif()
endif()
