# Run by ctest before it lists tests: the suites of a GoogleTest program, each a ctest of its own.
# A process for each suite, not for each test: many a program reads all shipped schemes as it starts.
# PROGRAM, PREFIX, LABEL, SECONDS, LIST (where the program's answer is kept while it is newer).

if(NOT EXISTS "${PROGRAM}")
  add_test("${PREFIX}:NOT_BUILT" "${PROGRAM}")
  return()
endif()
if(NOT EXISTS "${LIST}" OR "${PROGRAM}" IS_NEWER_THAN "${LIST}")
  execute_process(COMMAND "${PROGRAM}" --gtest_list_tests TIMEOUT 60
    OUTPUT_VARIABLE answer RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "${PROGRAM} --gtest_list_tests: ${failed}\n${answer}")
  endif()
  file(WRITE "${LIST}" "${answer}")
endif()

# add_suite(): `suite`, with `count` tests.
macro(add_suite)
  if(count)
    add_test("${PREFIX}:${suite}" "${PROGRAM}" "--gtest_filter=${suite}.*" --gtest_brief=1)
    # Large ones first. Random input is the same in every run; by itself, a program draws anew.
    set_tests_properties("${PREFIX}:${suite}" PROPERTIES LABELS "${LABEL}" TIMEOUT "${SECONDS}"
      COST ${count} ENVIRONMENT RC_PARAMS=seed=2026)
  endif()
endmacro()

set(suite "")
set(count 0)
file(STRINGS "${LIST}" lines)
foreach(line IN LISTS lines)
  if(line MATCHES "^  ")
    math(EXPR count "${count} + 1")
  elseif(line MATCHES "^([A-Za-z0-9_/]+)\\.")
    set(next "${CMAKE_MATCH_1}")
    add_suite()
    set(suite "${next}")
    set(count 0)
  endif()
endforeach()
add_suite()
