// The walk through the bricks, alone: its segments never overlap, never go back, and miss no matter.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "pipeline/trace/reference_tracer.h"
#include "trace/scenes.h"

namespace macula::trace {
namespace {

struct Grid {
    std::shared_ptr<const Volume> volume;
    Medium medium;
    BrickGrid bricks;
    shared::TraceParams params;
    ReferenceTracer tracer;
};

Grid makeGrid(glm::ivec3 size, const glm::dmat4& toWorld, unsigned oneIn) {
    std::mt19937 random(oneIn);
    const auto volume =
        scenes::volumeOf(size, toWorld, [&](int, int, int) { return std::uint16_t(random() % oneIn == 0); });
    const BrickGrid bricks = makeBrickGrid(*volume);
    const Medium medium = makeMedium(*volume, bricks, scenes::homogeneous(2.0));
    const Environment sky = Environment::constant(glm::vec3(1.0f));
    const auto params = makeTraceParams(*volume, medium, sky, {.camera = {}, .width = 4, .height = 4}, {});
    return {volume, medium, bricks, *params, ReferenceTracer(*volume, medium, sky)};
}

// Walks a ray and checks what it visits against 4000 points along it.
void checkRay(const Grid& grid, Precision precision, const glm::dvec3& originVoxel,
              const glm::dvec3& worldDirection) {
    const auto segments = grid.tracer.segments(grid.params, precision, originVoxel, worldDirection);
    double last = 0.0;
    for (const auto& segment : segments) {
        ASSERT_GE(segment.beginMm, last);
        ASSERT_GE(segment.endMm, segment.beginMm);  // where a ray runs along a face, empty ones occur
        ASSERT_GT(segment.majorantPerMm, 0.0);
        last = segment.endMm;
    }
    const glm::dvec3 perMm = glm::inverse(glm::dmat3(grid.volume->worldFromVoxel())) * worldDirection;
    const double reach = glm::length(glm::dvec3(grid.volume->size())) / glm::length(perMm) +
                         glm::length(originVoxel) / glm::length(perMm);
    const double tolerance = (precision == Precision::single ? 2e-4 : 1e-9) * reach;
    std::size_t at = 0;
    for (int i = 0; i < 4000; ++i) {
        const double mm = reach * (i + 0.5) / 4000;
        const glm::dvec3 p = originVoxel + mm * perMm;
        const glm::dvec3 size(grid.volume->size());
        if (glm::any(glm::lessThan(p, glm::dvec3(0.0))) || glm::any(glm::greaterThanEqual(p, size))) continue;
        const glm::ivec3 brick = grid.bricks.brickAt(p);
        const float bound = grid.medium.bounds[grid.bricks.index(brick.x, brick.y, brick.z)];
        if (!(bound > 0.0f)) continue;
        while (at < segments.size() && segments[at].endMm + tolerance < mm) ++at;
        ASSERT_LT(at, segments.size()) << "matter at " << mm << " mm was never visited";
        ASSERT_LE(segments[at].beginMm - tolerance, mm) << "matter at " << mm << " mm was passed over";
    }
}

class BrickWalk : public ::testing::TestWithParam<Precision> {};

TEST_P(BrickWalk, MissesNoMatterOnRandomRays) {
    const glm::dmat4 oblique = affine({0.7, 0.1, 0}, {-0.1, 0.7, 0.2}, {0, 0.3, 2.5}, {100, -50, 20});
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    for (const unsigned oneIn : {2000u, 100u, 1u}) {
        const Grid grid = makeGrid({70, 45, 33}, oblique, oneIn);
        for (int ray = 0; ray < 200; ++ray) {
            const glm::dvec3 direction =
                glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
            const glm::dvec3 target{random() % 70, random() % 45, random() % 33};
            const glm::dvec3 perMm = glm::inverse(glm::dmat3(oblique)) * direction;
            const double back = std::uniform_real_distribution<double>(0, 200)(random);
            checkRay(grid, GetParam(), target - back * perMm, direction);
        }
    }
}

TEST_P(BrickWalk, MissesNoMatterAlongAxesFacesEdgesAndDiagonals) {
    const Grid grid = makeGrid({40, 40, 40}, glm::dmat4(1.0), 500);
    const double s = std::sqrt(0.5);
    for (const glm::dvec3 direction : {glm::dvec3(1, 0, 0),
                                       {-1, 0, 0},
                                       {0, 1, 0},
                                       {0, -1, 0},
                                       {0, 0, 1},
                                       {0, 0, -1},
                                       {s, s, 0},
                                       {-s, 0, s},
                                       glm::normalize(glm::dvec3(1, 1, 1)),
                                       glm::normalize(glm::dvec3(-1, -1, -1)),
                                       glm::normalize(glm::dvec3(1, 1e-7, 0))}) {
        for (const double offset : {0.0, 8.0, 4.0, 12.5, 24.0}) {
            const glm::dvec3 through{offset, offset, offset};
            checkRay(grid, GetParam(), through - 64.0 * direction, direction);
            checkRay(grid, GetParam(), through, direction);  // from within, on a corner
        }
    }
}

TEST_P(BrickWalk, AMissHasNoSegments) {
    const Grid grid = makeGrid({16, 16, 16}, glm::dmat4(1.0), 1);
    EXPECT_TRUE(grid.tracer.segments(grid.params, GetParam(), {-5, 8, 8}, {-1, 0, 0}).empty());
    EXPECT_TRUE(grid.tracer.segments(grid.params, GetParam(), {-5, 20, 8}, {1, 0, 0}).empty());
    EXPECT_EQ(grid.tracer.segments(grid.params, GetParam(), {-5, 8, 8}, {1, 0, 0}).size(), 3u);
}

TEST_P(BrickWalk, ReachesAVolumeFromFarAway) {
    const Grid grid = makeGrid({16, 16, 16}, glm::dmat4(1.0), 1);
    const auto segments = grid.tracer.segments(grid.params, GetParam(), {-10000, 8, 8}, {1, 0, 0});
    ASSERT_EQ(segments.size(), 3u);
    EXPECT_NEAR(segments.front().beginMm, 10000, 0.01);
    EXPECT_NEAR(segments.back().endMm, 10016, 0.01);
}

// Narrow bands of values anywhere: what a bound over the corners alone would miss.
TransferFunction bands(std::mt19937& random) {
    TransferFunction f;
    f.name = "bands";
    f.colour = {{0, {1, 1, 1}}};
    std::uniform_real_distribution<double> value(400, 3500);
    std::vector<double> values(12);
    for (double& v : values) v = value(random);
    std::sort(values.begin(), values.end());
    for (std::size_t i = 0; i < values.size(); ++i)
        f.opacity.push_back(
            {values[i], i % 3 == 1 ? std::uniform_real_distribution<double>(0, 1)(random) : 0.0});
    return f;
}

double extinctionAt(const Volume& volume, const Medium& medium, double lowEntry, const glm::dvec3& p) {
    const glm::dvec3 last(volume.size() - 1);
    const glm::dvec3 q = glm::clamp(p - 0.5, glm::dvec3(0.0), last);
    const glm::ivec3 low(q);
    double value = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 bit(corner & 1, corner >> 1 & 1, corner >> 2);
        const glm::ivec3 at = glm::min(low + bit, volume.size() - 1);
        const glm::dvec3 far = q - glm::dvec3(low);
        const glm::dvec3 weight = glm::mix(1.0 - far, far, glm::dvec3(bit));
        value += weight.x * weight.y * weight.z * volume.stored(at.x, at.y, at.z);
    }
    const double entry = value - lowEntry;
    const auto below = static_cast<std::size_t>(entry);
    return std::lerp(double(medium.extinctionPerMm[below]), double(medium.extinctionPerMm[below + 1]),
                     entry - double(below));
}

// A tracer takes what is above the bound for as much as the bound (min in shaders/lib/path.glsl), and a
// broken bound would show nowhere but in the light. So it is looked for here: inside a segment no extinction
// is above its majorant.
TEST_P(BrickWalk, NoMajorantIsBelowTheExtinctionOnItsSegment) {
    const glm::dmat4 oblique = affine({0.7, 0.1, 0}, {-0.1, 0.7, 0.2}, {0, 0.3, 2.5}, {100, -50, 20});
    std::mt19937 random(6);
    std::normal_distribution<double> normal;
    // Few values in a brick, others in the next: what lies beyond a segment is soon above its bound.
    const auto volume = scenes::volumeOf({37, 26, 19}, oblique, [&](int i, int j, int k) {
        return static_cast<std::uint16_t>(500 + 50 * i + 25 * j + 20 * k + int(random() % 20));
    });
    const BrickGrid bricks = makeBrickGrid(*volume);
    const double lowEntry = entryMapOf(*volume).low;
    const Environment sky = Environment::constant(glm::vec3(1.0f));
    const glm::dmat3 perMm = glm::inverse(glm::dmat3(volume->worldFromVoxel()));
    std::size_t points = 0;
    std::size_t broken = 0;
    double tightest = 0.0;
    for (int curve = 0; curve < 8; ++curve) {
        const Medium medium = makeMedium(*volume, bricks, bands(random));
        const auto params =
            makeTraceParams(*volume, medium, sky, {.camera = {}, .width = 4, .height = 4}, {});
        const ReferenceTracer tracer(*volume, medium, sky);
        for (int ray = 0; ray < 150; ++ray) {
            const glm::dvec3 direction =
                glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
            const glm::dvec3 target{random() % 37, random() % 26, random() % 19};
            const glm::dvec3 step = perMm * direction;
            const glm::dvec3 origin = target - 60.0 * step;
            // Where rounding leaves the end of a segment.
            const double slackMm = GetParam() == Precision::single ? 1e-4 : 1e-9;
            for (const auto& segment : tracer.segments(*params, GetParam(), origin, direction)) {
                const double length = segment.endMm - segment.beginMm - 2.0 * slackMm;
                for (int i = 0; i < 20 && length > 0.0; ++i) {
                    const double mm = segment.beginMm + slackMm + length * (i + 0.5) / 20;
                    const double share =
                        extinctionAt(*volume, medium, lowEntry, origin + mm * step) / segment.majorantPerMm;
                    ++points;
                    broken += share > 1.0 + 1e-6 ? 1 : 0;
                    tightest = std::max(tightest, share);
                }
            }
        }
    }
    EXPECT_GT(points, 50'000u);
    EXPECT_EQ(broken, 0u) << "of " << points << ", at worst " << tightest << " times the bound";
    EXPECT_GT(tightest, 0.97);  // the bound is not merely large
}

INSTANTIATE_TEST_SUITE_P(Precisions, BrickWalk, ::testing::Values(Precision::single, Precision::twofold),
                         [](const auto& p) { return p.param == Precision::single ? "Float" : "Double"; });

}  // namespace
}  // namespace macula::trace
