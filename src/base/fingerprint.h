// A digest of a volume, which distinguishes volumes whose UIDs do not.
#pragma once

#include <string>

#include "base/volume.h"

namespace macula {

// SHA-256, 64 hexadecimal digits, over size, affine, unit map, format, padding, and all voxels. Anonymisation
// often copies UIDs or makes new ones, so data about a volume are stored under this digest. It contains no
// patient data. Uses all cores; takes some 0.1 s for 150 MB on a processor with SHA instructions.
std::string fingerprint(const Volume& volume);

}  // namespace macula
