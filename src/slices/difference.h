// How values have changed between two volumes on one grid, such as phases of a study.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"

namespace macula::slices {

// `of` minus `minus` at each voxel, as float32, NaN where either is padding. Its unit is named "HU
// difference", so that each text with a value of it says so. Fails with inputNotUsable if the grids (to 1e-3
// mm) or the units differ, with `cancelled`, and with outOfMemory. Uses all cores.
Result<Volume> differenceOf(const Volume& of, const Volume& minus, const CancelToken& token = {});

// The window about 0 in which all but one in a hundred differences that are not 0 lie; some voxels of the
// volume are looked at. Not narrower than a millionth.
DisplayWindow symmetricWindow(const Volume& difference);

// A diverging colour for each value, 0xFFRRGGBB: from dark grey at 0 over blue to light cyan below, and over
// orange to light yellow above. The ends are reached at half the width of the window away from its centre.
// NaN is black, and no value is.
std::vector<std::uint32_t> toDiverging(std::span<const float> values, const DisplayWindow& window);

}  // namespace macula::slices
