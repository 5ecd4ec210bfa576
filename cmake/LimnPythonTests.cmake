# Tests of the Python module: a ctest for each file of python/tests, for the types, for what
# docs/python.md says, and for the examples. They need pytest, mypy and matplotlib.

execute_process(COMMAND ${Python3_EXECUTABLE} -c "import pytest, mypy, matplotlib"
  RESULT_VARIABLE missing OUTPUT_QUIET ERROR_QUIET)
if(missing)
  message(STATUS "pytest, mypy or matplotlib not found: the Python module is not tested")
  return()
endif()

# limn_python_test(NAME SECONDS ARGUMENT…): python3 ARGUMENT… with the module of this build.
function(limn_python_test name seconds)
  add_test(NAME python:${name} COMMAND Python3::Interpreter ${ARGN})
  set_tests_properties(python:${name} PROPERTIES TIMEOUT ${seconds} LABELS python
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    ENVIRONMENT "PYTHONPATH=${PROJECT_BINARY_DIR}/python;PYTHONDONTWRITEBYTECODE=1;MPLBACKEND=Agg;LIMN_COMMAND=$<TARGET_FILE:limn_command>")
endfunction()

file(GLOB python_tests CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/python/tests/test_*.py)
foreach(test IN LISTS python_tests)
  cmake_path(GET test STEM name)
  string(REPLACE "test_" "" name ${name})
  limn_python_test(${name} 900 -m pytest -q -p no:cacheprovider ${test})
endforeach()

limn_python_test(types 300 -m mypy --cache-dir ${PROJECT_BINARY_DIR}/mypy python/limn)
limn_python_test(stubs 300 -m mypy.stubtest --mypy-config-file ${PROJECT_SOURCE_DIR}/pyproject.toml
  --allowlist ${PROJECT_SOURCE_DIR}/python/tests/stubs_differ.txt limn._limn)
# From elsewhere: below python/ is a package limn without its extension.
set_tests_properties(python:stubs PROPERTIES WORKING_DIRECTORY ${PROJECT_BINARY_DIR}
  ENVIRONMENT "PYTHONPATH=${PROJECT_BINARY_DIR}/python;MYPYPATH=${PROJECT_BINARY_DIR}/python")
set_tests_properties(python:types PROPERTIES ENVIRONMENT "")
limn_python_test(documents 300 python/tests/documents.py docs/python.md)

file(GLOB python_examples CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/examples/python/*.py)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/examples)
foreach(example IN LISTS python_examples)
  cmake_path(GET example STEM name)
  limn_python_test(example_${name} 300 ${example} ${PROJECT_BINARY_DIR}/examples)
endforeach()
limn_python_test(packaging 600 python/tests/installing.py ${PROJECT_BINARY_DIR})
