// Views that the tracer makes, truth that is kept, models that are drawn, on the device.
#include "pipeline/hybrid/views/view_tracing.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <numeric>
#include <span>

#include "hybrid/views/cache_folder.h"
#include "pipeline/hybrid/light/pixel_coverage.h"
#include "pipeline/hybrid/model/first_model.h"
#include "pipeline/hybrid/model/initial_splats.h"
#include "pipeline/hybrid/model/refinement.h"
#include "pipeline/hybrid/views/drawn_views.h"
#include "pipeline/hybrid/views/training_views.h"
#include "pipeline/hybrid/views/truth_pictures.h"
#include "pipeline/splat/draw/displayed.h"
#include "pipeline/splat/draw/reference_rasterizer.h"
#include "pipeline/trace/device_scene.h"
#include "trace/extreme_scenes.h"
#include "trace/gpu_scene.h"

namespace macula::hybrid {
namespace {

constexpr glm::ivec3 kSize{24, 24, 24};

class Views : public trace::DeviceTest {
  protected:
    const std::shared_ptr<const Volume> volume_ =
        scenes::volumeOf(kSize, scenes::grid(glm::dvec3(1.0), kSize), scenes::blob(kSize, 1000));
    const TransferFunction function_ = scenes::ramp(100, 500, 0.6, 1.0);
    const trace::Environment lights_ = trace::Environment::constant(glm::vec3(1.0f));

    trace::PathTracer tracer() const {
        return trace::DeviceTest::tracer(volume_, function_, lights_, scenes::lookAt(*volume_), {});
    }
    TracedScene scene() const { return *TracedScene::create(volume_, function_, {}, lights_); }
    std::vector<Camera> cameras(std::size_t count) const {
        std::vector<Camera> cameras;
        const auto views = samplePoses(scene().seenMm(), initialTraining(count));
        for (const SampledPose& view : *views) cameras.push_back(view.camera);
        return cameras;
    }
};

double meanDifference(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const glm::vec4 off = glm::abs(a[i] - b[i]);
        sum += double(off.x + off.y + off.z + off.w) / 4.0;
    }
    return sum / double(a.size());
}

bool same(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(glm::vec4)) == 0;
}

// 48 sides are enough, docs/peripheral-model.md.
TEST_F(Views, OfRefinementMakeOutlinesNeedless) {
    Progress progress;
    for (const std::size_t more : {44u, 46u}) {
        trace::PathTracer tracer = this->tracer();
        FirstModelOptions first{.points = {.count = 60, .paths = 2},
                                .views = 2,
                                .samplesPerPixel = 1,
                                .directions = 6,
                                .sizePx = 16,
                                .iterations = 6,
                                .capacity = 60};
        auto model = makeFirstModel(device(), tracer, scene().seenMm(), first, progress);
        ASSERT_TRUE(model.ok()) << model.error().message;
        splat::Trainer& trainer = model->trainer;
        ASSERT_EQ(trainer.viewCount(), 6u);
        const RefinementOptions options{
            .views = more, .samplesPerPixel = 1, .sizePx = 16, .iterations = 40, .capacity = 100};
        ASSERT_TRUE(beginRefinement(trainer, tracer, scene().seenMm(), options, progress).ok());
        EXPECT_EQ(trainer.viewCount(), more == 44 ? 50u : 48u);
        ASSERT_TRUE(trainer.step(40).ok());
        EXPECT_GT(trainer.report().splats, 60u);
    }
}

TEST_F(Views, OfSidesThatAreNotTracedAreLitWhereLightGoesToAllSidesAlike) {
    for (const double anisotropy : {0.0, 0.6}) {
        trace::PathTracer tracer = this->tracer();
        TransferFunction function = function_;
        function.anisotropy = anisotropy;
        ASSERT_TRUE(tracer.scene().setTransferFunction(function).ok());
        EXPECT_EQ(tracer.scene().anisotropy(), anisotropy);
        Progress progress;
        const FirstModelOptions options{.points = {.count = 60, .paths = 2},
                                        .views = 2,
                                        .samplesPerPixel = 3,
                                        .directions = 5,
                                        .sizePx = 24,
                                        .iterations = 8,
                                        .capacity = 60};
        auto model = makeFirstModel(device(), tracer, scene().seenMm(), options, progress);
        ASSERT_TRUE(model.ok()) << model.error().message;
        ASSERT_EQ(model->trainer.viewCount(), 5u);
        const auto expected = anisotropy == 0.0 ? splat::ViewKind::standIn : splat::ViewKind::outline;
        std::size_t others = 0;
        for (std::size_t i = 0; i < 5; ++i) {
            const splat::TrainingView& view = model->trainer.view(i);
            if (view.kind == splat::ViewKind::picture) continue;
            ++others;
            EXPECT_EQ(view.kind, expected);
            glm::vec3 light(0.0f);
            for (const glm::vec4& pixel : view.pixels)
                if (std::isfinite(pixel.r)) light += glm::vec3(pixel);
            EXPECT_EQ(light.x > 0.0f, anisotropy == 0.0);
        }
        EXPECT_EQ(others, 3u);
    }
}

// The tracer's own coverage, but for chance and for the edges of its pixels; in pictures to learn from, too.
TEST_F(Views, OfCoverageHaveNoLight) {
    trace::PathTracer tracer = this->tracer();
    Progress progress;
    const std::vector<Camera> cameras = this->cameras(2);
    const auto outlines = coverageViews(tracer, cameras, {24, 20}, progress);
    ASSERT_TRUE(outlines.ok());
    ASSERT_EQ(outlines->size(), 2u);
    const ViewTracing options{.sizePx = {24, 20}, .samplesPerPixel = 64};
    const auto learnt = traceViews(tracer, cameras, options, progress);
    ASSERT_TRUE(learnt.ok());
    for (std::size_t v = 0; v < 2; ++v) {
        const TracedView& outline = (*outlines)[v];
        const auto traced =
            traceView(tracer, {.camera = cameras[v], .width = 24, .height = 20}, {}, 64, progress);
        ASSERT_TRUE(traced.ok());
        EXPECT_EQ(outline.camera.positionMm, cameras[v].positionMm);
        EXPECT_EQ(outline.sizePx, glm::ivec2(24, 20));
        ASSERT_EQ(outline.rgba.size(), 480u);
        double off = 0.0;
        double offLearnt = 0.0;
        double shown = 0.0;
        for (std::size_t i = 0; i < 480; ++i) {
            EXPECT_EQ(glm::vec3(outline.rgba[i]), glm::vec3(0.0f));
            off += std::abs(double(outline.rgba[i].w - traced->rgba[i].w));
            offLearnt += std::abs(double(learnt->views[v].rgba[i].w - traced->rgba[i].w));
            shown += double(traced->rgba[i].w);
        }
        EXPECT_GT(shown, 40.0);
        EXPECT_LT(off, 0.1 * shown);
        EXPECT_LT(offLearnt, 0.15 * shown);
    }
    CancelToken stop;
    stop.cancel();
    Progress stopped({}, stop);
    EXPECT_EQ(coverageViews(tracer, cameras, {24, 20}, stopped).error().code, ErrorCode::cancelled);
}

TEST_F(Views, AreThoseOfTheTracerAndOfNoOtherViewWithCoverageOfTheGuides) {
    trace::PathTracer tracer = this->tracer();
    Progress progress;
    const ViewTracing options{.sizePx = {24, 20}, .samplesPerPixel = 9};
    std::vector<Camera> cameras = this->cameras(1);
    cameras.push_back(cameras[0]);  // so near that a picture on the screen would be helped by the one before
    cameras[1].positionMm += 0.01 * (cameras[1].targetMm - cameras[1].positionMm);
    const auto both = traceViews(tracer, cameras, options, progress);
    ASSERT_TRUE(both.ok());
    ASSERT_EQ(both->views.size(), 2u);
    EXPECT_EQ(both->fromKept, 0u);
    const TracedView& second = both->views[1];
    EXPECT_EQ(second.sizePx, glm::ivec2(24, 20));
    EXPECT_EQ(second.rgba.size(), 480u);
    EXPECT_EQ(second.samplesPerPixel, 9.0);
    EXPECT_EQ(second.camera.positionMm, cameras[1].positionMm);

    // The second by itself, by a tracer that has seen nothing else.
    trace::PathTracer fresh = this->tracer();
    trace::Settings settings = options.settings;
    settings.seed += 1;
    auto alone = traceView(fresh, {.camera = cameras[1], .width = 24, .height = 20}, settings, 9, progress);
    ASSERT_TRUE(alone.ok());
    const auto guides = fresh.readGuides();
    ASSERT_TRUE(guides.ok());
    const std::vector<float> coverage = pixelCoverage(*guides, {24, 20});
    for (std::size_t i = 0; i < coverage.size(); ++i) alone->rgba[i].a = coverage[i];
    EXPECT_TRUE(same(second.rgba, alone->rgba));

    Progress stopped({}, [] {
        CancelToken token;
        token.cancel();
        return token;
    }());
    const auto none = traceViews(tracer, cameras, options, stopped);
    ASSERT_FALSE(none.ok());
    EXPECT_EQ(none.error().code, ErrorCode::cancelled);
}

// Stopped after the first of three, and gone on with: the same as all at once. What differs in anything is
// not taken for it, nor is truth.
TEST_F(Views, ThatWereKeptAreNotTracedAgain) {
    const TracedScene scene = this->scene();
    const KeptFolder folder(scene);
    const std::vector<Camera> cameras = this->cameras(3);
    const ViewTracing plain{.sizePx = {24, 20}, .samplesPerPixel = 3};
    ViewTracing options = plain;
    options.kept = &folder.kept;
    trace::PathTracer tracer = this->tracer();
    Progress progress;
    const auto expected = traceViews(tracer, cameras, plain, progress);
    ASSERT_TRUE(expected.ok());

    const auto first = traceViews(tracer, std::span(cameras).first(1), options, progress);
    ASSERT_TRUE(first.ok());
    EXPECT_EQ(first->fromKept, 0u);
    const auto whole = traceViews(tracer, cameras, options, progress);
    ASSERT_TRUE(whole.ok());
    EXPECT_EQ(whole->fromKept, 1u);
    const auto again = traceViews(tracer, cameras, options, progress);
    ASSERT_TRUE(again.ok());
    EXPECT_EQ(again->fromKept, 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_TRUE(same(whole->views[i].rgba, expected->views[i].rgba)) << i;
        EXPECT_TRUE(same(again->views[i].rgba, expected->views[i].rgba)) << i;
        EXPECT_EQ(again->views[i].camera.positionMm, cameras[i].positionMm);
        EXPECT_EQ(again->views[i].samplesPerPixel, 3.0);
    }

    ViewTracing other = options;
    other.samplesPerPixel = 4;
    EXPECT_EQ(traceViews(tracer, cameras, other, progress)->fromKept, 0u);
    other = options;
    other.settings.denoising = trace::Denoising::on;
    EXPECT_EQ(traceViews(tracer, cameras, other, progress)->fromKept, 0u);
    const trace::View view{.camera = cameras[0], .width = 24, .height = 20};
    trace::Settings settings = plain.settings;
    const auto key = scene.pictureKey(view, settings, 3);
    ASSERT_TRUE(key.ok());
    EXPECT_FALSE(folder.cache.find(*key).has_value());

    // One that is damaged is made again.
    const auto damaged = std::filesystem::directory_iterator(folder.path)->path();
    std::filesystem::resize_file(damaged, std::filesystem::file_size(damaged) - 1);
    std::size_t found = 0;
    for (const ViewTracing& asked : {options, other})
        found += traceViews(tracer, cameras, asked, progress)->fromKept;
    ViewTracing more = options;
    more.samplesPerPixel = 4;
    found += traceViews(tracer, cameras, more, progress)->fromKept;
    EXPECT_EQ(found, 8u);
}

// A picture that was stopped in its first pass: what has no samples is not known, rather than black.
TEST_F(Views, ThatSomebodyLooksAtAreLearntAsFarAsTheyAreTraced) {
    trace::PathTracer tracer = this->tracer();
    const Camera camera = cameras(1).front();
    const int kSide = device()->isCpu() ? 256 : 1024;  // more than one dispatch
    ASSERT_TRUE(tracer.setSettings({.denoising = trace::Denoising::little}).ok());
    ASSERT_TRUE(tracer.setView({.camera = camera, .width = kSide, .height = kSide}).ok());
    ASSERT_FALSE(*tracer.trace(1, [] { return false; }));
    const auto counts = tracer.readback()->samples;
    const auto unfinished = readToLearnFrom(tracer, camera);
    ASSERT_TRUE(unfinished.ok());
    EXPECT_EQ(unfinished->sizePx, glm::ivec2(kSide));
    EXPECT_EQ(unfinished->camera.positionMm, camera.positionMm);
    std::size_t unknown = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const glm::vec4& pixel = unfinished->rgba[i];
        const bool isKnown = std::isfinite(pixel.r) && std::isfinite(pixel.a);
        ASSERT_EQ(isKnown, counts[i] > 0) << i;
        unknown += isKnown ? 0 : 1;
    }
    EXPECT_GT(unknown, 0u);
    EXPECT_LT(unknown, counts.size());
    EXPECT_NEAR(unfinished->samplesPerPixel, 1.0 - double(unknown) / double(counts.size()), 1e-6);

    ASSERT_TRUE(*tracer.trace(1));
    const auto whole = readToLearnFrom(tracer, camera);
    ASSERT_TRUE(whole.ok());
    EXPECT_GE(whole->samplesPerPixel, 1.0);
    const std::vector<float> coverage = pixelCoverage(tracer.readGuides().value(), glm::ivec2(kSide));
    for (std::size_t i = 0; i < counts.size(); ++i) {
        ASSERT_TRUE(std::isfinite(whole->rgba[i].r));
        ASSERT_EQ(whole->rgba[i].a, coverage[i]);
    }
}

// The ball of 8.4 mm in a box of 24 mm: a picture that it fills shows enough, one beside it does not, and one
// from within is too near.
TEST_F(Views, AreAcceptedForWhatTheyShow) {
    trace::PathTracer tracer = this->tracer();
    const Progress progress;
    const PoseAcceptance accept = showsEnough(tracer, 20.0, {.sizePx = 16}, progress);
    const auto from = [](const glm::dvec3& eye, const glm::dvec3& target) {
        return Camera{.positionMm = eye, .targetMm = target, .verticalFovDeg = 20.0};
    };
    EXPECT_TRUE(*accept(from({0, -60, 0}, {})));
    EXPECT_FALSE(*accept(from({0, -60, 0}, {0, -120, 0}))) << "nothing in it";
    EXPECT_FALSE(*accept(from({0, 0, 0}, {0, 60, 0}))) << "too near";
    EXPECT_FALSE(*accept(from({0, -600, 0}, {}))) << "too small";
}

TEST_F(Views, TruthIsKeptAndComesBackBitForBit) {
    const auto folder = std::filesystem::temp_directory_path() / fmt::format("macula-truth-{}", getpid());
    std::filesystem::remove_all(folder);
    const PictureCache cache(folder);
    trace::PathTracer tracer = this->tracer();
    Progress progress;
    const std::vector<Camera> cameras = this->cameras(2);
    const TruthOptions options{.sizePx = glm::ivec2(16), .samplesPerPixel = 12};
    const auto first = truthPictures(tracer, scene(), std::span(cameras).first(1), options, cache, progress);
    ASSERT_TRUE(first.ok());
    EXPECT_FALSE(first->front().fromCache);
    const auto both = truthPictures(tracer, scene(), cameras, options, cache, progress);
    ASSERT_TRUE(both.ok());
    EXPECT_TRUE((*both)[0].fromCache);
    EXPECT_FALSE((*both)[1].fromCache);
    for (std::size_t k = 0; k < 2; ++k)
        EXPECT_TRUE(same((*both)[0].halves[k].rgba, first->front().halves[k].rgba));
    // Each by itself: when one half is gone, it is made anew.
    const auto file = std::filesystem::directory_iterator(folder)->path();
    std::filesystem::remove(file);
    const auto again = truthPictures(tracer, scene(), cameras, options, cache, progress);
    ASSERT_TRUE(again.ok());
    EXPECT_NE((*again)[0].fromCache, (*again)[1].fromCache);
    EXPECT_TRUE(same((*again)[0].whole(), (*both)[0].whole()));
    EXPECT_TRUE(same((*again)[1].whole(), (*both)[1].whole()));
    EXPECT_TRUE(std::filesystem::exists(file));
    const auto more = truthPictures(tracer, scene(), cameras,
                                    {.sizePx = glm::ivec2(16), .samplesPerPixel = 14}, cache, progress);
    ASSERT_TRUE(more.ok());
    EXPECT_FALSE(more->front().fromCache);
    const auto odd = truthPictures(tracer, scene(), cameras,
                                   {.sizePx = glm::ivec2(16), .samplesPerPixel = 13}, cache, progress);
    ASSERT_FALSE(odd.ok());
    EXPECT_EQ(odd.error().code, ErrorCode::usage);
    std::filesystem::remove_all(folder);
}

// The mean of both halves is as far from what they converge to as half their difference, in the mean over
// pixels; with the same noise in both, or some of it, it would be farther.
TEST_F(Views, HalvesOfTheTruthHaveNoiseOfTheirOwn) {
    trace::PathTracer tracer = this->tracer();
    Progress progress;
    const std::vector<Camera> cameras = this->cameras(1);
    const glm::ivec2 size(48);
    const auto traced = truthPictures(tracer, scene(), cameras, {.sizePx = size, .samplesPerPixel = 8},
                                      PictureCache({}), progress);
    const auto converged = truthPictures(tracer, scene(), cameras, {.sizePx = size, .samplesPerPixel = 512},
                                         PictureCache({}), progress);
    ASSERT_TRUE(traced.ok() && converged.ok());
    const std::vector<glm::vec4> near = converged->front().whole();
    const auto& [a, b] = traced->front().halves;
    double product = 0.0;
    double squares = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < near.size(); ++i) {
        const double x = double(a.rgba[i].y) - double(near[i].y);
        const double y = double(b.rgba[i].y) - double(near[i].y);
        product += x * y;
        squares += 0.5 * (x * x + y * y);
        if (x != 0.0 || y != 0.0) ++count;
    }
    // Their correlation, of pixels that are independent: its standard deviation is count^-1/2, and less where
    // few have most of the noise. 5 of these: 6e-7 by chance.
    ASSERT_GT(count, 300u);
    EXPECT_NEAR(product / squares, 0.0, 5.0 / std::sqrt(double(count)) + 1.0 / 64.0);
}

TEST_F(Views, TheHostDisplaysAsTheDeviceDoes) {
    trace::PathTracer tracer = this->tracer();
    ASSERT_TRUE(tracer.trace(4).ok());
    const auto linear = tracer.readback();
    const auto device = tracer.readDisplay(glm::vec3(0.0f));
    ASSERT_TRUE(linear.ok() && device.ok());
    const std::vector<std::uint8_t> host = splat::displayed(linear->radiance, splat::ColourSpace::linear, {});
    ASSERT_EQ(host.size(), device->size());
    int brightest = 0;
    for (std::size_t i = 0; i < host.size(); ++i) {
        const int onDevice = (*device)[i];
        EXPECT_LE(std::abs(int(host[i]) - onDevice), 1);  // a value between two may be rounded either way
        if (i % 4 != 3) brightest = std::max(brightest, onDevice);
    }
    EXPECT_GT(brightest, 100);
}

TEST_F(Views, ModelsAreDrawnAsTheReferenceDoes) {
    trace::PathTracer tracer = this->tracer();
    const auto points = tracer.surfacePoints({.count = 100, .paths = 8});
    ASSERT_TRUE(points.ok());
    const splat::Splats splats = initialSplats(*points);
    ASSERT_GT(splats.size(), 50u);
    const std::vector<Camera> cameras = this->cameras(2);
    const auto drawn = drawViews(device(), splats, cameras, {24, 20});
    ASSERT_TRUE(drawn.ok());
    ASSERT_EQ(drawn->pictures.size(), 2u);
    ASSERT_EQ(drawn->milliseconds.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        const auto view = splat::rasterView(cameras[i], {24, 20}, splats.originMm);
        ASSERT_TRUE(view.ok());
        const splat::RasterImage reference =
            splat::rasterize(splat::ReferenceSplats(splats), *view, splat::blendingOf(splats.lowPass),
                             splat::Precision::single);
        std::vector<glm::vec4> expected(reference.rgba.begin(), reference.rgba.end());
        EXPECT_LT(meanDifference(drawn->pictures[i], expected), 1e-5);
        EXPECT_GT(meanDifference(drawn->pictures[i], std::vector<glm::vec4>(480, glm::vec4(0.0f))), 0.05);
    }
    const auto nothing = drawViews(device(), splat::Splats{}, cameras, {8, 8});
    ASSERT_TRUE(nothing.ok());
    EXPECT_EQ(nothing->pictures[0], std::vector<glm::vec4>(64, glm::vec4(0.0f)));
}

// The device sorts by depths in float. Where a float does not tell two splats apart, double may know the
// other one to be in front.
std::vector<std::uint32_t> orderOnDevice(const splat::ReferenceSplats& splats, const splat::RasterView& view,
                                         const splat::Blending& blending) {
    const auto screen = splat::projectSplats(splats, view, blending, splat::Precision::single);
    std::vector<std::uint32_t> order(screen.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return static_cast<float>(screen[a].depthMm) < static_cast<float>(screen[b].depthMm);
    });
    return order;
}

// A clock that goes on by the same whenever it is looked at: once for each view, side and step.
TEST_F(Views, ABudgetIsOfPointsViewsAndTrainingTogether) {
    constexpr double kTick = 0.25;
    double now = 1000.0;
    const auto clock = [&now] { return now += kTick; };
    Progress progress;
    FirstModelOptions options{.points = {.count = 60, .paths = 2},
                              .views = 40,
                              .samplesPerPixel = 1,
                              .directions = 40,
                              .sizePx = 16,
                              .iterations = 1000,
                              .capacity = 60};
    for (const double seconds : {6.0, 24.0}) {
        trace::PathTracer tracer = this->tracer();
        const TimeBudget budget(seconds, clock);
        options.budget = &budget;
        auto model = makeFirstModel(device(), tracer, scene().seenMm(), options, progress);
        ASSERT_TRUE(model.ok()) << model.error().message;
        const double spent = model->pointsSeconds + model->viewsSeconds + model->trainSeconds;
        EXPECT_GE(spent, seconds - kTick);
        EXPECT_LE(spent, seconds + 3 * kTick);
        EXPECT_LE(model->viewsSeconds, 0.5 * seconds + 3 * kTick);
        EXPECT_GE(model->viewsTraced, 2u);
        EXPECT_LE(double(model->viewsTraced) * kTick, 0.4 * seconds);
        EXPECT_GT(model->trainer.viewCount(), model->viewsTraced) << "what was not traced is lit";
        EXPECT_GE(double(model->trainer.report().steps) * kTick, 0.4 * seconds - kTick);
    }
    // One view and one step, however little there is.
    trace::PathTracer tracer = this->tracer();
    const TimeBudget nothing(0.1, clock);
    options.budget = &nothing;
    auto model = makeFirstModel(device(), tracer, scene().seenMm(), options, progress);
    ASSERT_TRUE(model.ok()) << model.error().message;
    EXPECT_EQ(model->viewsTraced, 1u);
    EXPECT_EQ(model->trainer.viewCount(), 1u);
    EXPECT_EQ(model->trainer.report().steps, 1u);
}

// Those for which there is time are spread over all of them, and the same as they would be otherwise.
TEST_F(Views, AreSpreadWhereTimeEnds) {
    trace::PathTracer tracer = this->tracer();
    Progress progress;
    const std::vector<Camera> cameras = this->cameras(6);
    ViewTracing options{.sizePx = {24, 20}, .samplesPerPixel = 1};
    const auto all = traceViews(tracer, cameras, options, progress);
    ASSERT_TRUE(all.ok());
    EXPECT_TRUE(all->leftOut.empty());
    int asked = 0;
    options.hasTimeToTrace = [&asked] { return ++asked <= 3; };
    const auto some = traceViews(tracer, cameras, options, progress);
    ASSERT_TRUE(some.ok());
    ASSERT_EQ(some->views.size(), 3u);
    ASSERT_EQ(some->leftOut.size(), 3u);
    for (const std::size_t i : {0u, 1u, 2u}) {
        EXPECT_EQ(some->views[i].camera.positionMm, cameras[2 * i].positionMm);
        EXPECT_TRUE(same(some->views[i].rgba, all->views[2 * i].rgba));
        EXPECT_EQ(some->leftOut[i].positionMm, cameras[2 * i + 1].positionMm);
    }
}

// To each pixel, against the reference in double; with splats that were split.
TEST_F(Views, TrainedModelsAreDrawnAsTheReferenceDoes) {
    trace::PathTracer tracer = this->tracer();
    Progress progress;
    const FirstModelOptions options{.points = {.count = 2000, .paths = 4},
                                    .views = 12,
                                    .samplesPerPixel = 2,
                                    .directions = 12,
                                    .sizePx = 96,
                                    .iterations = 220,
                                    .capacity = 2500};
    auto model = makeFirstModel(device(), tracer, scene().seenMm(), options, progress);
    ASSERT_TRUE(model.ok()) << model.error().message;
    const splat::Splats trained = *model->trainer.snapshot();
    EXPECT_GT(trained.size(), 2000u);
    const glm::ivec2 sizePx(320, 280);
    const std::vector<Camera> cameras = this->cameras(4);
    const auto drawn = drawViews(device(), trained, cameras, sizePx);
    ASSERT_TRUE(drawn.ok());
    const splat::ReferenceSplats exact(trained);
    const splat::Blending blending = splat::blendingOf(trained.lowPass);
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const auto view = splat::rasterView(cameras[i], sizePx, trained.originMm);
        ASSERT_TRUE(view.ok());
        const splat::RasterImage reference = splat::rasterize(
            exact, *view, blending, splat::Precision::twofold, orderOnDevice(exact, *view, blending));
        double covered = 0.0;
        for (std::size_t p = 0; p < reference.rgba.size(); ++p) {
            covered += reference.rgba[p].a;
            for (int c = 0; c < 4; ++c)
                ASSERT_NEAR(drawn->pictures[i][p][c], reference.rgba[p][c], 1e-4) << p;
        }
        EXPECT_GT(covered, 0.02 * double(reference.rgba.size()));
    }
}

}  // namespace
}  // namespace macula::hybrid
