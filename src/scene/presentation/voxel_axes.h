// How the voxels of a volume lie in the patient, and which values a window shows: what presentation states
// are written and read with.
#pragma once

#include "base/volume.h"

namespace macula::app {

// Whether each axis of the voxels runs along one of the patient's, in either direction.
bool isAlongPatient(const Volume& volume);

// From black to white, whatever the function of the window (PS3.3 C.11.2).
ValueRange valuesSeen(const DisplayWindow& window);

}  // namespace macula::app
