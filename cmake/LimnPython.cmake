# The Python module: python/limn below the build folder, so that PYTHONPATH=<build>/python suffices.
# For the interpreter LIMN_PYTHON_EXECUTABLE; where it has no NumPy, or pybind11's headers are
# missing, there is no module.

find_program(LIMN_PYTHON_EXECUTABLE NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH
  DOC "The Python that the module is for; it has NumPy")
if(NOT LIMN_PYTHON_EXECUTABLE)
  unset(LIMN_PYTHON_EXECUTABLE CACHE)
  find_program(LIMN_PYTHON_EXECUTABLE NAMES python3)
endif()
if(LIMN_PYTHON_EXECUTABLE AND NOT DEFINED Python3_EXECUTABLE)
  set(Python3_EXECUTABLE ${LIMN_PYTHON_EXECUTABLE})
endif()
find_package(Python3 QUIET COMPONENTS Interpreter OPTIONAL_COMPONENTS Development.Module NumPy)
execute_process(COMMAND ${Python3_EXECUTABLE} -c "import pybind11; print(pybind11.get_include())"
  OUTPUT_VARIABLE pybind11_hint OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
find_path(LIMN_PYBIND11_INCLUDE_DIR pybind11/pybind11.h HINTS ${pybind11_hint})

if(NOT Python3_Development.Module_FOUND OR NOT Python3_NumPy_FOUND OR NOT LIMN_PYBIND11_INCLUDE_DIR)
  message(STATUS "pybind11, NumPy or Python's headers not found: no Python module")
  return()
endif()

file(GLOB python_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/python/src/*.cpp)
python3_add_library(limn_python MODULE WITH_SOABI ${python_sources})
limn_flags(limn_python)
set(python_package ${PROJECT_BINARY_DIR}/python/limn)
set_target_properties(limn_python PROPERTIES OUTPUT_NAME _limn
  LIBRARY_OUTPUT_DIRECTORY ${python_package})
target_compile_definitions(limn_python PRIVATE LIMN_VERSION="${PROJECT_VERSION}")
target_include_directories(limn_python SYSTEM PRIVATE ${LIMN_PYBIND11_INCLUDE_DIR})
target_link_libraries(limn_python PRIVATE
  limn_papers limn::limn Python3::NumPy nlohmann_json::nlohmann_json)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND NOT LIMN_LINT)
  # What pybind11 inlines looks to GCC 12 as though it went beyond arrays.
  target_compile_options(limn_python PRIVATE -Wno-array-bounds -Wno-stringop-overflow)
endif()
limn_optimise_less(limn_python)
limn_precompile(limn_python <pybind11/numpy.h> <pybind11/stl.h> <nlohmann/json.hpp>)
limn_unite(limn_python ${PROJECT_SOURCE_DIR}/python/src)

# The rest of the package, beside it.
file(GLOB python_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/python/limn/*.py
  ${PROJECT_SOURCE_DIR}/python/limn/*.pyi ${PROJECT_SOURCE_DIR}/python/limn/py.typed)
set(python_copies)
foreach(file IN LISTS python_files)
  cmake_path(GET file FILENAME name)
  add_custom_command(OUTPUT ${python_package}/${name} DEPENDS ${file}
    COMMAND ${CMAKE_COMMAND} -E copy ${file} ${python_package}/${name} VERBATIM)
  list(APPEND python_copies ${python_package}/${name})
endforeach()
add_custom_target(limn_python_files ALL DEPENDS ${python_copies})
add_dependencies(limn_python limn_python_files)
