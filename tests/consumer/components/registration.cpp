// A volume lies in itself.
#include <base/phantom.h>
#include <registration/rigid_registration.h>

#include "ends.h"

int main() {
    const macula::Volume volume = macula::phantom::make({.size = {64, 56, 40}, .spacingMm = {4.8, 4.8, 7.5}});
    macula::Progress progress;
    const auto found = macula::registration::registerRigid(volume, volume, progress);
    if (!found) return fail(found.error());
    const double movedMm = glm::length(glm::dvec3(found->movingFromFixed[3]));
    return expect(movedMm < 2.0 && found->overlap > 0.9, "it stays where it is");
}
