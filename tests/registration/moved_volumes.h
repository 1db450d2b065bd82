// Volumes of the phantom that lie somewhere else, on another grid, or show it as another scanner would.
#pragma once

#include <functional>
#include <memory>

#include "base/phantom.h"
#include "base/volume.h"

namespace macula::registration::test {

// Turned about a slanted axis, and moved; the middle is the patient's origin.
glm::dmat4 rigid(double degrees, const glm::dvec3& shiftMm);

// Coarse enough to be quick; 4 mm and more to a voxel.
inline phantom::Options coarsePhantom() {
    return {.size = {72, 62, 48}, .spacingMm = {4.2, 4.2, 6.2}, .tiltDeg = {4.0, 0.0, 7.0}};
}

// From HU to what another scanner has there.
using Scanner = std::function<double(double hu)>;

struct Scan {
    glm::ivec3 size{66, 70, 52};
    glm::dmat4 worldFromVoxel{1.0};
    Unit unit = Unit::hounsfield;
    Scanner scanner = [](double hu) { return hu; };
};
// The grid of `scan`, 4.6 x 4.1 x 5.5 mm, straight to the patient's axes; its z axis leans by `leansDeg`.
Scan straightScan(double leansDeg = 0.0);

// The phantom after the patient has moved: its point p lies at movedFromPhantom * p. Float values.
std::shared_ptr<const Volume> scanOf(const Scan& scan, const glm::dmat4& movedFromPhantom);

// The largest distance between where both say that a point of the phantom's body lies, mm.
double errorMm(const glm::dmat4& found, const glm::dmat4& truth);

}  // namespace macula::registration::test
