// A trunk whose spine repeats itself, which a registration may take for itself one vertebra off.
#pragma once

#include <memory>

#include "base/volume.h"

namespace macula::registration::test {

inline constexpr double kVertebraMm = 30.0;  // from one to the next

struct Trunk {
    double differsBy = 0.0;  // of a vertebra to the next, a share of its width and of its density
    bool hasOrgans = false;  // kidneys, lungs and a pelvis: there is one place alone that fits
    double noiseHu = 10.0;   // to each side
    unsigned seed = 1;       // of the noise
    double vertebraMm = kVertebraMm;
};

// The slices of the trunk from `lowMm` to `highMm` along the patient, on voxels of 4 mm. What lies at p in
// the trunk lies at patientFromTrunk * p.
std::shared_ptr<const Volume> trunkScan(const Trunk& trunk, double lowMm, double highMm,
                                        const glm::dmat4& patientFromTrunk = glm::dmat4(1.0));

}  // namespace macula::registration::test
