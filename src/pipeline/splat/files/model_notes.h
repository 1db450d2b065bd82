// What the file formats of splats have no field for: where the model is, in which axes, and how it blends.
// Written as lines of text into comments of PLY and of the gzip header of SPZ, where other programs skip
// them:
//   macula model 1
//   macula axes patient-lps-mm        or unknown
//   macula origin-mm X Y Z            what is added to each position
//   macula colours linear             or display
//   macula low-pass adaptive          or compensated, classic, mip
// Lines that do not begin with "macula " are other programs' business.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "pipeline/splat/model/splats.h"

namespace macula::splat {

// Numbers are written so that they read back exactly.
std::vector<std::string> notesOf(const Splats& splats);

// Sets origin, axes, colour space and low-pass. Without any line of ours the model is foreign: axes unknown,
// origin 0, colours of the display, classic low-pass. Fails with inputNotUsable when lines of ours are
// missing, twice, of a later version or not understood: a model in a wrong place would be worse than none.
Result<void> applyNotes(const std::vector<std::string>& lines, Splats& splats);

}  // namespace macula::splat
