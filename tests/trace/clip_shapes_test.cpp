// Each shape that a clip can have, from the list of them, against its definition point by point.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "pipeline/trace/reference_tracer.h"
#include "pipeline/volume/clip_json.h"
#include "trace/clips.h"
#include "trace/scenes.h"

namespace macula::trace {
namespace {

const glm::dmat4 kOblique = affine({0.8, 0.1, 0.0}, {-0.2, 1.1, 0.3}, {0.1, -0.4, 2.5}, {40.0, -70.0, 300.0});
const glm::ivec3 kSize(30, 40, 20);

std::shared_ptr<const Volume> solid() {
    static const auto volume =
        scenes::volumeOf(kSize, kOblique, [](int, int, int) { return std::uint16_t(1); });
    return volume;
}

// A clip of this shape alone.
template <class Shape>
Clip clipOf(const Shape& shape, Keep keepIt) {
    Clip clip;
    forEachPart(clip, [&](auto& part, auto&& keep) {
        using Part = std::remove_cvref_t<decltype(part)>;
        if constexpr (std::is_same_v<typename Part::value_type, Shape>) {
            part = Part{shape};
            if constexpr (Shape::kHasKeep) keep = keepIt;
        }
    });
    return clip;
}

// Calls visit(shape, keep) for many shapes of each kind around the volume.
template <class Visit>
void forManyShapes(std::uint32_t seed, int trials, const Visit& visit) {
    scenes::Chance chance(seed);
    std::map<std::string_view, int> seen;
    for (int trial = 0; trial < trials; ++trial) {
        SCOPED_TRACE(trial);
        const Clip clip = scenes::anyClip(chance, solid()->worldBox());
        forEachShape(clip, [&](const ClipShape auto& shape, Keep keep) {
            SCOPED_TRACE(shape.kKey);
            ++seen[shape.kKey];
            visit(chance, shape, keep);
        });
    }
    const Clip any;
    forEachPart(any, [&](const auto& part, Keep) {
        using Shape = typename std::remove_cvref_t<decltype(part)>::value_type;
        EXPECT_GT(seen[Shape::kKey], trials / 10) << Shape::kKey << ": clips.h makes none";
    });
}

TEST(ClipShapes, ContainAllOrNothingOfABoxOnlyWhereTheyContainSoManyOfItsPoints) {
    std::map<std::string, int> found;
    forManyShapes(21, 400, [&](scenes::Chance& chance, const ClipShape auto& shape, Keep keep) {
        const glm::dvec3 low(chance.between(0, 24), chance.between(0, 34), chance.between(0, 14));
        const Box brick{low, low + 4.0};
        BoxCorners corners = cornersOf(brick);
        for (glm::dvec3& corner : corners) corner = transformPoint(kOblique, corner);
        const bool all = containsAll(shape, corners);
        const bool none = containsNone(shape, corners);
        EXPECT_FALSE(all && none);
        found[std::string(shape.kKey) + (all ? " all" : none ? " none" : " some")] += 1;
        const Clip clip = clipOf(shape, keep);
        EXPECT_EQ(removesAll(clip, kOblique, brick), keep == Keep::inside ? none : all);
        EXPECT_EQ(removesNothing(clip, kOblique, brick), keep == Keep::inside ? all : none);
        for (int i = 0; i < 200; ++i) {
            const glm::dvec3 point = transformPoint(kOblique, chance.inBox(brick));
            const bool isInside = contains(shape, point);
            ASSERT_EQ(shows(clip, point), isInside == (keep == Keep::inside));
            ASSERT_FALSE(all && !isInside);
            ASSERT_FALSE(none && isInside);
        }
    });
    const Clip any;
    forEachPart(any, [&](const auto& part, Keep) {
        const std::string key(std::remove_cvref_t<decltype(part)>::value_type::kKey);
        EXPECT_GT(found[key + " all"], 0) << key;
        EXPECT_GT(found[key + " none"], 0) << key;
    });
}

glm::dvec3 nearestTo(const glm::dvec3& mm, const HalfSpace& plane) {
    return mm + (plane.offsetMm - glm::dot(plane.normal, mm)) * plane.normal;
}

TEST(ClipShapes, AreTheSameAfterWritingAndReading) {
    const Box all = solid()->worldBox();
    forManyShapes(22, 100, [&](scenes::Chance&, auto shape, Keep keep) {
        using Shape = decltype(shape);
        if constexpr (std::is_same_v<Shape, OrientedBox>)
            shape.axes = glm::dmat3(1.0);  // others are not written
        ClipPreset preset{.name = "one", .title = "One", .clip = clipOf(shape, keep), .planesAt = {}};
        shapesToFractions(preset.clip, all);
        if constexpr (std::is_same_v<Shape, HalfSpace>)
            preset.planesAt.push_back((nearestTo(all.centre(), shape) - all.low) / (all.high - all.low));
        const auto read = clipPresetFromJson(toJson(preset), "it");
        ASSERT_TRUE(read) << read.error().message;
        const Clip again = clipFor(*read, *solid());
        int count = 0;
        forEachShape(again, [&](const ClipShape auto& same, Keep sameKeep) {
            EXPECT_EQ(sameKeep, keep);
            EXPECT_EQ(same.kKey, shape.kKey);
            ASSERT_EQ(same.numbers().size(), shape.numbers().size());
            for (std::size_t i = 0; i < same.numbers().size(); ++i)
                EXPECT_NEAR(same.numbers()[i], shape.numbers()[i], 1e-9) << i;
            ++count;
        });
        EXPECT_EQ(count, 1);
    });
}

// What a shape is made of tells it from any other, or two clips would have one digest.
TEST(ClipShapes, AreMadeOfTheirNumbers) {
    std::map<std::vector<double>, int> seen;
    int all = 0;
    forManyShapes(23, 100, [&](scenes::Chance&, const ClipShape auto& shape, Keep) {
        EXPECT_TRUE(shape.check());
        EXPECT_GT(shape.numbers().size(), 3u);
        seen[shape.numbers()] += 1;
        ++all;
    });
    EXPECT_EQ(int(seen.size()), all);
}

// The spans of a ray, by the shader in C++, end where the points of the shape do.
TEST(ClipShapes, SpansOfRaysAreWhereTheirPointsAre) {
    const auto volume = solid();
    const Environment sky = Environment::constant(glm::vec3(1.0f));
    constexpr double kPerMm = 0.05;
    constexpr double kFar = 400.0;
    constexpr int kSteps = 8000;
    constexpr std::uint32_t kSamples = 2000;
    forManyShapes(24, 60, [&](scenes::Chance& chance, const ClipShape auto& shape, Keep keep) {
        const Clip clip = clipOf(shape, keep);
        const Medium medium = makeMedium(*volume, makeBrickGrid(*volume), scenes::homogeneous(kPerMm), clip);
        const auto params = makeTraceParams(*volume, medium, sky, {}, {.seed = 3}, clip);
        ASSERT_TRUE(params) << params.error().message;
        const glm::dvec3 direction = chance.direction();
        const glm::dvec3 origin = chance.inBox(volume->worldBox()) - direction * (0.5 * kFar);
        const glm::dmat4 voxelFromWorld = glm::inverse(kOblique);
        int shown = 0;
        for (int i = 0; i < kSteps; ++i) {
            const glm::dvec3 point = origin + direction * (kFar * (i + 0.5) / kSteps);
            const glm::dvec3 voxel = transformPoint(voxelFromWorld, point) + 0.5;
            const bool isInVolume = glm::all(glm::greaterThanEqual(voxel, glm::dvec3(0.0))) &&
                                    glm::all(glm::lessThanEqual(voxel, glm::dvec3(kSize)));
            shown += isInVolume && contains(shape, point) == (keep == Keep::inside) ? 1 : 0;
        }
        const double exact = std::exp(-kPerMm * kFar * shown / kSteps);
        const auto moments =
            ReferenceTracer(*volume, medium, sky)
                .transmittance(*params, Filter::stochastic, Precision::twofold,
                               transformPoint(voxelFromWorld, origin) + 0.5, direction, kSamples);
        EXPECT_NEAR(moments.sum / kSamples, exact, 5.0 * std::sqrt(exact * (1 - exact) / kSamples) + 5e-3);
    });
}

}  // namespace
}  // namespace macula::trace
