#pragma once

#include <string_view>

#include "StlTriangles.h"

namespace restenosis {

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
/// a line each. Case and indentation of the words are free, and so is what follows them but for vertices;
/// empty lines, lines "color ..." between facets, and a byte order mark are passed over, and the last
/// "endsolid" may be missing. Normals are not read.
///
/// Throws std::runtime_error, "`name`:LINE: what is wrong", at the first line that is none of these.
StlTriangles parseStlText(std::string_view text, std::string_view name);

}  // namespace restenosis
