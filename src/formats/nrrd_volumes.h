// The volumes of an NRRD file with four axes.
#pragma once

#include "base/result.h"
#include "formats/text_header.h"

namespace macula::formats {

inline constexpr std::size_t kMostVolumes = 100'000;  // in a file; more are no volumes of a person

struct NrrdVolumes {
    std::size_t count = 1;
    bool isInterleaved = false;  // they alternate voxel by voxel: their axis is the first, not the last
    VolumeAxis axis = {};
};

// Takes the axis that does not lie in space out of the fields of a header with four axes: the last or first,
// along which one volume follows another, for each point in time or each entry of a list. Leaves all other
// headers as they are. Axes of components, such as colours and vectors, are inputNotUsable. `notes` are what
// programs add ("axis 3 index values" of 3D Slicer).
Result<NrrdVolumes> takeNrrdVolumes(Fields& fields, const Fields& notes);

// The error for a file with several values in each voxel.
Error severalValues();

}  // namespace macula::formats
