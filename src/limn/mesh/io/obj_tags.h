#pragma once
/// OpenSubdiv's tags in OBJ files, its own extension of the format:
///
///     t NAME i/f/s  then i integers, f decimals and s words
///
///     crease               vertices of a chain, and one sharpness or one for each of its edges
///     corner               vertices, and one sharpness or one for each
///     interpolateboundary  0: none, 1: edges and corners, 2: edges
///     creasemethod         normal or chaikin
///     hole                 faces
///     smoothtriangles      catmark or smooth
///
/// Vertices and faces count from 0, other than in the rest of the file.

#include "limn/mesh/io/text_scanner.h"
#include "limn/mesh/sharpness/sharpness.h"

namespace limn::io {

/// Reads what follows the word "t" on its line. False where it is at fault (the scanner knows why);
/// `name` is left empty where the tag was read, else it is that of one that limn does not know.
[[nodiscard]] bool read_obj_tag(TextScanner& in, SharpnessTags& tags, std::string& name);

/// The lines that state them.
[[nodiscard]] std::string obj_tag_lines(const SharpnessTags& tags);

}  // namespace limn::io
