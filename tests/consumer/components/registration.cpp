// A volume lies in itself.
#include <base/phantom.h>
#include <registration/rigid_registration.h>

#include "ends.h"

int main() {
    const macula::Volume volume = macula::phantom::make({.size = {64, 56, 40}, .spacingMm = {4.8, 4.8, 7.5}});
    macula::Progress progress;
    const auto found = macula::registration::registerRigid(volume, volume, progress);
    if (!found) return fail(found.error());
    return expect(macula::registration::boxOverlap(volume, volume, glm::dmat4(1.0)) > 0.99, "all of it");
}
