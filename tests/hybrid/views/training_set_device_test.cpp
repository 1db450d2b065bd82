// Pictures that light each other, against those that are traced with hundreds of samples.
#include "pipeline/hybrid/views/training_set.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "gpu/lose_device.h"
#include "hybrid/coloured_ball.h"
#include "hybrid/views/cache_folder.h"
#include "pipeline/hybrid/light/combined_view.h"
#include "pipeline/hybrid/light/light_in_space.h"
#include "pipeline/hybrid/light/lit_view.h"
#include "pipeline/hybrid/views/pose_sampling.h"
#include "pipeline/hybrid/views/traced_scene.h"
#include "pipeline/trace/device_scene.h"
#include "trace/gpu_scene.h"

namespace macula::hybrid {
namespace {

using coloured_ball::ball;
using coloured_ball::fromLeft;
using coloured_ball::kPicture;
using coloured_ball::matter;

bool same(const std::vector<TracedView>& a, const std::vector<TracedView>& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i].camera.positionMm != b[i].camera.positionMm || a[i].sizePx != b[i].sizePx) return false;
        if (a[i].isLit != b[i].isLit || a[i].samplesPerPixel != b[i].samplesPerPixel) return false;
        if (std::memcmp(a[i].rgba.data(), b[i].rgba.data(), a[i].rgba.size() * sizeof(glm::vec4)) != 0)
            return false;
    }
    return true;
}

// Of light, over that of `truth`, and the mean square of pixels, both summed over colours.
struct Error {
    double light = 0.0;
    double square = 0.0;
};
Error errorOf(const TracedView& view, const TracedView& truth) {
    Error error;
    double ours = 0.0;
    double theirs = 0.0;
    for (std::size_t i = 0; i < truth.rgba.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            ours += double(view.rgba[i][c]);
            theirs += double(truth.rgba[i][c]);
            error.square += std::pow(double(view.rgba[i][c]) - double(truth.rgba[i][c]), 2.0);
        }
    }
    error.light = ours / theirs;
    return error;
}

class ViewSets : public trace::DeviceTest {
  protected:
    void SetUp() override {
        trace::DeviceTest::SetUp();
        if (IsSkipped()) return;
        const auto views = samplePoses(scene().seenMm(), initialTraining(28));
        for (const SampledPose& view : *views)
            (set_.traced.size() < 24 ? set_.traced : set_.sides).push_back(view.camera);
        tracing_.settings.seed = 5;
    }
    TransferFunction function(double anisotropy = 0.0) const {
        TransferFunction function = matter(0.5);
        function.anisotropy = anisotropy;
        return function;
    }
    TracedScene scene() const { return *TracedScene::create(volume_, function(), {}, fromLeft()); }
    trace::PathTracer tracer(double anisotropy = 0.0) const {
        return trace::DeviceTest::tracer(volume_, function(anisotropy), fromLeft(), scenes::lookAt(*volume_),
                                         {});
    }

    trace::PathTracer tracerOn(const std::shared_ptr<gpu::Device>& device,
                               const TransferFunction& function) const {
        auto made = trace::PathTracer::create(device);
        trace::PathTracer tracer = std::move(made).value();
        EXPECT_TRUE(tracer.scene().setVolume(volume_).ok() &&
                    tracer.scene().setTransferFunction(function).ok() &&
                    tracer.scene().setEnvironment(fromLeft()).ok());
        return tracer;
    }

    std::shared_ptr<const Volume> volume_ = ball(350, 650);
    TrainingSet set_;
    ViewTracing tracing_{.sizePx = kPicture, .samplesPerPixel = 2};
    Progress progress_;
};

TEST_F(ViewSets, AreNearerToTheTruthThanWhatIsTraced) {
    trace::PathTracer tracer = this->tracer();
    const auto pictures = makePictures(tracer, scene().seenMm(), set_, tracing_, progress_);
    ASSERT_TRUE(pictures.ok()) << pictures.error().message;
    EXPECT_TRUE(pictures->areLit);
    EXPECT_EQ(pictures->fromKept, 0u);
    ASSERT_EQ(pictures->traced.size(), 24u);
    ASSERT_EQ(pictures->sides.size(), 4u);
    const auto traced = traceViews(tracer, set_.traced, tracing_, progress_);
    ASSERT_TRUE(traced.ok());
    double squares = 0.0;
    double squaresTraced = 0.0;
    for (const std::size_t i : {0u, 9u, 23u}) {
        const TracedView& view = pictures->traced[i];
        EXPECT_TRUE(view.isLit);
        EXPECT_EQ(view.samplesPerPixel, 2.0);
        EXPECT_EQ(view.camera.positionMm, set_.traced[i].positionMm);
        const auto truth =
            traceView(tracer, {.camera = set_.traced[i], .width = kPicture.x, .height = kPicture.y},
                      {.seed = 1234}, 512, progress_);
        ASSERT_TRUE(truth.ok());
        squares += errorOf(view, *truth).square;
        squaresTraced += errorOf(traced->views[i], *truth).square;
        // As bright as that by itself, whose few samples are several percent off in pictures this small.
        EXPECT_NEAR(errorOf(view, traced->views[i]).light, 1.0, 0.01);
    }
    EXPECT_LT(squares, 0.4 * squaresTraced);
    for (const TracedView& side : pictures->sides) {
        EXPECT_TRUE(side.isLit);
        EXPECT_EQ(side.samplesPerPixel, 0.0);
    }
}

TEST_F(ViewSets, AreAsTheyAreTracedWhereLightGoesForwards) {
    trace::PathTracer tracer = this->tracer(0.6);
    const auto pictures = makePictures(tracer, scene().seenMm(), set_, tracing_, progress_);
    ASSERT_TRUE(pictures.ok());
    EXPECT_FALSE(pictures->areLit);
    const auto traced = traceViews(tracer, set_.traced, tracing_, progress_);
    ASSERT_TRUE(traced.ok());
    EXPECT_TRUE(same(pictures->traced, traced->views));
    ASSERT_EQ(pictures->sides.size(), 4u);
    for (const glm::vec4& pixel : pictures->sides[0].rgba) EXPECT_EQ(glm::vec3(pixel), glm::vec3(0.0f));
}

// Those of the same set, to the bit, and of no other.
TEST_F(ViewSets, ThatWereKeptAreNotMadeAgain) {
    const TracedScene scene = this->scene();
    const KeptFolder folder(scene);
    trace::PathTracer tracer = this->tracer();
    set_.traced.resize(3);
    set_.sides.resize(2);
    tracing_.kept = &folder.kept;
    const auto make = [&](const TrainingSet& set, const ViewTracing& tracing) {
        return makePictures(tracer, scene.seenMm(), set, tracing, progress_);
    };
    const auto first = make(set_, tracing_);
    ASSERT_TRUE(first.ok());
    EXPECT_EQ(first->fromKept, 0u);
    const auto again = make(set_, tracing_);
    ASSERT_TRUE(again.ok());
    EXPECT_EQ(again->fromKept, 5u);
    EXPECT_TRUE(again->areLit);
    EXPECT_TRUE(same(first->traced, again->traced));
    EXPECT_TRUE(same(first->sides, again->sides));

    TrainingSet fewer = set_;
    fewer.sides.pop_back();
    EXPECT_EQ(make(fewer, tracing_)->fromKept, 0u);
    fewer = set_;
    fewer.traced.pop_back();
    EXPECT_EQ(make(fewer, tracing_)->fromKept, 0u);
    ViewTracing other = tracing_;
    other.samplesPerPixel = 3;
    EXPECT_EQ(make(set_, other)->fromKept, 0u);
    other = tracing_;
    ++other.settings.seed;
    EXPECT_EQ(make(set_, other)->fromKept, 0u);
    EXPECT_EQ(make(set_, tracing_)->fromKept, 5u);

    // All or none.
    for (const auto& file : std::filesystem::directory_iterator(folder.path))
        std::filesystem::resize_file(file, std::filesystem::file_size(file) - 1);
    const auto anew = make(set_, tracing_);
    ASSERT_TRUE(anew.ok());
    EXPECT_EQ(anew->fromKept, 0u);
    EXPECT_TRUE(same(first->traced, anew->traced));
    EXPECT_TRUE(same(first->sides, anew->sides));
}

TEST_F(ViewSets, CanBeEmptyAndStopped) {
    trace::PathTracer tracer = this->tracer();
    const auto nothing = makePictures(tracer, scene().seenMm(), {}, tracing_, progress_);
    ASSERT_TRUE(nothing.ok());
    EXPECT_TRUE(nothing->traced.empty() && nothing->sides.empty());
    CancelToken stop;
    stop.cancel();
    Progress stopped({}, stop);
    EXPECT_EQ(makePictures(tracer, scene().seenMm(), set_, tracing_, stopped).error().code,
              ErrorCode::cancelled);
}

// One after the other, each step waited for: what makePictures does while the device goes on.
std::vector<TracedView> madeInTurn(trace::PathTracer& tracer, const Box& seenMm, const TrainingSet& set,
                                   const ViewTracing& tracing) {
    double cellMm = 0.0;
    for (const Camera& camera : set.traced)
        cellMm += glm::distance(camera.positionMm, seenMm.centre()) * 2.0 *
                  std::tan(glm::radians(camera.verticalFovDeg) / 2.0) / double(tracing.sizePx.y);
    LightInSpace light(cellMm / double(set.traced.size()));
    std::vector<TracedView> views;
    for (std::size_t i = 0; i < set.traced.size(); ++i) {
        trace::Settings settings = tracing.settings;
        settings.seed += static_cast<std::uint32_t>(i);
        tracer.forgetViews();
        EXPECT_TRUE(tracer.setSettings(settings).ok());
        EXPECT_TRUE(
            tracer.setView({.camera = set.traced[i], .width = tracing.sizePx.x, .height = tracing.sizePx.y})
                .ok());
        for (std::uint32_t done = 0; done < tracing.samplesPerPixel; done += shared::kPrimarySamples) {
            const auto met =
                tracer.tracePrimaries(std::min(shared::kPrimarySamples, tracing.samplesPerPixel - done));
            EXPECT_TRUE(met.ok());
            light.addAll(set.traced[i].positionMm, *met);
        }
        views.push_back(readToLearnFrom(tracer, set.traced[i]).value());
    }
    light.finish();
    auto table = LightTable::create(tracer.device(), light);
    const double own = 12.0 / (12.0 + double(set.traced.size()));
    for (std::size_t i = 0; i < views.size(); ++i)
        views[i] = combined(views[i], table->lit(tracer, set.traced[i], tracing.sizePx).value(), own);
    for (const Camera& camera : set.sides)
        views.push_back(table->lit(tracer, camera, tracing.sizePx).value());
    return views;
}

// To the bit, also where memory is the device's own, as on a graphics card; of a pixel, of nothing, and of
// samples that come in two portions.
TEST_F(ViewSets, AreTheSameHoweverTheyComeToTheHost) {
    set_.traced.resize(5);
    const auto device = *gpu::Device::create(instance(), {.separateMemory = true});
    for (const bool isEmpty : {false, true}) {
        for (const glm::ivec2 sizePx : {kPicture, glm::ivec2(1, 1)}) {
            SCOPED_TRACE(fmt::format("{} x {}{}", sizePx.x, sizePx.y, isEmpty ? ", empty" : ""));
            tracing_.sizePx = sizePx;
            tracing_.samplesPerPixel = sizePx == kPicture ? 3 : 2;
            const TransferFunction function = isEmpty ? matter(0.0) : this->function();
            trace::PathTracer usual = tracerOn(deviceOfShaders(), function);
            const auto expected = madeInTurn(usual, scene().seenMm(), set_, tracing_);
            trace::PathTracer card = tracerOn(device, function);
            for (trace::PathTracer* tracer : {&usual, &card}) {
                auto pictures = makePictures(*tracer, scene().seenMm(), set_, tracing_, progress_);
                ASSERT_TRUE(pictures.ok()) << pictures.error().message;
                EXPECT_TRUE(pictures->areLit);
                EXPECT_GT(pictures->times.paths, 0.0);
                EXPECT_GT(pictures->times.beside, 0.0);
                std::vector<TracedView> views = std::move(pictures->traced);
                for (TracedView& side : pictures->sides) views.push_back(std::move(side));
                EXPECT_TRUE(same(views, expected));
                if (!isEmpty) continue;
                for (const TracedView& view : views)
                    for (const glm::vec4& pixel : view.rgba) ASSERT_EQ(pixel, glm::vec4(0.0f));
            }
        }
    }
}

// While views are traced, and while they are lit: what is under way on other threads is waited for.
TEST_F(ViewSets, OnALostDeviceAreAnError) {
    set_.traced.resize(3);
    for (const int nth : {8, 30}) {
        SCOPED_TRACE(nth);
        const auto device = *gpu::Device::create(instance(), {.separateMemory = true});
        trace::PathTracer tracer = tracerOn(device, function());
        test::loseDeviceAt(test::VulkanCall::submit, nth);
        const auto pictures = makePictures(tracer, scene().seenMm(), set_, tracing_, progress_);
        EXPECT_EQ(test::devicesLost(), 1);
        test::loseDeviceAt(test::VulkanCall::submit, 1, 0);
        ASSERT_FALSE(pictures.ok());
        EXPECT_EQ(pictures.error().code, ErrorCode::deviceLost);
    }
}

// Between views, too, and nothing of such a set is kept.
TEST_F(ViewSets, CanBeStoppedWhileTheyAreLit) {
    const TracedScene scene = this->scene();
    const KeptFolder folder(scene);
    trace::PathTracer tracer = this->tracer();
    set_.traced.resize(3);
    tracing_.kept = &folder.kept;
    bool wasLighting = false;
    CancelToken stop;
    Progress stopped(
        [&](const ProgressUpdate& update) {
            if (update.stage != "Lighting views") return;
            wasLighting = true;
            stop.cancel();
        },
        stop);
    const auto pictures = makePictures(tracer, scene.seenMm(), set_, tracing_, stopped);
    EXPECT_TRUE(wasLighting);
    EXPECT_EQ(pictures.error().code, ErrorCode::cancelled);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path));
    const auto made = makePictures(tracer, scene.seenMm(), set_, tracing_, progress_);
    ASSERT_TRUE(made.ok());
    EXPECT_EQ(made->fromKept, 0u);
}

}  // namespace
}  // namespace macula::hybrid
