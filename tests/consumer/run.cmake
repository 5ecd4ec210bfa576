# cmake -D BUILD=… -D COMPILER=… -P run.cmake
# Installs the build folder BUILD into BUILD/consumer-prefix, then configures, builds and runs the
# project beside this file, the README's example programs, against it.
cmake_minimum_required(VERSION 3.25)

set(prefix ${BUILD}/consumer-prefix)
set(work ${BUILD}/consumer-build)
cmake_path(SET examples NORMALIZE ${CMAKE_CURRENT_LIST_DIR}/../../examples)
cmake_path(SET sources NORMALIZE ${CMAKE_CURRENT_LIST_DIR}/../../src)
file(REMOVE_RECURSE ${prefix} ${work})

function(step)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
step(${CMAKE_COMMAND} -E env --unset=DESTDIR ${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
step(${CMAKE_COMMAND} -G Ninja -S ${CMAKE_CURRENT_LIST_DIR} -B ${work}
     -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_COMPILER=${COMPILER}
     -D EXAMPLES=${examples} -D LIMN_PREFIX=${prefix} -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_FIND_PACKAGE_NO_PACKAGE_REGISTRY=ON)
step(${CMAKE_COMMAND} --build ${work})

# What the headers bring beside the standard library and limn itself: Eigen alone.
execute_process(
  COMMAND ninja -C ${work} -t deps CMakeFiles/every_header.dir/every_header.cpp.o
  OUTPUT_VARIABLE read COMMAND_ERROR_IS_FATAL ANY)
if(NOT read MATCHES "/include/limn/limn\\.h\n")
  message(FATAL_ERROR "every_header.cpp did not read limn.h:\n${read}")
endif()
string(REGEX MATCHALL
  "[^\n]*/include/(fmt|nlohmann|toml\\+\\+|fast_float|tbb|oneapi|cairo|embree[0-9]*|flint|Spectra|CLI|boost)/[^\n]*"
  strangers "${read}")
string(FIND "${read}" "${sources}/limn/" from_sources)
if(NOT from_sources EQUAL -1)
  list(APPEND strangers "headers below ${sources}, which are not installed")
endif()
if(strangers)
  message(FATAL_ERROR "public headers bring headers that users need not have:\n${strangers}")
endif()

step(${work}/refine ${examples}/bracket.obj loop 2 ${work}/fine.ply)
step(${work}/animate ${examples}/bracket.obj loop 2 3)
step(${work}/analyse)
step(${work}/tune)
if(EXISTS ${BUILD}/bin/limn)
  step(${prefix}/bin/limn --help)
endif()
