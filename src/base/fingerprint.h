// A digest of a volume, which tells volumes apart where their UIDs do not.
#pragma once

#include <string>

#include "base/volume.h"

namespace macula {

// SHA-256, 64 hexadecimal digits, over size, affine, unit map, format, padding, and all voxels. Anonymisation
// often copies UIDs or makes new ones, so data about a volume are stored under this digest. Holds no patient
// data. On all cores; some 0.1 s for 150 MB where the processor has instructions for SHA.
std::string fingerprint(const Volume& volume);

}  // namespace macula
