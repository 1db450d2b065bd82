// The packed PLY of SuperSplat and PlayCanvas ("compressed.ply"): an element `chunk` has the bounds of 256
// splats each, and `vertex` four words of 32 bits a splat: position (11, 10 and 11 bits) and ln of the scale
// (likewise) within the bounds of its chunk, rotation (which of w, x, y, z is the largest, and 10 bits for
// each of the others in that order), and colour with opacity (8 bits each), within bounds too where the chunk
// has them. `sh`, if there, has a byte for each higher coefficient of colour, channel by channel, from -4 to
// 4.
#pragma once

#include "base/result.h"
#include "pipeline/splat/files/ply_header.h"
#include "pipeline/splat/files/ply_values.h"
#include "pipeline/splat/model/splats.h"

namespace macula::splat {

bool isPackedPly(const PlyHeader& header);

// Reads all elements from `values`, which are at the start of the data. Fails with inputNotUsable when a
// property is missing, chunks do not suffice for the splats, or the file is cut off. May throw
// std::bad_alloc.
Result<Splats> readPackedPly(const PlyHeader& header, PlyValues& values);

}  // namespace macula::splat
