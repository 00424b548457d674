#pragma once

#include <string_view>

#include "bridge/surface/FileTriangles.h"

namespace restenosis {

/// Whether a text can be that of ASCII STL by its first bytes, as many as the header of a binary file has: no
/// control characters are among them but blanks and ends of lines.
bool beginsAsStlText(std::string_view content);

/// Reads the text of an ASCII STL file: any number of
/// ```
/// solid [name]
///   facet normal nx ny nz
///     outer loop
///       vertex x y z      (three times)
///     endloop
///   endfacet              (any number of facets)
/// endsolid [name]
/// ```
/// a line each, or several or all of them in one line. Case and indentation of the words are free, and so is
/// what follows them but for vertices; empty lines, "color ..." between facets, and a byte order mark are
/// passed over, and the last "endsolid" may be missing. Where files were joined, a "solid" may follow an
/// "endsolid" or its name without a blank. Normals are not read.
///
/// Throws std::runtime_error, "`name`:LINE: what is wrong", at the first line that is none of these.
FileTriangles parseStlText(std::string_view text, std::string_view name);

/// Reads solids in the same way off the front of `content` and adds them to `triangles`, until no text
/// follows the end of a solid: what is left of `content` is for the caller to judge. `isRest` says whether a
/// binary file may begin right behind an "endsolid" or its name; null: all of it is text.
void takeStlText(std::string_view& content, std::string_view name, bool (*isRest)(std::string_view),
                 FileTriangles& triangles);

}  // namespace restenosis
