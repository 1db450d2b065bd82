// What a clip removes, against its definition point by point; without a GPU.
#include <gtest/gtest.h>

#include "pipeline/trace/reference_tracer.h"
#include "trace/clips.h"
#include "trace/scenes.h"

namespace macula::trace {
namespace {

const glm::dmat4 kOblique = affine({0.8, 0.1, 0.0}, {-0.2, 1.1, 0.3}, {0.1, -0.4, 2.5}, {40.0, -70.0, 300.0});

std::shared_ptr<const Volume> solid() {
    static const auto volume =
        scenes::volumeOf({30, 40, 20}, kOblique, [](int, int, int) { return std::uint16_t(1); });
    return volume;
}

const Environment& sky() {
    static const Environment made = Environment::constant(glm::vec3(1.0f));
    return made;
}

// Length of the part of a ray that is in the volume and shown, by definition.
double shownLength(const Volume& volume, const Clip& clip, const glm::dvec3& origin,
                   const glm::dvec3& direction, double lengthMm) {
    constexpr int kSteps = 20000;
    const glm::dmat4 voxelFromWorld = glm::inverse(volume.worldFromVoxel());
    const glm::dvec3 size(volume.size());
    int shown = 0;
    for (int i = 0; i < kSteps; ++i) {
        const glm::dvec3 point = origin + direction * (lengthMm * (i + 0.5) / kSteps);
        const glm::dvec3 voxel = transformPoint(voxelFromWorld, point) + 0.5;
        const bool inside = glm::all(glm::greaterThanEqual(voxel, glm::dvec3(0.0))) &&
                            glm::all(glm::lessThanEqual(voxel, size));
        shown += inside && shows(clip, point) ? 1 : 0;
    }
    return lengthMm * shown / kSteps;
}

TEST(Clip, RaysAreShownExactlyWhereItsPointsAre) {
    const auto volume = solid();
    const Box box = volume->worldBox();
    scenes::Chance chance(11);
    constexpr double kPerMm = 0.05;
    constexpr double kFar = 400.0;
    constexpr std::uint32_t kSamples = 4000;
    int seen = 0;
    for (int trial = 0; trial < 150; ++trial) {
        const Clip clip = scenes::anyClip(chance, box);
        ASSERT_TRUE(validate(clip)) << trial;
        const Medium medium = makeMedium(*volume, makeBrickGrid(*volume), scenes::homogeneous(kPerMm), clip);
        const auto params = makeTraceParams(*volume, medium, sky(), {}, {.seed = unsigned(trial)}, clip);
        ASSERT_TRUE(params) << params.error().message;
        const ReferenceTracer tracer(*volume, medium, sky());
        for (int ray = 0; ray < 4; ++ray) {
            // From outside, and from within what may be removed.
            const glm::dvec3 through = chance.inBox(box);
            const glm::dvec3 direction = chance.direction();
            const glm::dvec3 origin = ray < 2 ? through - direction * (0.5 * kFar) : through;
            const glm::dvec3 voxel = transformPoint(glm::inverse(kOblique), origin) + 0.5;
            const double length = shownLength(*volume, clip, origin, direction, kFar);
            for (const Precision precision : {Precision::single, Precision::twofold}) {
                const auto moments =
                    tracer.transmittance(*params, Filter::stochastic, precision, voxel, direction, kSamples);
                const double exact = std::exp(-kPerMm * length);
                const double error = std::sqrt(exact * (1 - exact) / kSamples);
                EXPECT_NEAR(moments.sum / kSamples, exact, 5.0 * error + 2e-3)
                    << "clip " << trial << " ray " << ray << ": " << length << " mm shown";
            }
            seen += length > 0.5 ? 1 : 0;
        }
    }
    EXPECT_GT(seen, 100);  // the trials must not be empty
}

TEST(Clip, BricksThatAreEmptiedHoldNothingShown) {
    const Box box = solid()->worldBox();
    scenes::Chance chance(12);
    int emptied = 0;
    for (int trial = 0; trial < 400; ++trial) {
        const Clip clip = scenes::anyClip(chance, box);
        const glm::dvec3 low(chance.between(0, 22), chance.between(0, 32), chance.between(0, 12));
        const Box brick{low, low + 8.0};
        if (!removesAll(clip, kOblique, brick)) continue;
        ++emptied;
        for (int i = 0; i < 500; ++i)
            ASSERT_FALSE(shows(clip, transformPoint(kOblique, chance.inBox(brick)))) << trial;
    }
    EXPECT_GT(emptied, 60);
}

TEST(Clip, EverythingOrNothing) {
    const auto volume = solid();
    const Box box = volume->worldBox();
    const View view{.camera = frameBox(box, ViewDirection::anterior, 30, 1.0), .width = 16, .height = 16};
    const auto coverage = [&](const Clip& clip) {
        const Medium medium = makeMedium(*volume, makeBrickGrid(*volume), scenes::homogeneous(1e3), clip);
        const auto params = makeTraceParams(*volume, medium, sky(), view, {.bounces = 1}, clip);
        double sum = 0.0;
        for (const glm::dvec4& pixel : ReferenceTracer(*volume, medium, sky())
                                           .trace(*params, Filter::trilinear, Precision::single, 0, 4))
            sum += pixel.a;
        return sum;
    };
    const double all = coverage({});
    EXPECT_GT(all, 200.0);
    const glm::dvec3 centre = box.centre();
    EXPECT_EQ(coverage({.planes = {{{0, 0, 1}, box.high.z + 1}}}), 0.0);  // removes everything
    EXPECT_EQ(coverage({.planes = {{{0, 0, 1}, box.low.z - 1}}}), all);   // and nothing
    EXPECT_EQ(coverage({.ball = Ball{centre, 1000.0}, .ofBall = Keep::outside}), 0.0);
    EXPECT_EQ(coverage({.ball = Ball{centre, 1000.0}}), all);
    EXPECT_EQ(coverage({.box = OrientedBox{.centreMm = centre, .halfSizeMm = glm::dvec3(500)}}), all);
    EXPECT_EQ(coverage({.box = OrientedBox{.centreMm = centre, .halfSizeMm = glm::dvec3(500)},
                        .ofBox = Keep::outside}),
              0.0);
    // Two planes that leave nothing between them, and two that touch.
    EXPECT_EQ(coverage({.planes = {{{1, 0, 0}, centre.x + 1}, {{-1, 0, 0}, -centre.x}}}), 0.0);
    EXPECT_EQ(coverage({.planes = {{{0, 1, 0}, centre.y}, {{0, -1, 0}, -centre.y}}}), 0.0);
    // A plane that all rays are parallel to: an eye in it, and what is on its side.
    View edge = view;
    edge.camera.positionMm.x = edge.camera.targetMm.x = centre.x;
    EXPECT_GT(coverage({.planes = {{{1, 0, 0}, centre.x}}}), 0.3 * all);
    EXPECT_LT(coverage({.planes = {{{1, 0, 0}, centre.x}}}), 0.7 * all);
}

// Left is left: an octant towards L, A, S is gone from the patient's left, front and top, and from nowhere
// else.
TEST(Clip, OctantsAreOfThePatient) {
    const Octant octant{.pointMm = {10, 20, 30}, .towards = {1, -1, 1}};
    const Clip clip{.cut = octant};
    EXPECT_FALSE(shows(clip, {11, 19, 31}));
    EXPECT_TRUE(shows(clip, {9, 19, 31}));
    EXPECT_TRUE(shows(clip, {11, 21, 31}));
    EXPECT_TRUE(shows(clip, {11, 19, 29}));
}

// A slab behind another: when the front one is removed it may or may not keep the light away.
TEST(Clip, WhatIsRemovedMayStillCastShadow) {
    const auto volume =
        scenes::volumeOf({32, 32, 32}, affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-15.5, -15.5, -15.5}),
                         [](int, int j, int) { return std::uint16_t(j < 4 || j > 27 ? 1 : 0); });
    LightRig rig;
    rig.frame = LightFrame::camera;
    rig.lights = {
        {.azimuthDeg = 0, .elevationDeg = 0, .angularRadiusDeg = 5, .radiance = 100}};  // behind the viewer
    const Environment lamp = Environment::fromRig(rig);
    const View view{
        .camera = frameBox(volume->worldBox(), ViewDirection::anterior, 20, 1.0), .width = 16, .height = 16};
    const auto light = [&](Clip clip) {
        const Medium medium = makeMedium(*volume, makeBrickGrid(*volume), scenes::homogeneous(2.0), clip);
        const auto params = makeTraceParams(*volume, medium, lamp, view, {.bounces = 1}, clip);
        double sum = 0.0;
        for (const glm::dvec4& pixel : ReferenceTracer(*volume, medium, lamp)
                                           .trace(*params, Filter::trilinear, Precision::single, 0, 64))
            sum += pixel.g;
        return sum;
    };
    const Clip front{.planes = {{{0, 1, 0}, 0.0}}};
    Clip shading = front;
    shading.removedCastsShadow = true;
    EXPECT_GT(light(front), 10.0 * light(shading));  // some comes in from the sides
    EXPECT_GT(light(front), 1.0);
}

// The face of a cut shows the values, and what stands in front of it covers it.
TEST(Clip, GreyFacesShowTheWindow) {
    const auto volume =
        scenes::volumeOf({32, 32, 32}, affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-15.5, -15.5, -15.5}),
                         [](int i, int, int) { return std::uint16_t(100 + i); });
    TransferFunction unseen = scenes::homogeneous(2.0);
    unseen.opacity = {{1000, 0.0}, {1001, 1.0}};
    const View view{.camera = {.positionMm = {0, -3000, 0}, .targetMm = {0, 0, 0}, .verticalFovDeg = 0.5},
                    .width = 26,
                    .height = 26};
    Clip clip{.planes = {{{0, 1, 0}, 3.0}}};
    clip.greyFaces = DisplayWindow{.center = 115, .width = 40, .explanation = {}, .function = "LINEAR_EXACT"};
    const Medium medium = makeMedium(*volume, makeBrickGrid(*volume), unseen, clip);
    const auto params = makeTraceParams(*volume, medium, sky(), view, {.bounces = 1, .exposure = 2.5}, clip);
    const auto sums =
        ReferenceTracer(*volume, medium, sky()).trace(*params, Filter::trilinear, Precision::twofold, 0, 256);
    for (int x = 0; x < 26; ++x) {
        const double mmAtFace = (x + 0.5 - 13.0) * 2.0 * 3003.0 * std::tan(glm::radians(0.25)) / 26.0;
        const double value = 115.5 + mmAtFace;
        const double encoded = (value - 95.0) / 40.0;
        const glm::dvec4 mean = sums[std::size_t(13 * 26 + x)] / 256.0;
        EXPECT_EQ(mean.a, 1.0);
        // What display() does to it.
        double shown = mean.g * 2.5;
        shown -= shown < 0.08 ? shown - 6.25 * shown * shown : 0.04;
        if (shown >= 0.76) shown = 1.0 - 0.24 * 0.24 / (shown + 0.24 - 0.76);
        shown = shown <= 0.0031308 ? 12.92 * shown : 1.055 * std::pow(shown, 1 / 2.4) - 0.055;
        EXPECT_NEAR(shown, encoded, 0.012) << x;
    }
    // The eye in the removed part sees the same face; behind it, in the shown part, it sees none.
    View inside = view;
    inside.camera.positionMm.y = -10;
    inside.camera.verticalFovDeg = 30;
    const auto near = makeTraceParams(*volume, medium, sky(), inside, {.bounces = 1}, clip);
    EXPECT_EQ(ReferenceTracer(*volume, medium, sky())
                  .trace(*near, Filter::trilinear, Precision::single, 0, 1)[13 * 26 + 13]
                  .a,
              1.0);
    inside.camera.positionMm.y = 5;
    inside.camera.targetMm.y = 20;
    const auto behind = makeTraceParams(*volume, medium, sky(), inside, {.bounces = 1}, clip);
    EXPECT_EQ(ReferenceTracer(*volume, medium, sky())
                  .trace(*behind, Filter::trilinear, Precision::single, 0, 1)[13 * 26 + 13]
                  .a,
              0.0);
}

// At the window's low end and below a face is clear, or black and opaque where that is asked for.
TEST(Clip, GreyFacesBelowTheWindowAreBlackWhereThatIsAskedFor) {
    const auto volume =
        scenes::volumeOf({32, 32, 32}, affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-15.5, -15.5, -15.5}),
                         [](int i, int, int) { return std::uint16_t(i < 16 ? 10 : 115); });
    TransferFunction unseen = scenes::homogeneous(2.0);
    unseen.opacity = {{1000, 0.0}, {1001, 1.0}};
    const View view{.camera = {.positionMm = {0, -3000, 0}, .targetMm = {0, 0, 0}, .verticalFovDeg = 0.5},
                    .width = 26,
                    .height = 26};
    for (const bool isBlack : {false, true}) {
        Clip clip{.planes = {{{0, 1, 0}, 3.0}}, .facesBelowWindowAreBlack = isBlack};
        clip.greyFaces =
            DisplayWindow{.center = 115, .width = 40, .explanation = {}, .function = "LINEAR_EXACT"};
        const Medium medium = makeMedium(*volume, makeBrickGrid(*volume), unseen, clip);
        const auto params = makeTraceParams(*volume, medium, sky(), view, {.bounces = 1}, clip);
        const auto sums = ReferenceTracer(*volume, medium, sky())
                              .trace(*params, Filter::trilinear, Precision::twofold, 0, 1);
        const glm::dvec4 low = sums[std::size_t(13 * 26 + 5)];
        EXPECT_EQ(low.a, isBlack ? 1.0 : 0.0);
        if (isBlack) {
            EXPECT_LT(low.g, 2e-3);
        }
        EXPECT_EQ(sums[std::size_t(13 * 26 + 20)].a, 1.0);
    }
}

// What a mask hides is no slice either.
TEST(Clip, GreyFacesShowNothingOfWhatAMaskHides) {
    const glm::ivec3 size(16, 16, 16);
    const glm::dmat4 grid = affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-7.5, -7.5, -7.5});
    const auto volume = scenes::volumeOf(size, grid, [](int, int, int) { return std::uint16_t(100); });
    std::vector<std::uint16_t> labels(16 * 16 * 16, 0);
    for (std::size_t n = 0; n < labels.size(); ++n)
        labels[n] = n % 16 < 8 ? 1 : 0;  // the patient's right half
    TransferFunction unseen = scenes::homogeneous(2.0);
    unseen.opacity = {{1000, 0.0}, {1001, 1.0}};
    Clip clip{.planes = {{{0, 1, 0}, 0.0}}};
    clip.mask = Mask{std::make_shared<const LabelMap>(
        std::move(LabelMap::create(size, grid, {{.number = 1, .label = "a"}}, labels)).value())};
    clip.greyFaces =
        DisplayWindow{.center = 100, .width = 100, .explanation = {}, .function = "LINEAR_EXACT"};
    const View view{.camera = {.positionMm = {0, -3000, 0}, .targetMm = {0, 0, 0}, .verticalFovDeg = 0.2},
                    .width = 8,
                    .height = 8};
    const MaskBits bits = maskBits(*clip.mask, *volume);
    const Medium medium = makeMedium(*volume, makeBrickGrid(*volume), unseen, clip, &bits);
    const auto params = makeTraceParams(*volume, medium, sky(), view, {}, clip);
    const auto sums = ReferenceTracer(*volume, medium, sky(), &bits)
                          .trace(*params, Filter::trilinear, Precision::single, 0, 1);
    for (int y = 0; y < 8; ++y) {
        EXPECT_EQ(sums[std::size_t(y * 8 + 1)].a, 1.0);  // the patient's right is on the left
        EXPECT_EQ(sums[std::size_t(y * 8 + 6)].a, 0.0);
    }
}

TEST(Clip, RefusesWhatIsNone) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(validate(Clip{}));
    EXPECT_FALSE(validate(Clip{.box = OrientedBox{.halfSizeMm = {1, 0, 1}}}));
    EXPECT_FALSE(validate(Clip{.box = OrientedBox{.centreMm = {nan, 0, 0}}}));
    EXPECT_FALSE(validate(Clip{.box = OrientedBox{.axes = glm::dmat3(2.0)}}));
    EXPECT_FALSE(validate(Clip{.planes = std::vector<HalfSpace>(7)}));
    EXPECT_FALSE(validate(Clip{.planes = {{{0, 0, 0}, 0}}}));
    EXPECT_FALSE(validate(Clip{.planes = {{{0, 0, 1}, nan}}}));
    EXPECT_FALSE(validate(Clip{.cut = Octant{.towards = {1, 0, 1}}}));
    EXPECT_FALSE(validate(Clip{.ball = Ball{.radiusMm = -1}}));
    EXPECT_FALSE(validate(Clip{.ball = Ball{.radiusMm = std::numeric_limits<double>::infinity()}}));
    Clip window;
    window.greyFaces = DisplayWindow{.center = 0, .width = 0, .explanation = {}, .function = {}};
    EXPECT_FALSE(validate(window));
    EXPECT_EQ(validate(window).error().code, ErrorCode::usage);
}

}  // namespace
}  // namespace macula::trace
