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

set(LIMN_HAS_FLINT OFF)
if(LIMN_FORMULAS)
  find_path(LIMN_FLINT_INCLUDE_DIR flint/fmpq_mpoly_factor.h)
  find_library(LIMN_FLINT_LIBRARY flint)
  if(LIMN_FLINT_INCLUDE_DIR AND LIMN_FLINT_LIBRARY)
    set(LIMN_HAS_FLINT ON)
    add_library(limn_flint INTERFACE IMPORTED)  # limnConfig.cmake makes it anew
    target_include_directories(limn_flint SYSTEM INTERFACE ${LIMN_FLINT_INCLUDE_DIR})
    target_link_libraries(limn_flint INTERFACE ${LIMN_FLINT_LIBRARY})
  else()
    message(STATUS "FLINT not found: no formulas for eigenvalues")
  endif()
endif()
