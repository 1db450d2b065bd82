//  Macula's notes about a model, for which splat file formats have no field: where the model is, in which
//  axes, and how it blends. Written as lines of text into comments of PLY and of the gzip header of SPZ,
//  where other programs skip them:
//    macula model 1
//    macula axes patient-lps-mm        or unknown
//    macula origin-mm X Y Z            to be added to each position
//    macula colours linear             or display
//    macula low-pass adaptive          or compensated, classic, mip
//  Lines that do not begin with "macula " belong to other programs.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "pipeline/splat/model/splats.h"

namespace macula::splat {

// The notes of a model. Their numbers read back exactly.
std::vector<std::string> notesOf(const Splats& splats);

// Sets origin, axes, colour space and low-pass. Without any Macula line the model is foreign: axes unknown,
// origin 0, display colours, classic low-pass. Fails with inputNotUsable when Macula's lines are incomplete,
// repeated, of a later version or not understood: a model in a wrong place would be worse than none.
Result<void> applyNotes(const std::vector<std::string>& lines, Splats& splats);

}  // namespace macula::splat
