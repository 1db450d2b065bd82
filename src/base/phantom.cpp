#include "base/phantom.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "base/parallel.h"

namespace macula::phantom {

namespace {

// Values in HU.
constexpr int kAir = -1000;
constexpr int kLung = -850;
constexpr int kFat = -90;
constexpr int kMuscle = 50;
constexpr int kLiver = 110;
constexpr int kMyocardium = 100;
constexpr int kContrast = 330;
constexpr int kPulmonaryContrast = 260;
constexpr int kDisc = 80;
constexpr int kSpongiosa = 320;
constexpr int kCortex = 850;
constexpr int kMarker = 1000;

constexpr int kUnitsOffset = 1024;  // stored = HU + 1024, as most CT scanners write it

using glm::dvec2;
using glm::dvec3;

// The distance from the centre of an ellipsoid, in radii: below 1 inside.
double ellipsoid(const dvec3& p, const dvec3& centre, const dvec3& radii) {
    return glm::length((p - centre) / radii);
}

double ellipse(const dvec2& p, const dvec2& centre, const dvec2& radii) {
    return glm::length((p - centre) / radii);
}

// Distance to the segment ab.
double toSegment(const dvec3& p, const dvec3& a, const dvec3& b) {
    const dvec3 ab = b - a;
    const double t = std::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0, 1.0);
    return glm::length(p - (a + t * ab));
}

struct Tube {
    dvec3 from, to;
    double radiusMm;
};

// The aorta: up from the heart, over the arch to the left and back, down before the spine.
constexpr int kAortaPieces = 6;
const std::array<Tube, kAortaPieces> kAorta{{{{-4, -22, 0}, {-12, -26, 45}, 13},
                                             {{-12, -26, 45}, {-6, -12, 68}, 13},
                                             {{-6, -12, 68}, {10, 14, 72}, 12},
                                             {{10, 14, 72}, {20, 34, 54}, 11},
                                             {{20, 34, 54}, {16, 38, -60}, 10.5},
                                             {{16, 38, -60}, {8, 34, -140}, 9.5}}};

// Pulmonary arteries: a trunk and branches into both lungs.
constexpr int kPulmonaryPieces = 12;
const std::array<Tube, kPulmonaryPieces> kPulmonary{{{{14, -34, 5}, {14, -14, 34}, 11},
                                                     {{14, -14, 34}, {46, 6, 30}, 7},
                                                     {{14, -14, 34}, {-46, 6, 26}, 7.5},
                                                     {{46, 6, 30}, {74, -14, 62}, 4},
                                                     {{46, 6, 30}, {84, 16, 18}, 4.5},
                                                     {{46, 6, 30}, {72, 34, -34}, 4},
                                                     {{84, 16, 18}, {98, 6, -14}, 2.5},
                                                     {{-46, 6, 26}, {-76, -18, 60}, 4},
                                                     {{-46, 6, 26}, {-88, 14, 14}, 4.5},
                                                     {{-46, 6, 26}, {-74, 34, -30}, 4},
                                                     {{-88, 14, 14}, {-102, 2, -16}, 2.5},
                                                     {{-76, -18, 60}, {-88, -32, 82}, 2.5}}};

template <std::size_t n>
bool inAny(const std::array<Tube, n>& tubes, const dvec3& p) {
    return std::any_of(tubes.begin(), tubes.end(),
                       [&](const Tube& tube) { return toSegment(p, tube.from, tube.to) < tube.radiusMm; });
}

// A bone has a dense rim and a spongy core; `depth` is below 1 inside.
int bone(double depth, double core) {
    return depth < core ? kSpongiosa : kCortex;
}

// The value of the bone that p is in, 0 in no bone.
int boneHu(const dvec3& p) {
    // Vertebrae: bodies 22 mm high with 6 mm discs between, arch and spinous process behind, canal free.
    constexpr double kVertebraMm = 28.0;
    const double phase = std::abs(p.z / kVertebraMm - std::round(p.z / kVertebraMm)) * kVertebraMm;
    const double body = ellipse({p.x, p.y}, {0, 58}, {19, 16});
    if (body < 1.0) return phase < 11.0 ? bone(std::max(body, phase / 11.0), 0.86) : kDisc;
    const double canal = ellipse({p.x, p.y}, {0, 79}, {9, 7});
    const double arch = ellipse({p.x, p.y}, {0, 79}, {15, 12});
    if (phase < 8.0 && canal >= 1.0 && arch < 1.0) return kCortex;
    if (phase < 5.0 && std::abs(p.x) < 3.5 && p.y > 84 && p.y < 104) return kCortex;

    // Sternum: a wider manubrium above a narrower body, rounded at both ends.
    const double halfWidth = p.z > 62 ? 24.0 : 14.0;
    const double beyondEnd = std::max(std::abs(p.z - 20) - 60.0, 0.0) / 15.0;
    const double sternum = glm::length(dvec3(p.x / halfWidth, (p.y + 85) / 6.0, beyondEnd));
    if (sternum < 1.0) return bone(sternum, 0.7);

    // Ribs: rods along the chest wall, falling towards the front, open at the front below the sternum.
    constexpr double kRibPitchMm = 24.0;
    const double wall = ellipse({p.x, p.y}, {0, -2}, {124, 88});
    const double wallMm = (wall - 1.0) * 100.0;
    const double fallen = p.z - 0.32 * (p.y - 60.0);
    const double along = (fallen / kRibPitchMm - std::round(fallen / kRibPitchMm)) * kRibPitchMm;
    const bool within = p.z > -100 && p.z < 112 && (std::abs(p.x) > 22 || p.y > 0) && p.y < 82;
    const double rib = std::hypot(wallMm / 4.0, along / 6.0);
    if (within && rib < 1.0) return bone(rib, 0.55);
    return 0;
}

}  // namespace

dvec3 markerCentreMm() {
    return {128.0, -30.0, 60.0};
}

double markerHalfEdgeMm() {
    return 9.0;
}

int valueHu(const dvec3& p) {
    const dvec3 fromMarker = glm::abs(p - markerCentreMm());
    if (std::max({fromMarker.x, fromMarker.y, fromMarker.z}) < markerHalfEdgeMm()) return kMarker;

    const double skin = std::max(ellipse({p.x, p.y}, {0, 5}, {138, 104}), std::abs(p.z) / 132.0);
    if (!(skin < 1.0)) return kAir;  // written so that NaN is air
    if (const int hu = boneHu(p); hu != 0) return hu;
    if (inAny(kAorta, p)) return kContrast;

    const bool heart = ellipsoid(p, {26, -30, -20}, {46, 38, 46}) < 1.0;
    if (heart) {
        const bool leftVentricle = ellipsoid(p, {38, -24, -24}, {21, 17, 28}) < 1.0;
        const bool rightVentricle = ellipsoid(p, {4, -40, -18}, {15, 13, 26}) < 1.0;
        return leftVentricle ? kContrast : rightVentricle ? kPulmonaryContrast : kMyocardium;
    }
    if (inAny(kPulmonary, p)) return kPulmonaryContrast;

    // The diaphragm stands higher on the right, over the liver.
    if (ellipsoid(p, {-52, -6, -92}, {66, 68, 56}) < 1.0) return kLiver;
    if (ellipsoid(p, {64, 2, 0}, {48, 70, 100}) < 1.0) return kLung;
    if (ellipsoid(p, {-66, 2, 6}, {48, 72, 104}) < 1.0) return kLung;
    return skin < 0.93 ? kMuscle : kFat;
}

glm::dmat4 worldFromVoxel(const Options& options) {
    const glm::dmat4 identity(1.0);
    glm::dmat4 tilt = identity;
    for (int axis = 0; axis < 3; ++axis) {
        dvec3 direction(0.0);
        direction[axis] = 1.0;
        tilt = glm::rotate(identity, glm::radians(options.tiltDeg[axis]), direction) * tilt;
    }
    const glm::dmat4 scale = glm::scale(identity, options.spacingMm);
    const glm::dmat4 centre = glm::translate(identity, -0.5 * (dvec3(options.size) - 1.0));
    return tilt * scale * centre;
}

Volume make(const Options& options) {
    const glm::ivec3 size = options.size;
    const glm::dmat4 toWorld = worldFromVoxel(options);
    std::vector<std::uint16_t> voxels(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    parallelFor(std::size_t(size.z), [&](std::size_t k) {
        std::uint16_t* out = voxels.data() + k * std::size_t(size.x) * std::size_t(size.y);
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i) {
                const int hu = valueHu(transformPoint(toWorld, {i, j, double(k)}));
                *out++ = static_cast<std::uint16_t>(hu + kUnitsOffset);
            }
        }
    });
    auto volume = Volume::create({.size = size,
                                  .worldFromVoxel = toWorld,
                                  .unitsFromStored = {.slope = 1.0, .intercept = -kUnitsOffset},
                                  .unit = Unit::hounsfield,
                                  .modality = "CT",
                                  .padding = {},
                                  .provenance = {.studyInstanceUid = "2.25.299792458.1",
                                                 .seriesInstanceUid = "2.25.299792458.2",
                                                 .description = "Macula phantom",
                                                 .assumptions = {}}},
                                 std::move(voxels));
    return std::move(volume).value();
}

}  // namespace macula::phantom
