// For presentation states: how a volume's voxels lie in the patient, and which values a window shows.
#pragma once

#include "base/volume.h"

namespace macula::scene {

// Whether each axis of the voxels runs along one of the patient's, in either direction.
bool isAlongPatient(const Volume& volume);

// The values from black to white; for SIGMOID the centre and half the width to both sides (PS3.3 C.11.2).
ValueRange valuesSeen(const DisplayWindow& window);

}  // namespace macula::scene
