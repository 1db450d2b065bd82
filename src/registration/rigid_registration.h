// Where a point of one volume lies in another: turned and moved, not bent.
#pragma once

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"

namespace macula::registration {

struct RigidRegistration {
    glm::dmat4 movingFromFixed{1.0};  // mm LPS to mm LPS; a rotation and a shift
    double informationBefore = 0.0;   // mutual, in nats: where both lie as they are, or middle on middle
    double informationAfter = 0.0;
    double overlap = 0.0;  // the share of the fixed volume that lies in the moving one
    // How far two searches from two starts, by other samples, are apart at the corner of what overlaps that
    // is farthest, with the last step of either. It says how sharp the answer is, and not that it is right.
    double boundMm = 0.0;
    // Of another place along the patient, one vertebra off for one, how much of the likeness that is lost on
    // the way there comes back (Rival), and how far away it is. 0: there is none.
    double rivalShare = 0.0;
    double rivalMm = 0.0;

    // Whether that place fits nearly as well, so that nothing but a person can say which of both is right.
    bool hasRival() const;
    // What a person has to look at closely before anything is compared.
    bool isDoubtful() const;
    bool operator==(const RigidRegistration&) const = default;
};

// Rigid, by mutual information, so that CT, MR and PET go together. Both may be oblique, anisotropic and
// sheared. The same volumes give the same bits, on any number of cores. A patient who lies on the other side,
// or is turned by more than some 30 degrees, is not found. Fails with inputNotUsable where there is nothing
// to go by: one value only, too few voxels, too little of the same; with outOfMemory, and with cancelled.
Result<RigidRegistration> registerRigid(const Volume& fixed, const Volume& moving, Progress& progress);

// How much of the fixed volume's box lies in the moving one's, from 0 to 1: whether there is anything to see
// where they are linked so.
double boxOverlap(const Volume& fixed, const Volume& moving, const glm::dmat4& movingFromFixed);

// Finite, and a rotation and a shift to a thousandth: never a mirror.
bool isRigid(const glm::dmat4& transform);

}  // namespace macula::registration
