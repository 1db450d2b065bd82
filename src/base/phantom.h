// The built-in CT phantom: a made-up chest whose value at every point is known in closed form. It is the demo
// that opens when no folder is given, and the ground truth of the tests.
//
// Asymmetric on purpose: the heart and a solid cube of metal-free marker (a "left-side marker", 1000 HU) lie
// on the patient's left, the liver on the right, the spine behind, so that a mirrored or upside-down picture
// is wrong at a glance and in a test. The grid is oblique to the patient axes and anisotropic.
#pragma once

#include "base/volume.h"

namespace macula::phantom {

// Exact value in HU at a point in patient LPS mm. Pure; defined everywhere (air outside).
int valueHu(const glm::dvec3& worldMm);

// Centre and half the edge of the left-side marker, patient LPS mm.
glm::dvec3 markerCentreMm();
double markerHalfEdgeMm();

struct Options {
    glm::ivec3 size{256, 224, 160};
    glm::dvec3 spacingMm{1.2, 1.2, 1.875};
    glm::dvec3 tiltDeg{4.0, 0.0, 7.0};  // about the patient's x, y, z axes, applied in this order
};

// The default worldFromVoxel centres the grid on the patient's origin.
glm::dmat4 worldFromVoxel(const Options& options = {});

// Each voxel has the valueHu of its centre; stored = HU + 1024, modality CT.
Volume make(const Options& options = {});

}  // namespace macula::phantom
