// Two volumes and coloured segments in one picture, in double, where the answer is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "trace/mixed_scenes.h"

namespace macula::trace {
namespace {

const Environment kSky = Environment::constant(glm::vec3(1.0f));

struct Mixed {
    Mixed(const Volume& volume, const TransferFunction& function, const Additions& added, const View& view,
          const Settings& settings = {})
        : grid(makeBrickGrid(volume)),
          medium(makeMedium(volume, grid, function, {}, nullptr, addedBounds(added, volume, grid))),
          params(*makeTraceParams(volume, medium, kSky, view, settings, {}, added)),
          tracer(volume, medium, kSky, nullptr, added) {}

    std::vector<GuideOf<double>> guides(const View& view) const {
        return tracer.guides(params, *guidePush(view, view), Precision::twofold);
    }

    BrickGrid grid;
    Medium medium;
    shared::TraceParams params;
    ReferenceTracer tracer;
};

TEST(Mixture, ExtinctionsAddAndColoursAreWeightedByThem) {
    const auto [volume, view] = scenes::slab(10.0, 4);
    Additions added;
    added.second =
        scenes::second(scenes::turnedCube(), scenes::coloured(scenes::homogeneous(0.06), {1, 0, 0}));
    const Mixed mixed(*volume, scenes::homogeneous(0.04, 0.9), added, view);
    for (const auto& guide : mixed.guides(view)) {
        EXPECT_NEAR(guide.coverage, 1.0 - std::exp(-1.0), 1e-5);
        EXPECT_NEAR(guide.albedo.x, 0.4 * 0.9 + 0.6, 1e-5);
        EXPECT_NEAR(guide.albedo.y, 0.4 * 0.9, 1e-5);
    }
    // The same by ray casting, where there is no chance either.
    const Mixed cast(*volume, scenes::homogeneous(0.04, 0.9), added, view, {.look = Look::dvr});
    for (const glm::dvec4& pixel : cast.tracer.cast(cast.params, {}, Precision::twofold, 0, 1)) {
        EXPECT_NEAR(pixel.w, 1.0 - std::exp(-1.0), 1e-5);
        EXPECT_NEAR(pixel.x, (1.0 - std::exp(-1.0)) * 0.96, 1e-4);
        EXPECT_NEAR(pixel.z, (1.0 - std::exp(-1.0)) * 0.36, 1e-4);
    }
}

// Of a slab from y = -5 to 5 mm the second volume fills what is behind -2.5 mm, where a registration puts it.
TEST(Mixture, TheSecondVolumeLiesWhereItIsRegistered) {
    const auto [volume, view] = scenes::slab(10.0, 4);
    const auto half = scenes::volumeOf({2, 2, 2}, affine({50, 0, 0}, {0, 50, 0}, {0, 0, 50}, {-25, 25, -25}),
                                       [](int, int, int) { return std::uint16_t(1); });
    Additions added;
    added.second =
        scenes::second(half, scenes::homogeneous(0.2), affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 2.5, 0}));
    const Mixed mixed(*volume, scenes::homogeneous(0.05), added, view, {.seed = 3});
    constexpr std::uint32_t kSamples = 40000;
    for (const Filter filter : {Filter::trilinear, Filter::stochastic}) {
        for (const Precision precision : {Precision::single, Precision::twofold}) {
            const auto moments = mixed.tracer.transmittance(mixed.params, filter, precision, {8, -100, 8},
                                                            {0, 1, 0}, kSamples);
            const double exact = std::exp(-(10.0 * 0.05 + 7.5 * 0.2));
            EXPECT_NEAR(moments.sum / kSamples, exact, 4.5 * std::sqrt(exact * (1.0 - exact) / kSamples));
        }
    }
}

TEST(Mixture, NoPointIsDenserThanTheBoundOfItsBrick) {
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), 1.1, glm::normalize(glm::dvec3(2, -1, 3)));
    const auto volume = scenes::volumeOf({37, 21, 30}, affine({3, 0, 0}, {0, 4, 0}, {0, 1, 2}, {7, -20, 5}),
                                         [](int, int, int) { return std::uint16_t(0); });
    // From much finer to much coarser voxels than those of the volume.
    for (const double edge : {0.8, 2.7, 31.0}) {
        const glm::dmat4 grid =
            turn * affine({edge, 0, 0}, {0, 1.3 * edge, 0}, {0, 0, 0.8 * edge}, {-10, 12, 3});
        const auto other = scenes::volumeOf({31, 23, 42}, grid, [](int i, int j, int k) {
            return std::uint16_t(i < 13 ? (i * 7919 + j * 104729 + k * 1299709) % 1009 : 0);
        });
        TransferFunction band = scenes::homogeneous(1.0);
        band.opacity = {{500, 0.0}, {600, 0.9}, {700, 0.1}};
        Additions added;
        added.second = scenes::second(other, band, affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-60, -15, -30}));
        TransferFunction nothing = scenes::homogeneous(1.0);
        nothing.opacity = {{0, 0.0}};
        const Mixed mixed(*volume, nothing, added, {});
        const SecondExtinction truth(*added.second, *volume);
        std::mt19937 random(7);
        std::uniform_real_distribution<double> part(0.0, 1.0);
        int met = 0;
        for (int n = 0; n < 40000; ++n) {
            const glm::dvec3 p = glm::dvec3(part(random), part(random), part(random)) *
                                 glm::dvec3(volume->size());  // integers at faces
            const glm::ivec3 brick = mixed.grid.brickAt(p);
            const double bound = mixed.medium.bounds[mixed.grid.index(brick.x, brick.y, brick.z)];
            const double there = truth.at(p - 0.5);
            ASSERT_LE(there, std::max(bound, 0.0)) << edge;
            if (there > 0.0) ++met;
        }
        EXPECT_GT(met, 20) << edge;
    }
}

// The sum of both is what light is taken for by chance: also on faces, edges and corners of bricks, where a
// point may be taken for one of either side.
TEST(Mixture, NoPointIsDenserThanTheBoundWhereBothAreAndOnBordersOfBricks) {
    const auto noise = [](int i, int j, int k) {
        return std::uint16_t((i * 7919 + j * 104729 + k * 1299709) % 1009);
    };
    const auto volume =
        scenes::volumeOf({26, 19, 23}, affine({3, 0, 0}, {0, 4, 0}, {0, 1, 2}, {7, -20, 5}), noise);
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), 0.9, glm::normalize(glm::dvec3(2, -1, 3)));
    const auto other = scenes::volumeOf(
        {31, 23, 42}, turn * affine({2.7, 0, 0}, {0, 3.5, 0}, {0, 0, 2.1}, {-10, -30, 3}), noise);
    TransferFunction band = scenes::homogeneous(1.0);
    band.opacity = {{500, 0.0}, {600, 0.9}, {700, 0.1}};
    TransferFunction rest = scenes::homogeneous(1.0);
    rest.opacity = {{0, 0.5}, {400, 0.0}};
    Additions added;
    added.second = scenes::second(other, band);
    added.tints = scenes::tint(*volume, {3, 2, 5}, {15, 12, 9}, {.rgb = {1.0f, 0.0f, 0.0f}, .opacity = 1.0f});
    const Mixed mixed(*volume, rest, added, {});
    const SecondExtinction second(*added.second, *volume);
    const SecondExtinction first(scenes::second(volume, rest), *volume);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    int both = 0;
    for (int n = 0; n < 30000; ++n) {
        glm::dvec3 p = glm::dvec3(part(random), part(random), part(random)) * glm::dvec3(volume->size());
        // Every other one is brought to a border along some of the axes: bricks begin half a voxel before 8
        // b.
        for (int axis = 0; n % 2 == 1 && axis < 3; ++axis) {
            if (part(random) < 0.6) p[axis] = std::clamp(8.0 * std::round(p[axis] / 8.0) - 0.5, 0.0, p[axis]);
        }
        const double there = first.at(p - 0.5) + second.at(p - 0.5);
        for (const double aside : {-1e-9, 1e-9}) {
            const glm::ivec3 brick = mixed.grid.brickAt(glm::max(p + aside, 0.0));
            const glm::ivec3 within = glm::clamp(brick, glm::ivec3(0), mixed.grid.size - 1);
            const double bound = mixed.medium.bounds[mixed.grid.index(within.x, within.y, within.z)];
            ASSERT_LE(there, std::max(bound, 0.0)) << p.x << ' ' << p.y << ' ' << p.z;
        }
        both += first.at(p - 0.5) > 0.0 && second.at(p - 0.5) > 0.0 ? 1 : 0;
    }
    EXPECT_GT(both, 100);
}

// A second volume on the same grid is the same as one medium with both tables in it: chance included.
TEST(Mixture, PicturesOfThePhantomHaveTheLightOfOneMediumWithBothCurves) {
    const auto volume =
        std::make_shared<const Volume>(phantom::make({.size = {48, 42, 30}, .spacingMm = {6.4, 6.4, 10.0}}));
    TransferFunction bone = scenes::homogeneous(1.0, 0.9);
    bone.opacity = {{150, 0.0}, {400, 0.4}};
    TransferFunction soft = scenes::coloured(scenes::homogeneous(1.0, 0.8), {0.9, 0.3, 0.2});
    soft.opacity = {{-150, 0.0}, {0, 0.05}, {80, 0.05}, {200, 0.0}};
    Additions added;
    added.second = scenes::second(volume, soft);
    const View view{
        .camera = frameBox(volume->worldBox(), ViewDirection::anterior, 30, 1.0), .width = 24, .height = 24};
    const Mixed mixed(*volume, bone, added, view, {.bounces = 4, .seed = 9});

    Medium both = mixed.medium;
    const auto others = opticsByEntry(*volume, soft);
    for (std::size_t entry = 0; entry < others.size(); ++entry) {
        const glm::vec4 own = both.albedo[entry];
        const float sum = own.w + others[entry].w;
        if (sum > 0.0f) both.albedo[entry] = (own * own.w + others[entry] * others[entry].w) / sum;
        both.albedo[entry].w = sum;
        both.extinctionPerMm[entry] = sum;
    }
    const ReferenceTracer one(*volume, both, kSky);
    const auto means = [](const std::vector<glm::dvec4>& sums) {
        glm::dvec4 mean(0.0);
        for (const glm::dvec4& sum : sums) mean += sum / double(sums.size());
        return mean;
    };
    const glm::dvec4 expected = means(one.trace(mixed.params, Filter::trilinear, Precision::twofold, 0, 8));
    const glm::dvec4 found =
        means(mixed.tracer.trace(mixed.params, Filter::trilinear, Precision::twofold, 0, 8));
    EXPECT_GT(expected.w, 1.0);
    for (int channel = 0; channel < 4; ++channel)
        EXPECT_NEAR(found[channel], expected[channel], 0.01 * expected[channel]) << channel;
    // And it is another picture than without the second volume.
    const Mixed alone(*volume, bone, {}, view, {.bounces = 4, .seed = 9});
    const glm::dvec4 without =
        means(alone.tracer.trace(alone.params, Filter::trilinear, Precision::twofold, 0, 8));
    EXPECT_LT(without.w, 0.9 * found.w);
}

TEST(Mixture, SegmentsColourMatterAndThinIt) {
    const auto [volume, view] = scenes::slab(10.0, 4);
    const SegmentTints::Colour green{.rgb = {0.0f, 1.0f, 0.0f}, .opacity = 0.5f};
    Additions all;
    all.tints = scenes::tint(*volume, {0, 0, 0}, volume->size(), green);
    const Mixed whole(*volume, scenes::homogeneous(0.2, 0.8), all, view);
    for (const auto& guide : whole.guides(view)) {
        EXPECT_NEAR(guide.coverage, 1.0 - std::exp(-1.0), 1e-5);
        EXPECT_NEAR(glm::distance(guide.albedo, glm::dvec3(0, 1, 0)), 0.0, 1e-5);
    }
    // Between the last voxel of a segment and the next one its share is what is left of the way.
    Additions part;
    part.tints = scenes::tint(*volume, {0, 0, 0}, {8, 20, 16}, green);
    const Mixed left(*volume, scenes::homogeneous(0.2), part, view, {.seed = 4});
    for (const double x :
         {4.0, 7.75, 8.0, 8.25, 12.0}) {  // integers at faces; the last voxel's middle is 7.5
        const double share = std::clamp(8.5 - x, 0.0, 1.0);
        constexpr std::uint32_t kSamples = 20000;
        const auto moments = left.tracer.transmittance(left.params, Filter::trilinear, Precision::twofold,
                                                       {x, -100, 8}, {0, 1, 0}, kSamples);
        const double exact = std::exp(-0.2 * 10.0 * (1.0 - 0.5 * share));
        EXPECT_NEAR(moments.sum / kSamples, exact, 4.5 * std::sqrt(exact * (1.0 - exact) / kSamples)) << x;
    }
}

TEST(Mixture, OfAnOpaqueOrAHiddenSegmentOnlyTheColourOrNothingIsLeft) {
    const auto [volume, view] = scenes::slab(10.0, 4);
    Additions hidden;
    hidden.tints = scenes::tint(*volume, {0, 0, 0}, volume->size(), {.rgb = {1, 1, 1}, .opacity = 0.0f});
    const Mixed none(*volume, scenes::homogeneous(5.0), hidden, view);
    for (const auto& guide : none.guides(view)) EXPECT_EQ(guide.coverage, 0.0);
    // A second volume in the same place is not thinned by a segment of the first.
    hidden.second = scenes::second(scenes::turnedCube(), scenes::homogeneous(0.1));
    const Mixed other(*volume, scenes::homogeneous(5.0), hidden, view);
    for (const auto& guide : other.guides(view)) EXPECT_NEAR(guide.coverage, 1.0 - std::exp(-1.0), 1e-5);
}

std::vector<glm::dvec4> picture(const Volume& volume, double perMm, const Additions& added, Look look) {
    const View view = scenes::slab(10.0, 6).view;
    const Mixed mixed(volume, scenes::homogeneous(perMm), added, view,
                      {.bounces = 3, .seed = 5, .look = look});
    if (look == Look::dvr) return mixed.tracer.cast(mixed.params, {}, Precision::twofold, 0, 2);
    return mixed.tracer.trace(mixed.params, Filter::trilinear, Precision::twofold, 0, 4);
}

TEST(Mixture, ASecondVolumeOfNothingChangesNothing) {
    const auto volume = scenes::slab(10.0, 6).volume;
    const glm::dmat4 cube = affine({50, 0, 0}, {0, 50, 0}, {0, 0, 50}, {-50, -50, -50});
    const auto one = [](int, int, int) { return std::uint16_t(1); };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    auto nans = Volume::createFloat({.size = {3, 3, 3}, .worldFromVoxel = cube}, std::vector<float>(27, nan));
    ASSERT_TRUE(nans.ok());
    TransferFunction clear = scenes::homogeneous(1.0);
    clear.opacity = {{0, 0.0}};

    const std::vector<std::pair<const char*, DrawnSecondVolume>> seconds{
        {"NaN", scenes::second(in16Bits(std::make_shared<const Volume>(*std::move(nans))),
                               scenes::homogeneous(3.0))},
        {"all clear", scenes::second(scenes::volumeOf({3, 3, 3}, cube, one), clear)},
        {"far outside", scenes::second(scenes::volumeOf({3, 3, 3}, cube, one), scenes::homogeneous(3.0),
                                       affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1e7, 0, 0}))}};
    for (const Look look : {Look::cinematic, Look::dvr}) {
        const auto alone = picture(*volume, 0.3, {}, look);
        for (const auto& [name, nothing] : seconds) {
            SCOPED_TRACE(name);
            Additions added;
            added.second = nothing;
            const auto with = picture(*volume, 0.3, added, look);
            ASSERT_EQ(with.size(), alone.size());
            for (std::size_t i = 0; i < with.size(); ++i)
                EXPECT_NEAR(glm::distance(with[i], alone[i]), 0.0, look == Look::dvr ? 1e-5 : 0.0) << i;
        }
    }
}

TEST(Mixture, PicturesAreFiniteAtTheExtremes) {
    const auto volume = scenes::slab(10.0, 6).volume;
    const auto one = [](int, int, int) { return std::uint16_t(1); };
    const auto single = scenes::volumeOf({1, 1, 1}, affine({5, 0, 0}, {0, 5, 0}, {0, 0, 5}, {0, 0, 0}), one);
    for (const Look look : {Look::cinematic, Look::dvr}) {
        for (const auto& [first, second] :
             {std::pair(1e-3, 1e3), std::pair(1e3, 1e-3), std::pair(0.1, 0.1)}) {
            for (const auto& other : {single, scenes::turnedCube()}) {
                Additions added;
                added.second = scenes::second(other, scenes::homogeneous(second));
                double most = 0.0;
                for (const glm::dvec4& pixel : picture(*volume, first, added, look)) {
                    ASSERT_TRUE(std::isfinite(pixel.x + pixel.y + pixel.z + pixel.w));
                    most = std::max(most, pixel.w);
                }
                if (first + second < 1.0) continue;
                EXPECT_GT(most, 1.9);  // some pixel is opaque in each sample
            }
        }
    }
}

TEST(Mixture, WhatIsNotUsableIsToldAndNotDrawn) {
    const auto volume = scenes::slab(10.0, 6).volume;
    Additions added;
    EXPECT_TRUE(validate(added, *volume).ok());
    added.second = scenes::second(scenes::turnedCube(), scenes::homogeneous(1.0), glm::dmat4(0.0));
    EXPECT_FALSE(validate(added, *volume).ok());
    added.second = scenes::second(nullptr, scenes::homogeneous(1.0));
    EXPECT_FALSE(validate(added, *volume).ok());
    added.second.reset();
    added.tints = scenes::tint(*volume, {0, 0, 0}, volume->size(), {});
    EXPECT_TRUE(validate(added, *volume).ok());
    EXPECT_FALSE(validate(added, *scenes::turnedCube()).ok());  // of another volume
    // What is known to be valid is not gone through again; with fewer colours it is not known.
    const Additions valid = added;
    EXPECT_TRUE(validate(added, *volume, valid).ok());
    added.tints->colours.front().opacity = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(validate(added, *volume).ok());
    EXPECT_FALSE(validate(added, *volume, valid).ok());
    added.tints->colours.clear();  // a voxel without a colour
    EXPECT_FALSE(validate(added, *volume).ok());
    EXPECT_FALSE(validate(added, *volume, valid).ok());
}

}  // namespace
}  // namespace macula::trace
