// Registers one volume to another by a rotation and a translation, without deformation.
#pragma once

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"

namespace macula::registration {

struct RigidRegistration {
    glm::dmat4 movingFromFixed{1.0};  // mm LPS to mm LPS; a rotation and a translation
    double informationBefore = 0.0;   // mutual, in nats: as both lie, or else centred
    double informationAfter = 0.0;
    double overlap = 0.0;  // share of the fixed volume that lies in the moving one
    // How far apart two searches end that had different starts and samples: the largest distance at a corner
    // of the overlap, plus the last step. It says how sharp the answer is, not that it is right.
    double boundMm = 0.0;
    // The strongest other place that fits, such as one vertebra off: Rival::share and Rival::shiftMm; 0:
    // none.
    double rivalShare = 0.0;
    double rivalMm = 0.0;

    // Whether that place fits nearly as well, so that only a person can decide between both.
    bool hasRival() const;
    // Whether a person must check the result closely before comparing anything.
    bool isDoubtful() const;
    bool operator==(const RigidRegistration&) const = default;
};

// Rigid, by mutual information, so that it can combine CT, MR and PET. Both volumes may be oblique,
// anisotropic and sheared. The same volumes give the same bits, on any number of cores. Fails to find a
// patient who lies on another side, or is rotated by more than about 30 degrees. Errors: inputNotUsable for a
// volume of one value, too few voxels or too little in common; outOfMemory; cancelled.
Result<RigidRegistration> registerRigid(const Volume& fixed, const Volume& moving, Progress& progress);

// The share of the fixed volume's box that lies in the moving one's under this transform, from 0 to 1.
double boxOverlap(const Volume& fixed, const Volume& moving, const glm::dmat4& movingFromFixed);

// Whether it is finite, and a rotation with a translation to a thousandth: never a mirror.
bool isRigid(const glm::dmat4& transform);

}  // namespace macula::registration
