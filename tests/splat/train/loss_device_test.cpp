// The loss on the device against the reference in double.
#include <bit>
#include <limits>

#include "gpu/shared_device.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/splat/train/loss.h"
#include "splat/train/loss_pictures.h"

namespace macula::splat {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<glm::vec4> narrowed(const Pixels& pixels) {
    return {pixels.begin(), pixels.end()};
}

// Both ways, whatever the device.
class LossOnDevice : public gpu::SharedDeviceTest, public testing::WithParamInterface<LossWork> {
  protected:
    static const std::shared_ptr<const LossKernels>& kernels() {
        static const std::shared_ptr<const LossKernels> strips =
            *LossKernels::create(device(), LossWork::byStrips);
        static const std::shared_ptr<const LossKernels> tiles =
            *LossKernels::create(device(), LossWork::byTiles);
        return GetParam() == LossWork::byTiles ? tiles : strips;
    }
    static DevicePicture uploaded(int width, int height, const Pixels& pixels) {
        return std::move(*DevicePicture::upload(device(), "picture", width, height, narrowed(pixels)));
    }

    struct Outcome {
        shared::SplatLossResult result{};
        std::vector<glm::vec4> gradient;
        std::uint64_t unknownPixels = 0;
    };
    static Outcome run(int width, int height, const Pixels& render, const Pixels& target,
                       const LossOptions& options, const LossStep& step) {
        const DevicePicture drawn = uploaded(width, height, render);
        const LossTarget truth = std::move(*LossTarget::create(*kernels(), uploaded(width, height, target)));
        Loss loss =
            std::move(*Loss::create(device(), kernels(), std::uint64_t(width) * std::uint64_t(height)));
        auto recorder = std::move(*gpu::Recorder::create(device(), "test"));
        loss.record(recorder, drawn, truth, options, step);
        EXPECT_TRUE(recorder.submit().ok());
        return {*loss.read(), *loss.gradient().read(), *truth.unknownPixels()};
    }

    // Values to 5e-5, gradients to 1e-4 of the largest one.
    static void expectAsReference(int width, int height, const Pixels& render, const Pixels& target,
                                  const LossOptions& options, const LossStep& step) {
        const ReferenceLoss expected = referenceLoss(width, height, render, target, options, step);
        const Outcome outcome = run(width, height, render, target, options, step);
        const double rounding = roundingOfOnePixel(render, target, options, step);
        EXPECT_NEAR(outcome.result.loss, expected.loss,
                    5e-5 * (1e-3 + expected.loss) + rounding * double(step.viewWeight));
        EXPECT_NEAR(outcome.result.l1, expected.l1, 5e-5 * (1e-3 + expected.l1));
        EXPECT_NEAR(outcome.result.dssim, expected.dssim, 5e-5 * (1e-2 + expected.dssim) + rounding);
        EXPECT_EQ(outcome.result.badRendered, expected.badRendered);
        EXPECT_EQ(outcome.unknownPixels, expected.unknownPixels);
        const double tolerance = (1e-4 + rounding) * largest(expected.gradient);
        std::size_t compared = 0;
        for (std::size_t i = 0; i < render.size(); ++i) {
            if (expected.gradient[i] != glm::dvec4(0.0) && atKink(render[i], target[i], options, step, 1e-5))
                continue;
            ++compared;
            for (int c = 0; c < 4; ++c)
                ASSERT_NEAR(outcome.gradient[i][c], expected.gradient[i][c], tolerance)
                    << "pixel " << i << " " << c;
        }
        EXPECT_GE(compared * 100, render.size() * 98);
    }
};

TEST_P(LossOnDevice, IsThatOfTheReference) {
    for (const auto& [width, height] :
         {std::pair(1, 1), std::pair(1, 37), std::pair(53, 1), std::pair(7, 5), std::pair(75, 41)}) {
        for (const LossEncoding encode : {LossEncoding::none, LossEncoding::display}) {
            for (const float dssim : {0.0f, 0.2f, 1.0f}) {
                SCOPED_TRACE(fmt::format("{} x {}, encode {}, dssim {}", width, height, int(encode), dssim));
                const auto seed = static_cast<std::uint32_t>(width + 2 * height);
                expectAsReference(width, height, randomPicture(width, height, seed),
                                  randomPicture(width, height, seed + 1),
                                  {.dssimWeight = dssim, .encode = encode, .exposure = 1.3f},
                                  {.background = randomBackground(seed), .viewWeight = 2.5f});
            }
        }
    }
}

TEST_P(LossOnDevice, OfEachMeasureIsThatOfTheReference) {
    for (const LossMeasure measure : {LossMeasure::similar, LossMeasure::absolute, LossMeasure::squared}) {
        for (const LossEncoding encode : {LossEncoding::none, LossEncoding::display}) {
            for (const bool coverageOnly : {false, true}) {
                SCOPED_TRACE(fmt::format("{}, encode {}, {}", int(measure), int(encode), coverageOnly));
                const LossOptions options{.encode = encode, .exposure = 1.3f};
                const LossStep step{.measure = measure,
                                    .background = {0.3f, 0.9f, 0.1f},
                                    .viewWeight = 2.5f,
                                    .coverageOnly = coverageOnly};
                expectAsReference(53, 41, randomPicture(53, 41, 1), randomPicture(53, 41, 2), options, step);
            }
        }
    }
}

TEST_P(LossOnDevice, IsThatOfTheReferenceAtFullSizeAndOverAnyBackground) {
    const Pixels render = randomPicture(512, 512, 1);
    Pixels target = render;
    for (std::size_t i = 0; i < target.size(); ++i)
        target[i] = glm::dvec4(glm::vec4(render[i] * (0.5 + double(i % 512) / 600.0)));
    expectAsReference(512, 512, render, target, {.encode = LossEncoding::display},
                      {.background = {0.3f, 0.9f, 0.1f}});
    for (std::uint32_t seed = 0; seed < 8; ++seed)
        expectAsReference(40, 24, randomPicture(40, 24, seed), randomPicture(40, 24, seed + 100),
                          {.encode = seed % 2 == 0 ? LossEncoding::display : LossEncoding::none},
                          {.background = randomBackground(seed)});
}

// Whatever colours the target has; and the model's colours are not moved.
TEST_P(LossOnDevice, OfCoverageAloneKnowsNoColours) {
    const Pixels render = randomPicture(53, 41, 1);
    Pixels target = randomPicture(53, 41, 2);
    for (const LossEncoding encode : {LossEncoding::none, LossEncoding::display}) {
        const LossOptions options{.encode = encode, .exposure = 1.3f};
        const LossStep step{.background = {0.3f, 0.9f, 0.1f}, .viewWeight = 2.5f, .coverageOnly = true};
        expectAsReference(53, 41, render, target, options, step);
        const Outcome outcome = run(53, 41, render, target, options, step);
        EXPECT_GT(outcome.result.l1, 0.0f);
        double most = 0.0;
        for (const glm::vec4& pixel : outcome.gradient) {
            ASSERT_EQ(glm::vec3(pixel), glm::vec3(0.0f));
            most = std::max(most, double(std::abs(pixel.w)));
        }
        EXPECT_GT(most, 0.0);
        Pixels grey = target;
        for (glm::dvec4& pixel : grey) pixel = glm::dvec4(glm::dvec3(0.5), pixel.w);
        EXPECT_EQ(run(53, 41, render, grey, options, step).gradient, outcome.gradient);
    }
}

TEST_P(LossOnDevice, OfEqualPicturesIsNothingToTheLastBit) {
    const Pixels picture = randomPicture(61, 33, 3);
    for (const LossEncoding encode : {LossEncoding::none, LossEncoding::display}) {
        const Outcome outcome =
            run(61, 33, picture, picture, {.encode = encode}, {.background = {0.2f, 0.5f, 0.7f}});
        EXPECT_EQ(outcome.result.loss, 0.0f);
        EXPECT_EQ(outcome.result.dssim, 0.0f);
        for (const glm::vec4& pixel : outcome.gradient) ASSERT_EQ(pixel, glm::vec4(0.0f));
    }
}

TEST_P(LossOnDevice, LeavesOutWhatIsNotFinite) {
    Pixels render = randomPicture(40, 30, 5);
    Pixels target = randomPicture(40, 30, 6);
    target[0].x = kNan;
    target[615].w = kInfinity;
    target[616].y = -kInfinity;
    target[1199] = glm::dvec4(kNan);
    render[300].z = kNan;
    render[333].w = kInfinity;
    render[615].x = kNan;  // unknown as well
    for (const LossEncoding encode : {LossEncoding::none, LossEncoding::display})
        for (const LossMeasure measure : {LossMeasure::similar, LossMeasure::absolute, LossMeasure::squared})
            expectAsReference(40, 30, render, target, {.encode = encode},
                              {.measure = measure, .background = {0.9f, 0.5f, 0.1f}});
    const Outcome nothing = run(40, 30, render, filled(40, 30, glm::dvec4(kNan)), {}, {});
    EXPECT_EQ(nothing.result.loss, 0.0f);
    EXPECT_EQ(nothing.unknownPixels, 1200u);
    for (const glm::vec4& pixel : nothing.gradient) ASSERT_EQ(pixel, glm::vec4(0.0f));
}

TEST_P(LossOnDevice, TakesWhateverAPictureMayHold) {
    const Pixels zero = filled(24, 20, glm::dvec4(0.0));
    const Pixels one = filled(24, 20, glm::dvec4(1.0));
    std::mt19937 random(9);
    std::uniform_real_distribution<double> exponent(-30.0, 6.0);
    Pixels wild = zero;
    Pixels wilder = zero;
    for (std::size_t i = 0; i < wild.size(); ++i) {
        for (int c = 0; c < 4; ++c) {
            wild[i][c] = float(std::pow(10.0, exponent(random)));
            wilder[i][c] = float(std::pow(10.0, exponent(random)));
        }
        wild[i].w = std::min(wild[i].w, 1.0);
        wilder[i].w = std::min(wilder[i].w, 1.0);
    }
    const Pixels huge = filled(24, 20, glm::dvec4(3e38, -3e38, 3e38, 1.0));
    const std::pair<const Pixels*, const Pixels*> pairs[] = {{&zero, &zero},   {&zero, &one}, {&one, &zero},
                                                             {&one, &one},     {&wild, &one}, {&zero, &wild},
                                                             {&wild, &wilder}, {&huge, &one}, {&wild, &huge}};
    for (const auto& [render, target] : pairs) {
        for (const LossEncoding encode : {LossEncoding::none, LossEncoding::display}) {
            for (const LossMeasure measure : {LossMeasure::similar, LossMeasure::squared}) {
                const LossOptions options{.encode = encode};
                const LossStep step{.measure = measure, .background = {1.0f, 0.0f, 0.5f}};
                const Outcome outcome = run(24, 20, *render, *target, options, step);
                const ReferenceLoss expected = referenceLoss(24, 20, *render, *target, options, step);
                EXPECT_NEAR(outcome.result.l1, expected.l1, 1e-4 * (1e-2 + expected.l1));
                EXPECT_NEAR(outcome.result.dssim, expected.dssim, 0.02);
                for (const glm::vec4& pixel : outcome.gradient)
                    ASSERT_TRUE(std::isfinite(pixel.x + pixel.y + pixel.z + pixel.w));
            }
        }
    }
}

TEST_P(LossOnDevice, IsTheSameBitsEachTime) {
    const Pixels render = randomPicture(200, 90, 1);
    const Pixels target = randomPicture(200, 90, 2);
    const LossOptions options{.encode = LossEncoding::display};
    const LossStep step{.background = {0.4f, 0.6f, 0.1f}};
    const Outcome first = run(200, 90, render, target, options, step);
    for (int i = 0; i < 3; ++i) {
        const Outcome again = run(200, 90, render, target, options, step);
        EXPECT_EQ(std::bit_cast<std::uint32_t>(again.result.loss),
                  std::bit_cast<std::uint32_t>(first.result.loss));
        EXPECT_EQ(again.gradient, first.gradient);
    }
}

// Room is for pixels, whatever their shape; what was there before is not in the way.
TEST_P(LossOnDevice, ComparesPicturesOfAnyShapeInOneRoom) {
    Loss loss = std::move(*Loss::create(device(), kernels(), 75 * 41));
    EXPECT_EQ(loss.mostPixels(), 75u * 41u);
    const LossOptions options{.encode = LossEncoding::display};
    const LossStep step{.background = {0.3f, 0.9f, 0.1f}};
    for (const glm::ivec2 size : {glm::ivec2(75, 41), {1, 3075}, {3075, 1}, {7, 5}, {41, 75}, {1, 1}}) {
        SCOPED_TRACE(fmt::format("{} x {}", size.x, size.y));
        const Pixels render = randomPicture(size.x, size.y, 1);
        const Pixels target = randomPicture(size.x, size.y, 2);
        const Outcome alone = run(size.x, size.y, render, target, options, step);
        const LossTarget truth = std::move(*LossTarget::create(*kernels(), uploaded(size.x, size.y, target)));
        const DevicePicture drawn = uploaded(size.x, size.y, render);
        auto recorder = std::move(*gpu::Recorder::create(device(), "test"));
        loss.record(recorder, drawn, truth, options, step);
        ASSERT_TRUE(recorder.submit().ok());
        EXPECT_EQ(std::bit_cast<std::uint32_t>(loss.read()->loss),
                  std::bit_cast<std::uint32_t>(alone.result.loss));
        EXPECT_EQ(*loss.gradient().read(), alone.gradient);
    }
}

// On every device: 64 GiB in one buffer.
TEST_P(LossOnDevice, RoomThatThereIsNotIsAnError) {
    const auto loss = Loss::create(device(), kernels(), std::uint64_t(1) << 30);
    ASSERT_FALSE(loss.ok());
    EXPECT_EQ(loss.error().code, ErrorCode::outOfMemory);
}

// What all of it is for: a picture that follows the gradient becomes the target, alpha included.
TEST_P(LossOnDevice, LeadsToTheTarget) {
    const Pixels target = randomPicture(24, 24, 4);
    std::vector<glm::vec4> pixels = narrowed(filled(24, 24, {0.2, 0.2, 0.2, 0.5}));
    const LossTarget truth = std::move(*LossTarget::create(*kernels(), uploaded(24, 24, target)));
    Loss loss = std::move(*Loss::create(device(), kernels(), 24 * 24));
    float firstLoss = 0.0f;
    float lastLoss = 0.0f;
    for (int i = 0; i < 150; ++i) {
        const DevicePicture drawn = std::move(*DevicePicture::upload(device(), "picture", 24, 24, pixels));
        auto recorder = std::move(*gpu::Recorder::create(device(), "test"));
        loss.record(recorder, drawn, truth, {.encode = LossEncoding::display},
                    {.background = randomBackground(std::uint32_t(i))});
        ASSERT_TRUE(recorder.submit().ok());
        const auto gradient = *loss.gradient().read();
        const float rate = 0.05f * std::pow(0.97f, float(i));
        for (std::size_t p = 0; p < pixels.size(); ++p) pixels[p] -= rate * glm::sign(gradient[p]);
        lastLoss = (*loss.read()).loss;
        if (i == 0) firstLoss = lastLoss;
    }
    EXPECT_LT(lastLoss, 0.1f * firstLoss);
}

TEST_P(LossOnDevice, DownsamplesLikeTheReference) {
    const glm::ivec2 sizes[][2] = {
        {{7, 5}, {4, 3}}, {{64, 48}, {32, 24}}, {{1, 1}, {1, 1}}, {{1, 9}, {1, 5}}, {{101, 37}, {13, 37}}};
    for (const auto& [from, to] : sizes) {
        Pixels picture = randomPicture(from.x, from.y, 11);
        if (picture.size() > 40) picture[37].y = kNan;
        const DevicePicture source = uploaded(from.x, from.y, picture);
        const DevicePicture smaller = std::move(*DevicePicture::create(device(), "smaller", to.x, to.y));
        auto recorder = std::move(*gpu::Recorder::create(device(), "test"));
        recordDownsample(recorder, *kernels(), source, smaller);
        ASSERT_TRUE(recorder.submit().ok());
        const auto result = *smaller.read();
        const Pixels expected = referenceDownsample(picture, from, to);
        for (std::size_t i = 0; i < expected.size(); ++i)
            for (int c = 0; c < 4; ++c) {
                if (std::isfinite(expected[i][c]))
                    ASSERT_NEAR(result[i][c], expected[i][c], 1e-5);
                else
                    ASSERT_FALSE(std::isfinite(result[i][c]));
            }
    }
}

INSTANTIATE_TEST_SUITE_P(Work, LossOnDevice, testing::Values(LossWork::byStrips, LossWork::byTiles),
                         [](const auto& work) {
                             return work.param == LossWork::byStrips ? "byStrips" : "byTiles";
                         });

}  // namespace
}  // namespace macula::splat
