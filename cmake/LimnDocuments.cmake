# Tests of documents: what they name is there, the table of schemes is limn's, and what the
# walk-throughs say is done, to the letter; and of one thing that they say of the code: all headers can be included together.

find_package(Python3 COMPONENTS Interpreter)
if(Python3_FOUND)
  add_test(NAME tools:documents_name_existing_files
    COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tests/tools/documents_test.py)
  add_test(NAME tools:fault_table
    COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tests/tools/fault_table_test.py)
  add_test(NAME tools:follow_walkthrough
    COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tests/tools/follow_walkthrough_test.py)
  set_tests_properties(tools:documents_name_existing_files tools:fault_table tools:follow_walkthrough
    PROPERTIES TIMEOUT 60 LABELS tools)
  add_test(NAME tools:scheme_table
    COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tests/tools/scheme_table_test.py)
  set_tests_properties(tools:scheme_table PROPERTIES TIMEOUT 60 LABELS tools)
  # Sanitizers make a program that is started once a scheme too slow for this.
  if(TARGET limn_command AND NOT LIMN_SANITIZE)
    add_test(NAME tools:schemes_page
      COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/scheme_table
              $<TARGET_FILE:limn_command> --check)
    set_tests_properties(tools:schemes_page PROPERTIES TIMEOUT 60 LABELS tools)
  endif()
  # They take the flags and objects of this build folder, from what Ninja knows.
  if(CMAKE_EXPORT_COMPILE_COMMANDS AND CMAKE_GENERATOR STREQUAL "Ninja" AND NOT LIMN_SANITIZE)
    foreach(page split role report)
      add_test(NAME tools:walkthrough_add_a_${page}
        COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tools/follow_walkthrough
                ${PROJECT_SOURCE_DIR}/docs/walkthroughs/add-a-${page}.md --build ${PROJECT_BINARY_DIR})
      set_tests_properties(tools:walkthrough_add_a_${page} PROPERTIES TIMEOUT 180 LABELS tools)
    endforeach()
  endif()
endif()
