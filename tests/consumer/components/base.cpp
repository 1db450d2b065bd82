// A volume, and a point of it in the patient.
#include <base/phantom.h>
#include <base/volume.h>

#include "ends.h"

int main() {
    const macula::Volume volume = macula::phantom::make({.size = {64, 56, 40}, .spacingMm = {4.8, 4.8, 7.5}});
    // The marker is on the patient's left, which is +x.
    const bool isLeft = macula::phantom::markerCentreMm().x > 0.0;
    return expect(isLeft && volume.voxelCount() == 64u * 56u * 40u, "a volume of 64 x 56 x 40 voxels");
}
