#include "base/phantom.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

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

struct Ellipsoid {
    dvec3 centre, radii;
};
const Ellipsoid kHeart{{26, -30, -20}, {46, 38, 46}};
const Ellipsoid kLeftVentricle{{38, -24, -24}, {21, 17, 28}};
const Ellipsoid kRightVentricle{{4, -40, -18}, {15, 13, 26}};
// The diaphragm stands higher on the right, over the liver.
const Ellipsoid kLiverShape{{-52, -6, -92}, {66, 68, 56}};
const Ellipsoid kLeftLung{{64, 2, 0}, {48, 70, 100}};
const Ellipsoid kRightLung{{-66, 2, 6}, {48, 72, 104}};

bool inside(const Ellipsoid& shape, const dvec3& p) {
    return glm::length((p - shape.centre) / shape.radii) < 1.0;
}

// The distance from the centre of an ellipse, in radii: below 1 inside.
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

// The aorta: up from the heart, over the arch to the left and back, down in front of the spine.
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

// Ellipses that several functions use: the skin, and the middle of the ribs.
const dvec2 kSkinCentre{0, 5};
const dvec2 kSkinRadii{138, 104};
constexpr double kSkinHalfHeightMm = 132.0;
constexpr double kFatBeyond = 0.93;  // beyond this part of the way to the skin there is fat
const dvec2 kWallCentre{0, -2};
const dvec2 kWallRadii{124, 88};
constexpr double kRibsWithin = 0.96;  // within this part of the way to the wall there is no rib

// Bounding boxes of the bones.
constexpr double kEverywhere = 1e9;
const Box kSpineBox{{-19, 42, -kEverywhere}, {19, 104, kEverywhere}};
const Box kSternumBox{{-24, -91, -55}, {24, -79, 95}};
const Box kRibsBox{{-130, -94, -100}, {130, 82, 112}};

Box boxAround(const dvec3& centre, const dvec3& halfSize) {
    return {centre - halfSize, centre + halfSize};
}
Box boxOf(const Ellipsoid& shape) {
    return boxAround(shape.centre, shape.radii);
}
Box boxOf(const Tube& tube) {
    return {glm::min(tube.from, tube.to) - tube.radiusMm, glm::max(tube.from, tube.to) + tube.radiusMm};
}
bool meet(const Box& a, const Box& b) {
    return glm::all(glm::lessThanEqual(a.low, b.high)) && glm::all(glm::lessThanEqual(b.low, a.high));
}
// The maximum of ellipse() in a box: the function is convex, so its maximum is at a corner.
double farthest(const Box& box, const dvec2& centre, const dvec2& radii) {
    const dvec2 fromCentre = glm::max(glm::abs(dvec2(box.low) - centre), glm::abs(dvec2(box.high) - centre));
    return glm::length(fromCentre / radii);
}

// The structures that a point may be in. nearTo rules structures out for a whole block of voxels, which then
// need not be tested for each voxel.
struct Near {
    bool marker = true;
    bool body = true;
    bool rim = true;  // fat, skin and air; false: whatever is not an organ is muscle
    bool spine = true;
    bool sternum = true;
    bool ribs = true;
    bool heart = true;
    bool liver = true;
    bool leftLung = true;
    bool rightLung = true;
    std::uint32_t aorta = ~0u;  // a bit for each piece
    std::uint32_t pulmonary = ~0u;
};

template <std::size_t n>
std::uint32_t piecesIn(const std::array<Tube, n>& tubes, const Box& box) {
    std::uint32_t pieces = 0;
    for (std::size_t i = 0; i < n; ++i) pieces |= meet(boxOf(tubes[i]), box) ? 1u << i : 0u;
    return pieces;
}

Near nearTo(const Box& box) {
    const double outwards = std::max(std::abs(box.low.z), std::abs(box.high.z)) / kSkinHalfHeightMm;
    return {.marker = meet(box, boxAround(markerCentreMm(), dvec3(markerHalfEdgeMm()))),
            .body = meet(box, boxAround(dvec3(kSkinCentre, 0.0), dvec3(kSkinRadii, kSkinHalfHeightMm))),
            .rim = std::max(farthest(box, kSkinCentre, kSkinRadii), outwards) >= kFatBeyond,
            .spine = meet(box, kSpineBox),
            .sternum = meet(box, kSternumBox),
            .ribs = meet(box, kRibsBox) && farthest(box, kWallCentre, kWallRadii) >= kRibsWithin,
            .heart = meet(box, boxOf(kHeart)),
            .liver = meet(box, boxOf(kLiverShape)),
            .leftLung = meet(box, boxOf(kLeftLung)),
            .rightLung = meet(box, boxOf(kRightLung)),
            .aorta = piecesIn(kAorta, box),
            .pulmonary = piecesIn(kPulmonary, box)};
}

template <std::size_t n>
bool inAny(const std::array<Tube, n>& tubes, std::uint32_t pieces, const dvec3& p) {
    for (std::size_t i = 0; i < n; ++i) {
        const Tube& tube = tubes[i];
        if (((pieces >> i) & 1u) != 0 && toSegment(p, tube.from, tube.to) < tube.radiusMm) return true;
    }
    return false;
}

// A bone has a dense rim and a spongy core; `depth` is below 1 inside.
int bone(double depth, double core) {
    return depth < core ? kSpongiosa : kCortex;
}

// Each of these functions returns 0 outside its bones. Vertebrae: bodies 22 mm high with 6 mm discs between,
// arch and spinous process behind, canal free.
int spineHu(const dvec3& p) {
    constexpr double kVertebraMm = 28.0;
    const double phase = std::abs(p.z / kVertebraMm - std::round(p.z / kVertebraMm)) * kVertebraMm;
    const double body = ellipse({p.x, p.y}, {0, 58}, {19, 16});
    if (body < 1.0) return phase < 11.0 ? bone(std::max(body, phase / 11.0), 0.86) : kDisc;
    const double canal = ellipse({p.x, p.y}, {0, 79}, {9, 7});
    const double arch = ellipse({p.x, p.y}, {0, 79}, {15, 12});
    if (phase < 8.0 && canal >= 1.0 && arch < 1.0) return kCortex;
    if (phase < 5.0 && std::abs(p.x) < 3.5 && p.y > 84 && p.y < 104) return kCortex;
    return 0;
}

// A wider manubrium above a narrower body, rounded at both ends.
int sternumHu(const dvec3& p) {
    const double halfWidth = p.z > 62 ? 24.0 : 14.0;
    const double beyondEnd = std::max(std::abs(p.z - 20) - 60.0, 0.0) / 15.0;
    const double sternum = glm::length(dvec3(p.x / halfWidth, (p.y + 85) / 6.0, beyondEnd));
    return sternum < 1.0 ? bone(sternum, 0.7) : 0;
}

// Rods along the chest wall, sloping down towards the front, open at the front below the sternum.
int ribHu(const dvec3& p) {
    constexpr double kRibPitchMm = 24.0;
    const double wall = ellipse({p.x, p.y}, kWallCentre, kWallRadii);
    const double wallMm = (wall - 1.0) * 100.0;
    const double fallen = p.z - 0.32 * (p.y - 60.0);
    const double along = (fallen / kRibPitchMm - std::round(fallen / kRibPitchMm)) * kRibPitchMm;
    const bool within = p.z > -100 && p.z < 112 && (std::abs(p.x) > 22 || p.y > 0) && p.y < 82;
    const double rib = std::hypot(wallMm / 4.0, along / 6.0);
    return within && rib < 1.0 ? bone(rib, 0.55) : 0;
}

int boneHu(const dvec3& p, const Near& near) {
    int hu = near.spine ? spineHu(p) : 0;
    if (hu == 0 && near.sternum) hu = sternumHu(p);
    if (hu == 0 && near.ribs) hu = ribHu(p);
    return hu;
}

// Right if the point is in no structures other than those that `near` has.
int valueHu(const dvec3& p, const Near& near) {
    const dvec3 fromMarker = glm::abs(p - markerCentreMm());
    if (near.marker && std::max({fromMarker.x, fromMarker.y, fromMarker.z}) < markerHalfEdgeMm())
        return kMarker;

    if (!near.body) return kAir;
    const double skin =
        near.rim ? std::max(ellipse({p.x, p.y}, kSkinCentre, kSkinRadii), std::abs(p.z) / kSkinHalfHeightMm)
                 : 0.0;
    if (!(skin < 1.0)) return kAir;  // written so that NaN is air
    if (const int hu = boneHu(p, near); hu != 0) return hu;
    if (inAny(kAorta, near.aorta, p)) return kContrast;

    if (near.heart && inside(kHeart, p)) {
        return inside(kLeftVentricle, p)    ? kContrast
               : inside(kRightVentricle, p) ? kPulmonaryContrast
                                            : kMyocardium;
    }
    if (inAny(kPulmonary, near.pulmonary, p)) return kPulmonaryContrast;
    if (near.liver && inside(kLiverShape, p)) return kLiver;
    if (near.leftLung && inside(kLeftLung, p)) return kLung;
    if (near.rightLung && inside(kRightLung, p)) return kLung;
    return skin < kFatBeyond ? kMuscle : kFat;
}

constexpr int kBlockVoxels = 8;  // along each side

void fillBlock(const glm::ivec3& block, const glm::ivec3& size, const glm::dmat4& toWorld,
               std::vector<std::uint16_t>& voxels) {
    const glm::ivec3 low = block * kBlockVoxels;
    const glm::ivec3 end = glm::min(low + kBlockVoxels, size);
    constexpr double kRoundingMm = 1e-6;
    Box box{dvec3(kEverywhere), dvec3(-kEverywhere)};
    for (const dvec3& corner : cornersOf({dvec3(low), dvec3(end - 1)})) {
        const dvec3 p = transformPoint(toWorld, corner);
        box = {glm::min(box.low, p - kRoundingMm), glm::max(box.high, p + kRoundingMm)};
    }
    const Near near = nearTo(box);
    for (int k = low.z; k < end.z; ++k) {
        for (int j = low.y; j < end.y; ++j) {
            std::uint16_t* out =
                voxels.data() + (std::size_t(k) * std::size_t(size.y) + std::size_t(j)) * std::size_t(size.x);
            for (int i = low.x; i < end.x; ++i) {
                const int hu = valueHu(transformPoint(toWorld, dvec3(i, j, k)), near);
                out[i] = static_cast<std::uint16_t>(hu + kUnitsOffset);
            }
        }
    }
}

}  // namespace

dvec3 markerCentreMm() {
    return {128.0, -30.0, 60.0};
}

double markerHalfEdgeMm() {
    return 9.0;
}

int valueHu(const dvec3& p) {
    return valueHu(p, Near{});
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
    const glm::ivec3 blocks = (size + (kBlockVoxels - 1)) / kBlockVoxels;
    parallelFor(std::size_t(blocks.y) * std::size_t(blocks.z), [&](std::size_t row) {
        for (int i = 0; i < blocks.x; ++i)
            fillBlock({i, int(row) % blocks.y, int(row) / blocks.y}, size, toWorld, voxels);
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
