// The denoiser on the device against its maths in double, and denoising as users of the tracer meet it.
#include <cmath>

#include "base/phantom.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/trace/denoiser.h"
#include "trace/denoise_pictures.h"
#include "trace/gpu_scene.h"
#include "trace/scenes.h"

namespace macula::trace {
namespace {

using DenoiseOnDevice = DeviceTest;

std::vector<glm::vec4> narrowed(const std::vector<glm::dvec4>& values) {
    return {values.begin(), values.end()};
}

void upload(const Guides& guides, const DenoiseGuides& values) {
    ASSERT_TRUE(gpu::uploadTo<glm::vec4>(guides.surfaces().buffer(), narrowed(values.surfaces)).ok());
    ASSERT_TRUE(gpu::uploadTo<glm::vec4>(guides.matters().buffer(), narrowed(values.matters)).ok());
    ASSERT_TRUE(gpu::uploadTo<glm::vec4>(guides.motions().buffer(), narrowed(values.motions)).ok());
}

void upload(const Film& film, const DenoiseFilm& values) {
    std::vector<glm::vec2> squares;
    for (const double square : values.squares) squares.emplace_back(square, 0.0);
    ASSERT_TRUE(gpu::uploadTo<glm::vec4>(film.sums(), narrowed(values.sums)).ok());
    ASSERT_TRUE(gpu::uploadTo<std::uint32_t>(film.counts(), values.counts).ok());
    ASSERT_TRUE(gpu::uploadTo<glm::vec2>(film.squares(), squares).ok());
}

// Two views, the second with the history of the first: all kernels, compared pixel by pixel.
TEST_F(DenoiseOnDevice, IsThatOfTheReference) {
    for (const auto& [width, height] :
         {std::pair(48, 48), std::pair(1, 1), std::pair(1, 37), std::pair(53, 1)}) {
        const TruePicture whole = scenery(std::max(width, height));
        const TruePicture picture(
            width, height, [&](int x, int y) { return whole.pixels[std::size_t(y * whole.width + x)]; });
        const DenoiseGuides guides = picture.guides();
        DenoiseGuides moved = guides;
        for (glm::dvec4& motion : moved.motions) motion += glm::dvec4(1.25, -0.5, 0, 0);
        DenoiseFilm first = picture.film(4, 1);
        const DenoiseFilm second = picture.film(2, 2);
        first.sums[first.sums.size() / 2] = glm::dvec4(4e6, 4e6, 4e6, 4);  // a firefly
        first.squares[first.sums.size() / 2] = 1.6e13;

        Denoiser denoiser =
            std::move(*Denoiser::create(device(), *DenoiseKernels::create(device()), width, height));
        const Film film = std::move(*Film::create(device(), width, height));
        const Guides before = std::move(*Guides::create(device(), width, height));
        const Guides now = std::move(*Guides::create(device(), width, height));
        upload(film, first);
        upload(before, guides);
        ASSERT_TRUE(denoiser.run(film, before, nullptr, picture.push().pixelAngle).ok());
        const auto firstResult = gpu::read<glm::vec4>(denoiser.result());
        denoiser.advance();
        upload(film, second);
        upload(now, moved);
        ASSERT_TRUE(denoiser.run(film, now, &before, picture.push().pixelAngle).ok());
        const auto secondResult = gpu::read<glm::vec4>(denoiser.result());

        const DenoiseRecord record = denoiseGather(picture.push(), first, guides, guides, {});
        const auto firstExpected = denoised(picture.push(), record, guides);
        shared::DenoisePush push = picture.push();
        push.historySamples = 32;
        const auto secondExpected = denoised(push, denoiseGather(push, second, moved, guides, record), moved);
        for (std::size_t i = 0; i < firstExpected.size(); ++i) {
            for (int c = 0; c < 4; ++c) {
                EXPECT_NEAR((*firstResult)[i][c], firstExpected[i][c],
                            2e-4 * (1 + std::abs(firstExpected[i][c])));
                EXPECT_NEAR((*secondResult)[i][c], secondExpected[i][c],
                            2e-4 * (1 + std::abs(secondExpected[i][c])));
            }
        }
    }
}

TEST_F(DenoiseOnDevice, TakesWhateverAFilmMayHold) {
    const TruePicture picture = scenery(24);
    Denoiser denoiser = std::move(*Denoiser::create(device(), *DenoiseKernels::create(device()), 24, 24));
    const Film film = std::move(*Film::create(device(), 24, 24));
    const Guides guides = std::move(*Guides::create(device(), 24, 24));
    upload(guides, picture.guides());
    for (const double value : {std::nan(""), double(INFINITY), 3e38, -1.0}) {
        DenoiseFilm values = picture.film(4, 2);
        values.sums[300] = glm::dvec4(value, value, value, 4.0);
        values.squares[300] = value * value;
        upload(film, values);
        ASSERT_TRUE(denoiser.run(film, guides, nullptr, 0.001f).ok());
        const auto result = gpu::read<glm::vec4>(denoiser.result());
        for (const glm::vec4& pixel : *result) {
            ASSERT_TRUE(std::isfinite(pixel.x + pixel.y + pixel.z + pixel.w)) << value;
            ASSERT_TRUE(pixel.w >= 0.0f && pixel.w <= 1.0f);
        }
    }
}

struct Scene {
    std::shared_ptr<const Volume> volume = std::make_shared<const Volume>(
        phantom::make({.size = {128, 112, 80}, .spacingMm = {2.4, 2.4, 3.75}}));
    TransferFunction bone = [] {
        TransferFunction function = scenes::homogeneous(1.0, 0.9);
        function.opacity = {{150, 0.0}, {400, 0.8}};
        return function;
    }();
    View view{
        .camera = frameBox(volume->worldBox(), ViewDirection::anterior, 30, 1.0), .width = 80, .height = 80};
};

glm::dvec4 total(const std::vector<glm::vec4>& pixels) {
    glm::dvec4 sum(0.0);
    for (const glm::vec4& pixel : pixels) sum += glm::dvec4(pixel);
    return sum;
}

double squaredError(const TracedImage& image, const TracedImage& truth) {
    double sum = 0.0;
    for (std::size_t i = 0; i < truth.radiance.size(); ++i) {
        const glm::dvec4 off(image.radiance[i] - truth.radiance[i]);
        sum += glm::dot(off, off);
    }
    return sum;
}

TEST_F(DenoiseOnDevice, OfATracedPictureKeepsItsLightAndIsNearerToTheTruth) {
    const Scene scene;
    const Environment sky = Environment::constant(glm::vec3(1.0f));
    PathTracer t = tracer(scene.volume, scene.bone, sky, scene.view, {.seed = 1});
    ASSERT_TRUE(*t.trace(256));
    const auto truth = t.readback();
    EXPECT_FALSE(truth->denoised);
    EXPECT_FALSE(t.statistics()->denoised);
    ASSERT_TRUE(t.setSettings({.seed = 2}).ok());
    ASSERT_TRUE(*t.trace(4));
    const auto noisy = t.readback();
    // Asking for it does not begin the picture anew, and still pictures are still.
    ASSERT_TRUE(t.setSettings({.seed = 2, .denoising = Denoising::on}).ok());
    EXPECT_EQ(t.statistics()->samplesPerPixel, 4u);
    EXPECT_TRUE(t.statistics()->denoised);
    const auto filtered = t.readback();
    EXPECT_TRUE(filtered->denoised);
    EXPECT_EQ(t.readback()->radiance, filtered->radiance);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(total(filtered->radiance)[c] / total(noisy->radiance)[c], 1.0, 1e-4);
    EXPECT_NEAR(total(filtered->radiance).w / total(noisy->radiance).w, 1.0, 0.003);
    EXPECT_LT(squaredError(*filtered, *truth), 0.35 * squaredError(*noisy, *truth));
    const auto shown = t.readDisplay(glm::vec3(0.0f));
    ASSERT_TRUE(t.setSettings({.seed = 2}).ok());
    EXPECT_NE(*shown, *t.readDisplay(glm::vec3(0.0f)));
    EXPECT_EQ(t.readback()->radiance, noisy->radiance);  // nothing was lost
}

TEST_F(DenoiseOnDevice, ASeriesUsesTheViewBeforeAndAnyChangeOfMatterOrLightForgetsIt) {
    const Scene scene;
    const Environment sky = Environment::constant(glm::vec3(1.0f));
    View next = scene.view;
    next.camera.positionMm += glm::dvec3(8, 0, 4);
    const auto at = [&](bool before, const std::function<void(PathTracer&)>& change) {
        PathTracer t = tracer(scene.volume, scene.bone, sky, before ? scene.view : next,
                              {.seed = 1, .denoising = Denoising::on});
        if (before) {
            EXPECT_TRUE(*t.trace(8));
            EXPECT_TRUE(t.display(glm::vec3(0.0f)).ok());
            EXPECT_TRUE(t.setView(next).ok());
        }
        change(t);
        EXPECT_TRUE(t.setSettings({.seed = 2, .denoising = Denoising::on}).ok());
        EXPECT_TRUE(*t.trace(1));
        return *t.readback();
    };
    PathTracer t = tracer(scene.volume, scene.bone, sky, next, {.seed = 5});
    ASSERT_TRUE(*t.trace(256));
    const auto truth = t.readback();
    const auto nothing = [](PathTracer&) {};
    const TracedImage alone = at(false, nothing);
    EXPECT_LT(squaredError(at(true, nothing), *truth), 0.8 * squaredError(alone, *truth));
    EXPECT_EQ(at(true, [&](PathTracer& p) { EXPECT_TRUE(p.setTransferFunction(scene.bone).ok()); }).radiance,
              alone.radiance);
    EXPECT_EQ(at(true, [&](PathTracer& p) { EXPECT_TRUE(p.setEnvironment(sky).ok()); }).radiance,
              alone.radiance);
    EXPECT_EQ(at(true, [&](PathTracer& p) { EXPECT_TRUE(p.setClip({}).ok()); }).radiance, alone.radiance);
    EXPECT_EQ(at(true,
                 [&](PathTracer& p) {
                     EXPECT_TRUE(p.setVolume(scene.volume).ok());
                     EXPECT_TRUE(p.setTransferFunction(scene.bone).ok());
                 })
                  .radiance,
              alone.radiance);
}

// The variance that the film reports is that of means over many pictures.
TEST_F(DenoiseOnDevice, VarianceIsThatOfRepeatedPictures) {
    const auto [volume, view] = scenes::slab(10.0, 32);
    PathTracer t = tracer(volume, scenes::homogeneous(0.2), Environment::constant(glm::vec3(1.0f)), view, {});
    ASSERT_TRUE(*t.trace(1));
    const auto once = t.readback();
    for (const glm::vec2& variance : once->variance) EXPECT_TRUE(std::isinf(variance.x));
    ASSERT_TRUE(t.setSettings({.seed = 3}).ok());
    ASSERT_TRUE(*t.trace(16));
    const auto image = t.readback();
    // All pixels see the same: the spread between them is the variance within them.
    glm::dvec2 sum(0.0), squares(0.0), variance(0.0);
    for (std::size_t i = 0; i < image->radiance.size(); ++i) {
        const glm::dvec2 value(glm::dot(glm::dvec3(image->radiance[i]), glm::dvec3(0.2126, 0.7152, 0.0722)),
                               image->radiance[i].a);
        sum += value;
        squares += value * value;
        variance += glm::dvec2(image->variance[i]);
    }
    const double n = double(image->radiance.size());
    const glm::dvec2 between = squares / n - sum / n * (sum / n);
    // A variance of n values is uncertain by sqrt(2 / n), 4.4 %.
    EXPECT_NEAR(variance.x / n / between.x, 1.0, 0.2);
    EXPECT_NEAR(variance.y / n / between.y, 1.0, 0.2);
}

}  // namespace
}  // namespace macula::trace
