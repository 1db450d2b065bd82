// What an outline over a picture cuts out of a volume: a voxel goes if, and only if, its middle is seen
// within the outline.
#include "scene/clip/scissor_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "base/phantom.h"
#include "pipeline/volume/mask_bits.h"
#include "scene/clip/combined_mask.h"
#include "scene/clip/scissor_mask.h"
#include "scene/drawing/shown_clip.h"
#include "scene/state/study_state.h"

namespace macula::scene {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Volume volumeOf(const glm::ivec3& size, const glm::dmat4& worldFromVoxel) {
    auto volume = Volume::create({.size = size, .worldFromVoxel = worldFromVoxel},
                                 std::vector<std::uint16_t>(std::size_t(size.x * size.y * size.z), 1));
    EXPECT_TRUE(volume);
    return *std::move(volume);
}

// Turned, sheared, and of unequal spacing.
Volume tilted() {
    return volumeOf({17, 14, 11}, affine({3, 0.4, 0}, {-0.5, 3.2, 0.6}, {0.2, 1.5, 5}, {-25, -20, -30}));
}

Camera outside() {
    return {.positionMm = {60, -180, 50}, .targetMm = {0, 5, 0}, .up = {0, 0, 1}, .verticalFovDeg = 35};
}

// Some voxels are behind this eye.
Camera inside() {
    return {.positionMm = {0, 2, -3}, .targetMm = {10, 30, 5}, .up = {0, 0, 1}, .verticalFovDeg = 100};
}

// Stands in the volume: what is behind it is seen, too.
Camera parallel() {
    return {.positionMm = {5, -8, 3},
            .targetMm = {0, 5, 0},
            .up = {0, 0, 1},
            .verticalFovDeg = 35,
            .parallelHeightMm = 90};
}

// A star with points in and out: not convex, and no line crosses another.
std::vector<glm::dvec2> star(glm::dvec2 centre, double radius) {
    std::vector<glm::dvec2> points;
    for (int i = 0; i < 14; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / 14.0 + 0.1;
        const double r = radius * (i % 2 == 0 ? 1.0 : 0.45);
        points.push_back(centre + r * glm::dvec2(std::cos(turn), std::sin(turn)));
    }
    return points;
}

// By another way than the code: a pinhole or its far end, and how often a ray to the right crosses the
// outline.
bool isSeenWithin(const ScissorCut& cut, const glm::dvec3& mm) {
    const glm::dvec3 forward = glm::normalize(cut.camera.targetMm - cut.camera.positionMm);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, cut.camera.up));
    const glm::dvec3 up = glm::cross(right, forward);
    const glm::dvec3 from = mm - cut.camera.positionMm;
    const double depth = glm::dot(from, forward);
    const bool isFar = cut.camera.parallelHeightMm > 0.0;
    if (!isFar && depth <= 0.0) return false;
    const double halfHeightMm =
        isFar ? 0.5 * cut.camera.parallelHeightMm
              : depth * std::tan(0.5 * cut.camera.verticalFovDeg * std::numbers::pi / 180.0);
    const double scale = 1.0 / halfHeightMm;
    const glm::dvec2 p(glm::dot(from, right) * scale, glm::dot(from, up) * scale);
    bool within = false;
    for (std::size_t i = 0, j = cut.outline.size() - 1; i < cut.outline.size(); j = i++) {
        const glm::dvec2& a = cut.outline[i];
        const glm::dvec2& b = cut.outline[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x)
            within = !within;
    }
    return within;
}

MaskBits bitsOf(const std::vector<ScissorCut>& cuts, const Volume& volume, std::optional<Mask> before = {}) {
    Progress progress;
    auto mask = scissorMask(std::move(before), cuts, volume, progress);
    EXPECT_TRUE(mask.ok()) << (mask ? Text() : mask.error().message);
    if (!mask || !*mask) return {};
    return maskBits(**mask, volume);
}

template <class Body>
void forEachVoxel(const Volume& volume, const Body& body) {
    for (int k = 0; k < volume.size().z; ++k)
        for (int j = 0; j < volume.size().y; ++j)
            for (int i = 0; i < volume.size().x; ++i)
                body(i, j, k, transformPoint(volume.worldFromVoxel(), glm::dvec3(i, j, k)));
}

TEST(ScissorCut, RemovesAVoxelIfAndOnlyIfItsMiddleIsSeenWithinTheOutline) {
    const Volume volume = tilted();
    for (const Camera& camera : {outside(), inside(), parallel()}) {
        for (const bool removesOutside : {false, true}) {
            const ScissorCut cut{
                .camera = camera, .outline = star({0.05, -0.02}, 0.4), .removesOutside = removesOutside};
            const MaskBits bits = bitsOf({cut}, volume);
            int removed = 0;
            int kept = 0;
            forEachVoxel(volume, [&](int i, int j, int k, const glm::dvec3& mm) {
                const bool goes = isSeenWithin(cut, mm) != removesOutside;
                ASSERT_EQ(bits.shows(i, j, k), !goes) << i << " " << j << " " << k;
                ++(goes ? removed : kept);
            });
            EXPECT_GT(removed, 20);
            EXPECT_GT(kept, 20);
        }
    }
}

// Toward a side of the picture, so that rows of voxels are left out as a whole.
TEST(ScissorCut, FindsWhatIsAtTheEdgeOfThePictureAndBeyond) {
    const Volume volume = tilted();
    for (const glm::dvec2 at : {glm::dvec2(-0.6, 0.3), glm::dvec2(0.5, 0.5), glm::dvec2(0.0, -1.4)}) {
        for (const Camera& camera : {inside(), parallel()}) {
            const ScissorCut cut{.camera = camera, .outline = star(at, 0.9)};
            const MaskBits bits = bitsOf({cut}, volume);
            forEachVoxel(volume, [&](int i, int j, int k, const glm::dvec3& mm) {
                ASSERT_EQ(bits.shows(i, j, k), !isSeenWithin(cut, mm));
            });
        }
    }
}

TEST(ScissorCut, OneAfterTheOtherIsTheSameAsTogether) {
    const Volume volume = tilted();
    const ScissorCut first{.camera = outside(), .outline = star({-0.1, 0.1}, 0.2)};
    const ScissorCut second{.camera = inside(), .outline = star({0.2, 0.0}, 0.5), .removesOutside = true};
    Progress progress;
    const auto afterFirst = scissorMask({}, std::vector{first}, volume, progress);
    ASSERT_TRUE(afterFirst.ok());
    EXPECT_EQ(bitsOf({second}, volume, *afterFirst).words, bitsOf({first, second}, volume).words);
}

TEST(ScissorCut, WhatElseIsHiddenStaysHidden) {
    const Volume volume = tilted();
    std::vector<std::uint16_t> labels(std::size_t(17 * 14 * 11), 0);
    for (std::size_t n = 0; n < labels.size(); n += 3) labels[n] = 4;
    Mask others;
    others.labels = std::make_shared<const LabelMap>(
        *LabelMap::create({17, 14, 11}, volume.worldFromVoxel(), {}, labels));
    others.numbers = {4};
    others.remark = Text("liver hidden");
    const ScissorCut cut{.camera = outside(), .outline = star({0, 0}, 0.2)};
    Progress progress;
    const auto alone = scissorMask({}, std::vector{cut}, volume, progress);
    ASSERT_TRUE(alone.ok() && *alone);
    EXPECT_EQ((*alone)->remark, "cut with scissors");
    const auto both = combinedMask(std::vector{others, **alone}, volume, progress);
    ASSERT_TRUE(both.ok() && *both);
    EXPECT_EQ((*both)->remark, "liver hidden, cut with scissors");
    const MaskBits shown = maskBits(**both, volume);
    forEachVoxel(volume, [&](int i, int j, int k, const glm::dvec3&) {
        const bool isLabelled = (std::size_t((k * 14 + j) * 17 + i)) % 3 == 0;
        ASSERT_EQ(shown.shows(i, j, k), isLabelled && (*alone)->bits->shows(i, j, k));
    });
    const auto same = scissorMask(*alone, {}, volume, progress);
    ASSERT_TRUE(same.ok() && *same);
    EXPECT_EQ((*same)->bits, (*alone)->bits) << "no copy where nothing is cut";
    const auto nothing = scissorMask({}, {}, volume, progress);
    ASSERT_TRUE(nothing.ok());
    EXPECT_FALSE(*nothing);
}

TEST(ScissorCut, ALoopThatIsDrawnTwiceEnclosesWhatItEncloses) {
    ScissorCut once{.camera = outside(), .outline = star({0, 0}, 0.3)};
    ScissorCut twice = once;
    std::vector<glm::dvec2> points = once.outline;
    points.insert(points.end(), once.outline.begin(), once.outline.end());
    twice.outline = points;
    EXPECT_EQ(bitsOf({once}, tilted()).words, bitsOf({twice}, tilted()).words);
    std::reverse(points.begin(), points.end());
    twice.outline = points;
    EXPECT_EQ(bitsOf({once}, tilted()).words, bitsOf({twice}, tilted()).words);
}

TEST(ScissorCut, RefusesToLeaveNothing) {
    const ScissorCut all{.camera = outside(), .outline = {{-50, -50}, {50, -50}, {50, 50}, {-50, 50}}};
    Progress progress;
    const auto mask = scissorMask({}, std::vector{all}, tilted(), progress);
    ASSERT_FALSE(mask.ok());
    EXPECT_EQ(mask.error().code, ErrorCode::usage);
    EXPECT_FALSE(mask.error().hint.empty());
    // One voxel: it is there, or all would be gone.
    const Volume one = volumeOf({1, 1, 1}, affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 5, 0}));
    EXPECT_FALSE(scissorMask({}, std::vector{all}, one, progress).ok());
    const ScissorCut beside{.camera = outside(), .outline = {{0.8, 0.8}, {0.9, 0.8}, {0.9, 0.9}}};
    EXPECT_TRUE(bitsOf({beside}, one).shows(0, 0, 0));
}

TEST(ScissorCut, CanBeCancelled) {
    const CancelToken token;
    token.cancel();
    Progress progress([](const ProgressUpdate&) {}, token);
    const ScissorCut cut{.camera = outside(), .outline = star({0, 0}, 0.2)};
    EXPECT_EQ(scissorMask({}, std::vector{cut}, tilted(), progress).error().code, ErrorCode::cancelled);
}

TEST(ScissorCut, SaysWhatIsWrongWithIt) {
    const ScissorCut good{.camera = outside(), .outline = star({0, 0}, 0.2)};
    EXPECT_TRUE(validate(good).ok());
    const auto isRefused = [&](const auto& change) {
        ScissorCut cut = good;
        change(cut);
        const auto valid = validate(cut);
        Progress progress;
        EXPECT_EQ(scissorMask({}, std::vector{cut}, tilted(), progress).ok(), valid.ok());
        return !valid.ok() && valid.error().code == ErrorCode::usage && !valid.error().message.empty();
    };
    const auto isRefusedWith = [&](const auto& change) {
        std::vector<glm::dvec2> points = good.outline;
        change(points);
        return isRefused([&](auto& c) { c.outline = points; });
    };
    EXPECT_TRUE(isRefusedWith([](auto& points) { points.clear(); }));
    EXPECT_TRUE(isRefusedWith([](auto& points) { points.resize(2); }));
    EXPECT_TRUE(isRefusedWith([](auto& points) { points[3].x = kNan; }));
    EXPECT_TRUE(isRefused([](auto& c) { c.outline = {{0, 0}, {1, 0}, {0.5, 0}}; })) << "a line";
    EXPECT_TRUE(isRefused([](auto& c) { c.outline = {{0, 0}, {0, 0}, {0, 0}}; })) << "a point";
    EXPECT_TRUE(isRefusedWith([](auto& points) { points.resize(kMostOutlinePoints + 1, {0.1, 0.2}); }));
    EXPECT_TRUE(isRefused([](auto& c) { c.camera.targetMm = c.camera.positionMm; }));
    EXPECT_TRUE(isRefused([](auto& c) { c.camera.positionMm.x = kNan; }));
    EXPECT_TRUE(isRefused([](auto& c) { c.camera.parallelHeightMm = 1e9; }));
}

TEST(ScissorCut, AnOutlineGetsFewerPointsAndStaysWhereItWas) {
    std::vector<glm::dvec2> drawn;
    for (int i = 0; i < 20000; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / 20000.0;
        drawn.push_back(0.7 * glm::dvec2(std::cos(turn), std::sin(turn)));
    }
    const std::vector<glm::dvec2> fewer = simplified(drawn, 0.001);
    EXPECT_LT(fewer.size(), 200u);
    EXPECT_GE(fewer.size(), 3u);
    EXPECT_TRUE(validate({.camera = outside(), .outline = fewer}).ok());
    for (std::size_t i = 0; i < fewer.size(); ++i) {
        const glm::dvec2 middle = 0.5 * (fewer[i] + fewer[(i + 1) % fewer.size()]);
        EXPECT_GT(glm::length(middle), 0.699 - 0.001);
    }
    std::mt19937 random(7);
    std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
    std::vector<glm::dvec2> scribble;
    for (int i = 0; i < 3000; ++i) scribble.emplace_back(anywhere(random), anywhere(random));
    EXPECT_LE(simplified(scribble, 1e-6).size(), kMostOutlinePoints);
    EXPECT_TRUE(simplified({}, 0.1).empty());
    EXPECT_EQ(simplified({{0, 0}, {0, 0}, {kNan, 0}}, 0.1).size(), 1u);
}

// As `macula render --session` draws it.
TEST(ShownClip, OfAStateIsCutWithItsScissors) {
    const Volume volume = tilted();
    StudyState state;
    state.cuts.scissors = {{.camera = outside(), .outline = star({0, 0}, 0.2)}};
    Progress progress;
    const auto shown = shownClip(state, volume, progress);
    ASSERT_TRUE(shown.ok());
    ASSERT_TRUE(shown->clip.mask);
    EXPECT_FALSE(shown->tableRemoved);
    EXPECT_EQ(shown->clip.mask->remark, "cut with scissors");
    EXPECT_EQ(maskBits(*shown->clip.mask, volume).words, bitsOf(state.cuts.scissors, volume).words);
}

}  // namespace
}  // namespace macula::scene
