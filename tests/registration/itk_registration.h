// The same task as registerRigid, done by ITK: Mattes mutual information, descended by regular steps.
#pragma once

#include <cstddef>

#include "base/result.h"
#include "base/volume.h"

namespace macula::registration::test {

struct ItkRegistration {
    glm::dmat4 movingFromFixed{1.0};  // mm LPS to mm LPS
    double value = 0.0;               // of the metric, which is minus the mutual information in nats
    std::size_t iterations = 0;       // of the finest level
};

// Over three levels (cells 4, 2 and 1 times as large, smoothed by 4, 2 and 0 mm), with 40 bins, a fifth of
// the points and scales from physical shifts, from where both lie as they are: as ITK's examples set it up.
// The same volumes give the same numbers, but for the order of sums on several threads. Volumes of sheared
// voxels are an error: an image of ITK has none.
Result<ItkRegistration> registerByItk(const Volume& fixed, const Volume& moving);

}  // namespace macula::registration::test
