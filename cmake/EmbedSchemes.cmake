# cmake -D OUT=FILE.cpp -P EmbedSchemes.cmake -- SCHEME.toml…
# Writes the source that defines limn::scheme::shipped_files() (src/limn/scheme/file/shipped_files.h). Of other
# text files it defines FUNCTION() in the NAMESPACE, a vector of the TYPE that HEADER declares.
cmake_minimum_required(VERSION 3.25)

foreach(default IN ITEMS HEADER=limn/scheme/file/shipped_files.h NAMESPACE=limn::scheme TYPE=ShippedFile
        FUNCTION=shipped_files)
  string(REGEX MATCH "(.*)=(.*)" matched ${default})
  if(NOT DEFINED ${CMAKE_MATCH_1})
    set(${CMAKE_MATCH_1} ${CMAKE_MATCH_2})
  endif()
endforeach()

set(piece 8000)  # bytes; compilers need only take literals of 64 KiB, some take 16 KiB

# Appends to `out` the C++ literals that together are `text`, each a raw string.
function(append_literals out text)
  # A delimiter that the text does not contain.
  set(delimiter limn)
  set(serial 0)
  while(1)
    string(FIND "${text}" ")${delimiter}\"" at)
    if(at EQUAL -1)
      break()
    endif()
    math(EXPR serial "${serial} + 1")
    set(delimiter limn${serial})
  endwhile()

  set(literals "")
  while(1)
    string(LENGTH "${text}" length)
    set(take ${length})
    if(length GREATER piece)
      # After the last line that ends within the piece, so as to cut no character in two.
      string(SUBSTRING "${text}" 0 ${piece} head)
      string(FIND "${head}" "\n" newline REVERSE)
      math(EXPR take "${newline} + 1")
      if(take EQUAL 0)
        message(FATAL_ERROR "a line of more than ${piece} bytes cannot be embedded: break it")
      endif()
    endif()
    string(SUBSTRING "${text}" 0 ${take} head)
    string(SUBSTRING "${text}" ${take} -1 text)
    string(APPEND literals "\n     R\"${delimiter}(${head})${delimiter}\"")
    if(text STREQUAL "")
      break()
    endif()
  endwhile()
  set(${out} "${${out}}${literals}sv" PARENT_SCOPE)
endfunction()

set(files "")
set(past_dashes FALSE)
math(EXPR last "${CMAKE_ARGC} - 1")
foreach(i RANGE ${last})
  if(past_dashes)
    list(APPEND files "${CMAKE_ARGV${i}}")
  elseif("${CMAKE_ARGV${i}}" STREQUAL "--")
    set(past_dashes TRUE)
  endif()
endforeach()
list(SORT files)

set(entries "")
foreach(file IN LISTS files)
  file(READ "${file}" bytes HEX)
  string(REGEX MATCHALL ".." bytes "${bytes}")
  if(00 IN_LIST bytes)
    message(FATAL_ERROR "${file}: contains a zero byte, so it is no text")
  endif()
  file(READ "${file}" text)  # line ends become \n
  if(text MATCHES "\r")
    message(FATAL_ERROR "${file}: contains a carriage return that ends no line")
  endif()
  get_filename_component(name "${file}" NAME)
  string(REGEX REPLACE "\\.[a-z]+$" "" name "${name}")
  string(APPEND entries "    {\"${name}\"sv,")
  append_literals(entries "${text}")
  string(APPEND entries "},\n")
endforeach()

file(WRITE "${OUT}" "// Generated from text files by cmake/EmbedSchemes.cmake.
#include \"${HEADER}\"

namespace ${NAMESPACE} {

using namespace std::string_view_literals;

const std::vector<${TYPE}>& ${FUNCTION}() {
  static const std::vector<${TYPE}> files = {
${entries}  };
  return files;
}

}  // namespace ${NAMESPACE}
")
