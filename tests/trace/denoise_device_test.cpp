// The denoiser on the device against its maths in double, and denoising as users of the tracer meet it.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>

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
        const float pixelAngle = picture.push().pixelAngle;
        ASSERT_TRUE(denoiser.run(film, before, nullptr, pixelAngle, Denoising::little).ok());
        const auto littleResult = gpu::read<glm::vec4>(denoiser.result());
        ASSERT_TRUE(denoiser.run(film, before, nullptr, pixelAngle, Denoising::on).ok());
        const auto firstResult = gpu::read<glm::vec4>(denoiser.result());
        denoiser.advance();
        upload(film, second);
        upload(now, moved);
        ASSERT_TRUE(denoiser.run(film, now, &before, pixelAngle, Denoising::on).ok());
        const auto secondResult = gpu::read<glm::vec4>(denoiser.result());

        const DenoiseRecord record = denoiseGather(picture.push(), first, guides, guides, {});
        const auto littleExpected = denoised(picture.push(), record, guides, Denoising::little);
        const auto firstExpected = denoised(picture.push(), record, guides);
        shared::DenoisePush push = picture.push();
        push.historySamples = 32;
        const auto secondExpected = denoised(push, denoiseGather(push, second, moved, guides, record), moved);
        for (std::size_t i = 0; i < firstExpected.size(); ++i) {
            for (int c = 0; c < 4; ++c) {
                EXPECT_NEAR((*littleResult)[i][c], littleExpected[i][c],
                            2e-4 * (1 + std::abs(littleExpected[i][c])));
                EXPECT_NEAR((*firstResult)[i][c], firstExpected[i][c],
                            2e-4 * (1 + std::abs(firstExpected[i][c])));
                EXPECT_NEAR((*secondResult)[i][c], secondExpected[i][c],
                            2e-4 * (1 + std::abs(secondExpected[i][c])));
            }
        }
    }
}

// Where many pixels stand out alone.
TEST_F(DenoiseOnDevice, SpecksAreThoseOfTheReference) {
    const TruePicture picture = softTissue(40);
    const DenoiseGuides values = picture.guides();
    Denoiser denoiser = std::move(*Denoiser::create(device(), *DenoiseKernels::create(device()), 40, 40));
    const Film film = std::move(*Film::create(device(), 40, 40));
    const Guides guides = std::move(*Guides::create(device(), 40, 40));
    upload(guides, values);
    for (const std::uint32_t samples : {1u, 4u}) {
        const DenoiseFilm noisy = picture.film(samples, samples);
        upload(film, noisy);
        ASSERT_TRUE(denoiser.run(film, guides, nullptr, picture.push().pixelAngle, Denoising::on).ok());
        const auto result = gpu::read<glm::vec4>(denoiser.result());
        const auto variances = gpu::read<float>(**denoiser.variances(guides));
        std::vector<glm::dvec4> masses;
        const DenoiseRecord record = denoiseGather(picture.push(), noisy, values, values, {});
        const DenoiseState state = filtered(picture.push(), record, values, masses);
        const auto expected = denoiseSpecks(picture.push(), state, values, masses);
        const auto expectedVariances = denoiseVariances(picture.push(), record, state, values, masses);
        int changed = 0;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            for (int c = 0; c < 4; ++c)
                EXPECT_NEAR((*result)[i][c], expected[i][c], 2e-4 * (1 + std::abs(expected[i][c]))) << i;
            EXPECT_NEAR((*variances)[i], expectedVariances[i], 1e-3 * expectedVariances[i]) << i;
            changed += std::abs(expected[i].y - state.colours[i].y) > 0.02 ? 1 : 0;
        }
        EXPECT_GT(changed, 40) << samples;
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
        ASSERT_TRUE(denoiser.run(film, guides, nullptr, 0.001f, Denoising::on).ok());
        const auto result = gpu::read<glm::vec4>(denoiser.result());
        for (const glm::vec4& pixel : *result) {
            ASSERT_TRUE(std::isfinite(pixel.x + pixel.y + pixel.z + pixel.w)) << value;
            ASSERT_TRUE(pixel.w >= 0.0f && pixel.w <= 1.0f);
        }
    }
}

constexpr int kBounces = 4;  // of what is traced here

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

double alphaError(const TracedImage& image, const TracedImage& truth) {
    double sum = 0.0;
    for (std::size_t i = 0; i < truth.radiance.size(); ++i)
        sum += std::pow(double(image.radiance[i].a) - double(truth.radiance[i].a), 2.0);
    return sum;
}

TEST_F(DenoiseOnDevice, OfATracedPictureKeepsItsLightAndIsNearerToTheTruth) {
    const Scene scene;
    const Environment sky = Environment::constant(glm::vec3(1.0f));
    PathTracer t = tracer(scene.volume, scene.bone, sky, scene.view, {.bounces = kBounces, .seed = 1});
    ASSERT_TRUE(*t.trace(256));
    const auto truth = t.readback();
    EXPECT_FALSE(truth->denoised);
    EXPECT_FALSE(t.statistics()->denoised);
    ASSERT_TRUE(t.setSettings({.bounces = kBounces, .seed = 2}).ok());
    ASSERT_TRUE(*t.trace(4));
    const auto noisy = t.readback();
    // Asking for it does not begin the picture anew, and still pictures are still.
    ASSERT_TRUE(t.setSettings({.bounces = kBounces, .seed = 2, .denoising = Denoising::on}).ok());
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
    ASSERT_TRUE(t.setSettings({.bounces = kBounces, .seed = 2}).ok());
    EXPECT_NE(*shown, *t.readDisplay(glm::vec3(0.0f)));
    EXPECT_EQ(t.readback()->radiance, noisy->radiance);  // nothing was lost
}

// Whatever is seen, from one sample to many, and whatever the random numbers: the filtered picture is nearer
// to the truth than the plain one, in light and in alpha, and as bright.
TEST_F(DenoiseOnDevice, IsNeverWorseThanThePlainPicture) {
    constexpr int kSeeds = 3;
    LightRig lamp;
    lamp.ambientHorizon = {0.2, 0.2, 0.25};
    lamp.lights = {{.azimuthDeg = 40, .elevationDeg = 30, .angularRadiusDeg = 8, .radiance = 20}};
    struct Case {
        const char* name;
        TransferFunction function;
        Environment environment;
        Clip clip;
    };
    const Scene scene;
    TransferFunction soft = scenes::homogeneous(1.0, 0.95);
    soft.opacity = {{-200, 0.0}, {50, 0.01}, {200, 0.03}, {800, 0.3}};
    soft.colour = {{-200, {0.9, 0.5, 0.4}}, {100, {0.8, 0.3, 0.2}}, {400, {1, 0.95, 0.85}}};
    Clip open{.planes = {{{0, 1, 0}, -20.0}}};
    open.greyFaces = DisplayWindow{.center = 40, .width = 400, .explanation = {}, .function = {}};
    const Case cases[] = {{"bone, even light", scene.bone, Environment::constant(glm::vec3(1.0f)), {}},
                          {"soft, a lamp", soft, Environment::fromRig(lamp), {}},
                          {"soft, cut open, grey faces", soft, Environment::fromRig(lamp), open}};
    View view = scene.view;
    view.width = view.height = 40;
    PathTracer t = tracer(scene.volume, scene.bone, cases[0].environment, view, {});
    for (const Case& seen : cases) {
        SCOPED_TRACE(seen.name);
        ASSERT_TRUE(t.scene().setTransferFunction(seen.function).ok());
        ASSERT_TRUE(t.scene().setEnvironment(seen.environment).ok());
        ASSERT_TRUE(t.scene().setClip(seen.clip).ok());
        ASSERT_TRUE(t.setSettings({.bounces = kBounces, .seed = 1000}).ok());
        ASSERT_TRUE(*t.trace(160));
        const auto truth = t.readback();
        for (const std::uint32_t samples : {1u, 4u, 64u}) {
            for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
                SCOPED_TRACE(fmt::format("{} samples, seed {}", samples, seed));
                ASSERT_TRUE(
                    t.scene().setTransferFunction(seen.function).ok());  // nothing is known from before
                ASSERT_TRUE(t.setSettings({.bounces = kBounces, .seed = seed}).ok());
                ASSERT_TRUE(*t.trace(samples));
                const auto plain = t.readback();
                ASSERT_TRUE(
                    t.setSettings({.bounces = kBounces, .seed = seed, .denoising = Denoising::on}).ok());
                const auto filtered = t.readback();
                // The truth is noisy too, as much for both. With many samples there is little to gain, of
                // grey faces least, which have no noise but at their edges.
                const bool many = samples == 64;
                const double most = !many ? 0.85 : seen.clip.greyFaces ? 1.0 : 0.9;
                EXPECT_LT(squaredError(*filtered, *truth), most * squaredError(*plain, *truth));
                EXPECT_LT(alphaError(*filtered, *truth), (many ? 1.02 : 0.85) * alphaError(*plain, *truth));
                ASSERT_TRUE(
                    t.setSettings({.bounces = kBounces, .seed = seed, .denoising = Denoising::little}).ok());
                const auto little = t.readback();  // of the same samples
                EXPECT_NE(little->radiance, filtered->radiance);
                EXPECT_LT(squaredError(*little, *truth), squaredError(*plain, *truth));
                for (const auto& picture : {filtered, little}) {
                    const glm::dvec4 kept = total(picture->radiance) / total(plain->radiance);
                    for (int c = 0; c < 3; ++c) EXPECT_NEAR(kept[c], 1.0, 1e-4);
                    EXPECT_NEAR(kept.a, 1.0, 0.003);  // it is clamped to 0 to 1
                }
            }
        }
    }
}

TEST_F(DenoiseOnDevice, ASeriesUsesTheViewBeforeAndAnyChangeOfMatterOrLightForgetsIt) {
    const Scene scene;
    const Environment sky = Environment::constant(glm::vec3(1.0f));
    View next = scene.view;
    next.camera.positionMm += glm::dvec3(8, 0, 4);
    const auto at = [&](bool before, const std::function<void(PathTracer&)>& change) {
        PathTracer t = tracer(scene.volume, scene.bone, sky, before ? scene.view : next,
                              {.bounces = kBounces, .seed = 1, .denoising = Denoising::on});
        if (before) {
            EXPECT_TRUE(*t.trace(8));
            EXPECT_TRUE(t.display(glm::vec3(0.0f)).ok());
            EXPECT_TRUE(t.setView(next).ok());
        }
        change(t);
        EXPECT_TRUE(t.setSettings({.bounces = kBounces, .seed = 2, .denoising = Denoising::on}).ok());
        EXPECT_TRUE(*t.trace(1));
        return *t.readback();
    };
    PathTracer t = tracer(scene.volume, scene.bone, sky, next, {.bounces = kBounces, .seed = 5});
    ASSERT_TRUE(*t.trace(256));
    const auto truth = t.readback();
    const auto nothing = [](PathTracer&) {};
    const TracedImage alone = at(false, nothing);
    EXPECT_LT(squaredError(at(true, nothing), *truth), 0.8 * squaredError(alone, *truth));
    EXPECT_EQ(at(true, [&](PathTracer& p) { EXPECT_TRUE(p.scene().setTransferFunction(scene.bone).ok()); })
                  .radiance,
              alone.radiance);
    EXPECT_EQ(at(true, [&](PathTracer& p) { EXPECT_TRUE(p.scene().setEnvironment(sky).ok()); }).radiance,
              alone.radiance);
    EXPECT_EQ(at(true, [&](PathTracer& p) { EXPECT_TRUE(p.scene().setClip({}).ok()); }).radiance,
              alone.radiance);
    EXPECT_EQ(at(true,
                 [&](PathTracer& p) {
                     EXPECT_TRUE(p.scene().setVolume(scene.volume).ok());
                     EXPECT_TRUE(p.scene().setTransferFunction(scene.bone).ok());
                 })
                  .radiance,
              alone.radiance);
}

// A gaze that wanders shows the same things, stored elsewhere; one that jumps looks where little was known.
// So do a turn, and settings that change the light.
TEST_F(DenoiseOnDevice, ASmallMoveOfTheGazeKeepsWhatWasKnownAndAJumpForgetsIt) {
    const Scene scene;
    const Environment sky = Environment::constant(glm::vec3(1.0f));
    View first = scene.view;
    first.width = first.height = 40;
    first.foveation = Foveation{.gaze = {0.1, 0.0}, .fieldDeg = 8.0, .magnification = 2.0};
    const Settings plain{.bounces = kBounces, .seed = 2, .denoising = Denoising::on};
    PathTracer t = tracer(scene.volume, scene.bone, sky, first, plain);
    // The first picture of one sample of what is asked for, after a picture of eight from `first`, or after
    // none.
    const auto after = [&](bool before, const View& view, const Settings& settings, const Clip& clip = {}) {
        Settings other = plain;
        other.seed = 1;
        EXPECT_TRUE(t.scene().setClip({}).ok() && t.setView(first).ok() && t.setSettings(other).ok());
        EXPECT_TRUE(t.scene().setTransferFunction(scene.bone).ok());  // forgets
        EXPECT_TRUE(*t.trace(8));
        EXPECT_TRUE(t.display(glm::vec3(0.0f)).ok());
        if (!before) {
            EXPECT_TRUE(t.scene().setTransferFunction(scene.bone).ok());
        }
        if (!clip.isNothing()) {
            EXPECT_TRUE(t.scene().setClip(clip).ok());
        }
        EXPECT_TRUE(t.setView(view).ok() && t.setSettings(settings).ok());
        EXPECT_TRUE(*t.trace(1));
        return *t.readback();
    };
    View near = first;
    near.foveation->gaze = {0.15, 0.03};
    const TracedImage known = after(true, near, plain);
    const TracedImage alone = after(false, near, plain);
    ASSERT_TRUE(t.setSettings({.bounces = kBounces, .seed = 5}).ok());
    ASSERT_TRUE(*t.trace(160));
    const auto truth = t.readback();
    EXPECT_LT(squaredError(known, *truth), 0.8 * squaredError(alone, *truth));

    View jumped = first;
    jumped.foveation->gaze = {0.1, 0.4};
    View elsewhere = first;  // the same gaze in a picture turned by 30 degrees
    elsewhere.camera.positionMm =
        glm::dvec3(glm::rotate(glm::dmat4(1.0), glm::radians(30.0), glm::dvec3(0, 0, 1)) *
                   glm::dvec4(first.camera.positionMm - first.camera.targetMm, 0.0)) +
        first.camera.targetMm;
    View unfoveated = first;
    unfoveated.foveation = {};
    for (const View& view : {jumped, elsewhere, unfoveated})
        EXPECT_EQ(after(true, view, plain).radiance, after(false, view, plain).radiance);

    Settings brighter = plain;
    brighter.lightStrength = 1.2;
    Settings fewer = plain;
    fewer.bounces = 2;
    Settings turned = plain;
    turned.lightRotationDeg = 20.0;
    Settings clear = plain;
    clear.look = Look::clear;
    for (const Settings& settings : {brighter, fewer, turned, clear})
        EXPECT_EQ(after(true, near, settings).radiance, after(false, near, settings).radiance);
    const Clip clip{.planes = {{{0, 1, 0}, 0.0}}};
    EXPECT_EQ(after(true, near, plain, clip).radiance, after(false, near, plain, clip).radiance);
    // Exposure is of the display alone, and changes nothing that was known.
    Settings exposed = plain;
    exposed.exposure = 2.0;
    EXPECT_EQ(after(true, near, exposed).radiance, known.radiance);
}

// Lights on the camera turn with it, and matter is lit otherwise: a turn of three degrees forgets what half a
// degree keeps; lights on the patient stay where they are.
TEST_F(DenoiseOnDevice, ATurnForgetsSoonerWhereTheLightsTurnWithIt) {
    const Scene scene;
    View first = scene.view;
    first.width = first.height = 24;
    const auto turned = [&](double degrees) {
        View view = first;
        const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), glm::radians(degrees), glm::dvec3(0, 0, 1));
        view.camera.positionMm =
            glm::dvec3(turn * glm::dvec4(first.camera.positionMm - first.camera.targetMm, 0.0)) +
            first.camera.targetMm;
        return view;
    };
    for (const LightFrame frame : {LightFrame::camera, LightFrame::patient}) {
        LightRig rig;
        rig.frame = frame;
        rig.ambientHorizon = {0.5, 0.5, 0.5};
        rig.lights = {{.azimuthDeg = 60, .elevationDeg = 30, .angularRadiusDeg = 20, .radiance = 5}};
        const Settings settings{.bounces = kBounces, .seed = 2, .denoising = Denoising::on};
        PathTracer t = tracer(scene.volume, scene.bone, Environment::fromRig(rig), first, settings);
        const auto keeps = [&](double degrees) {
            std::vector<glm::vec4> pictures[2];
            for (const bool known : {false, true}) {
                Settings other = settings;
                other.seed = 1;
                EXPECT_TRUE(t.setView(first).ok() && t.setSettings(other).ok());
                EXPECT_TRUE(*t.trace(4));
                EXPECT_TRUE(t.display(glm::vec3(0.0f)).ok());
                if (!known) {
                    EXPECT_TRUE(t.scene().setTransferFunction(scene.bone).ok());  // forgets
                }
                EXPECT_TRUE(t.setView(turned(degrees)).ok() && t.setSettings(settings).ok());
                EXPECT_TRUE(*t.trace(1));
                pictures[known ? 1 : 0] = t.readback()->radiance;
            }
            return pictures[0] != pictures[1];
        };
        EXPECT_TRUE(keeps(0.5));
        EXPECT_EQ(keeps(3.0), frame == LightFrame::patient);
        EXPECT_FALSE(keeps(25.0));
    }
}

// The variance that the film reports, by the textbook: from the samples one by one, and of coverage, where
// each sample is a coin of known odds, by what it truly is.
TEST_F(DenoiseOnDevice, VarianceIsThatOfTheSamples) {
    const auto [volume, view] = scenes::slab(10.0, 64);
    PathTracer t =
        tracer(volume, scenes::homogeneous(0.2), Environment::constant(glm::vec3(1.0f)), view, {.seed = 3});
    constexpr int kSamples = 5;
    const auto values = [](const TracedImage& image) {  // luminance and coverage
        std::vector<glm::dvec2> result;
        for (const glm::vec4& pixel : image.radiance)
            result.emplace_back(glm::dot(glm::dvec3(pixel), glm::dvec3(0.2126, 0.7152, 0.0722)), pixel.a);
        return result;
    };
    std::vector<std::vector<glm::dvec2>> sums;
    std::optional<TracedImage> image;
    for (int n = 1; n <= kSamples; ++n) {
        ASSERT_TRUE(*t.trace(1));
        image = *t.readback();
        sums.push_back(values(*image));
        for (glm::dvec2& value : sums.back()) value *= n;
        if (n > 1) continue;
        for (const glm::vec2& variance : image->variance) EXPECT_TRUE(std::isinf(variance.x));
    }
    double ofCoverage = 0.0;
    for (std::size_t i = 0; i < image->variance.size(); ++i) {
        const glm::dvec2 mean = sums.back()[i] / double(kSamples);
        glm::dvec2 squares(0.0);
        for (std::size_t n = 0; n < kSamples; ++n) {
            const glm::dvec2 off = sums[n][i] - (n > 0 ? sums[n - 1][i] : glm::dvec2(0.0)) - mean;
            squares += off * off;
        }
        const glm::dvec2 exact = squares / double(kSamples * (kSamples - 1));
        ASSERT_NEAR(double(image->variance[i].x), exact.x, 1e-5 * (1.0 + exact.x)) << i;
        ASSERT_NEAR(double(image->variance[i].y), exact.y, 1e-5) << i;
        ofCoverage += double(image->variance[i].y);
    }
    ofCoverage /= double(image->variance.size());
    const double odds = -std::expm1(-2.0);
    const double truth = odds * (1.0 - odds) / kSamples;
    // Of a coin's variance by n tosses: the fourth moment, and the square of the second.
    const double fourth = odds * (1.0 - odds) * (1.0 - 3.0 * odds * (1.0 - odds));
    const double second = odds * (1.0 - odds);
    const double uncertain =
        std::sqrt((fourth - second * second * (kSamples - 3.0) / (kSamples - 1.0)) / kSamples) / kSamples /
        std::sqrt(double(image->variance.size()));
    EXPECT_NEAR(ofCoverage, truth, 4.5 * uncertain);
    EXPECT_LT(4.5 * uncertain, 0.1 * truth);  // without n / (n - 1) it would be a fifth less
}

}  // namespace
}  // namespace macula::trace
