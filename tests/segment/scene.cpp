#include "scene.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/parallel.h"

namespace macula::segment::test {

namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kBottomMm = 70.0;  // y of the deepest point of the person
constexpr double kSheetMm = 2.5;
constexpr double kMattressMm = 30.0;
constexpr double kTableWidthMm = 400.0;

double ellipse(const dvec2& p, const dvec2& centre, const dvec2& radii) {
    return glm::length((p - centre) / radii);
}

// HU of the person, or NaN beside them. x to the left, y down to the table.
double personHu(const Scene& scene, const dvec3& world) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const bool side = scene.lying == Lying::onTheSide;
    const double halfHeight = side ? 130.0 : 95.0;
    const dvec2 p(world.x, world.y - (kBottomMm - halfHeight + scene.sunkMm));
    if (scene.body == Body::legs) {
        for (const double x : {-85.0, 85.0}) {
            const dvec2 leg(x, halfHeight - 60.0);
            if (ellipse(p, leg, dvec2(60.0 + 0.05 * world.z, 60.0)) > 1.0) continue;
            return glm::length(p - leg) < 14.0 ? 900.0 : glm::length(p - leg) < 45.0 ? 60.0 : -100.0;
        }
        return kNone;
    }
    // In the trunk's own axes: the back at +y.
    dvec2 own = p;
    if (scene.lying == Lying::prone) own = -p;
    if (side) own = dvec2(-p.y, p.x);
    const double skin = ellipse(own, {0, 0}, {130.0 + 0.08 * world.z, 95});
    if (scene.body == Body::trunkWithArms && !side) {
        for (const double x : {-165.0, 165.0}) {
            const dvec2 arm(x, 40.0);
            if (glm::length(p - arm) < 28.0) return glm::length(p - arm) < 9.0 ? 900.0 : 40.0;
        }
    }
    if (skin > 1.0) return kNone;
    if (glm::length(own - dvec2(0, 55)) < 20.0) return 400.0;
    if (ellipse(own, {62, -5}, {45, 60}) < 1.0 || ellipse(own, {-62, -5}, {45, 60}) < 1.0)
        return ellipse(own, {60, 0}, {4, 4}) < 1.0 ? 30.0 : -850.0;
    return skin > 0.93 ? -100.0 : 50.0;
}

// y of the upper face of whatever lies below the person at x.
double topMm(const Scene& scene, double x) {
    const double u = x / (0.5 * kTableWidthMm);
    return kBottomMm + scene.gapMm - scene.bowlMm * u * u;
}

}  // namespace

Made make(const Scene& scene) {
    const glm::ivec3 size = scene.size;
    glm::dmat4 toWorld = scene.worldFromVoxel;
    if (toWorld == glm::dmat4(1.0)) {
        toWorld =
            affine({1.3, 0, 0}, {0, 1.3, 0}, {0, 0, 2.5}, -0.5 * dvec3(size - 1) * dvec3(1.3, 1.3, 2.5));
    }
    const std::size_t slice = std::size_t(size.x) * std::size_t(size.y);
    const std::size_t count = slice * std::size_t(size.z);
    std::vector<std::uint16_t> voxels(count);
    std::vector<std::uint8_t> person(count);
    std::vector<std::uint8_t> table(count);
    parallelFor(std::size_t(size.z), [&](std::size_t k) {
        std::uint32_t noise = 12345u + 7919u * std::uint32_t(k);
        std::size_t at = k * slice;
        for (int j = 0; j < size.y; ++j) {
            for (int i = 0; i < size.x; ++i, ++at) {
                const dvec3 world = transformPoint(toWorld, {i, j, double(k)});
                double hu = -1000.0;
                const double below = world.y - topMm(scene, world.x);
                const bool overTable = scene.table && std::abs(world.x) < 0.5 * kTableWidthMm;
                const double sheets = below - (scene.foamHu > -1000.0 ? kMattressMm : 0.0);
                if (overTable && below >= 0.0 && sheets < 0.0) {
                    hu = scene.foamHu;
                    table[at] = hu > -200.0 ? 1 : 0;
                } else if (overTable && sheets >= 0.0 && sheets < 45.0 + kSheetMm) {
                    const bool sheet = sheets < kSheetMm || sheets >= 45.0;
                    hu = sheet ? 80.0 : -930.0;
                    table[at] = sheet ? 1 : 0;
                } else if (const double body = personHu(scene, world);
                           !std::isnan(body) && (below < 0.0 || !scene.table)) {
                    hu = body;
                    person[at] = 1;
                }
                noise = noise * 1664525u + 1013904223u;
                hu += double(noise >> 24u) / 255.0 * 60.0 - 30.0;
                voxels[at] = static_cast<std::uint16_t>(std::max(0.0, std::round(hu + 1024.0)));
            }
        }
    });
    auto volume = Volume::create({.size = size,
                                  .worldFromVoxel = toWorld,
                                  .unitsFromStored = {1.0, -1024.0},
                                  .unit = Unit::hounsfield,
                                  .modality = "CT",
                                  .padding = {},
                                  .provenance = {}},
                                 std::move(voxels));
    return {std::move(*volume), std::move(person), std::move(table)};
}

PatientMask find(const Volume& volume) {
    Progress progress;
    auto found = findPatient(volume, progress);
    if (!found) {
        ADD_FAILURE() << found.error().message;
        std::abort();
    }
    return std::move(*found);
}

double dice(const Made& made, const PatientMask& found) {
    std::size_t both = 0;
    std::size_t sum = 0;
    const auto labels = found.map.labels();
    const auto voxels = made.volume.voxels();
    for (std::size_t n = 0; n < labels.size(); ++n) {
        const bool person = made.person[n] != 0;
        const bool kept = labels[n] == PatientMask::kPatient && (person || voxels[n] > 524);
        both += person && kept ? 2 : 0;
        sum += (person ? 1u : 0u) + (kept ? 1u : 0u);
    }
    return double(both) / double(sum);
}

double tableRemoved(const Made& made, const PatientMask& found) {
    std::size_t all = 0;
    std::size_t removed = 0;
    const auto labels = found.map.labels();
    for (std::size_t n = 0; n < labels.size(); ++n) {
        if (made.table[n] == 0) continue;
        ++all;
        removed += labels[n] == 0 ? 1 : 0;
    }
    return double(removed) / double(all);
}

}  // namespace macula::segment::test
