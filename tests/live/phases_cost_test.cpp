// What it costs to learn the next phase, from points and from the model of the phase before: a measurement,
// on request (docs/measurements/window.md).
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/phantom.h"
#include "pipeline/hybrid/model/live_model.h"
#include "pipeline/splat/draw/model_painter.h"
#include "pipeline/splat/draw/raster_view.h"
#include "pipeline/trace/device_scene.h"
#include "scene/choice/preset_choice.h"
#include "study/open/found_volumes.h"
#include "study/open/opened_study.h"
#include "study/open/phases.h"

namespace macula::live {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kSidePx = 256;
constexpr std::uint32_t kTruthSamples = 96;
constexpr std::uint64_t kMostSteps = 320;
constexpr std::uint64_t kJudgedEvery = 40;

struct Judged {
    double seconds = 0.0;  // of learning, without judging
    std::uint64_t steps = 0;
    double psnrDb = 0.0;
};

// As displayed: clipped, and with the gamma of sRGB near enough.
double shown(float light) {
    return std::pow(std::clamp(double(light), 0.0, 1.0), 1.0 / 2.2);
}

class Bench {
  public:
    Bench() {
        auto instance = gpu::Instance::create();
        device_ = gpu::Device::create(*instance).value();
        function_ = scene::choosePreset("cinematic-bone")->function;
        trace::LightRig rig;
        rig.ambientZenith = rig.ambientHorizon = rig.ambientNadir = glm::dvec3(1.0);
        lights_ = trace::Environment::fromRig(rig);
    }

    void show(std::shared_ptr<const Volume> volume) {
        if (!tracer_) tracer_ = trace::PathTracer::create(device_).value();
        model_.reset();
        const auto start = Clock::now();
        ASSERT_TRUE(tracer_->scene().setVolume(volume).ok());
        ASSERT_TRUE(tracer_->scene().setTransferFunction(function_).ok());
        ASSERT_TRUE(tracer_->scene().setEnvironment(lights_).ok());
        ASSERT_TRUE(device_->waitForAll().ok());
        std::printf("volume to the device: %.2f s\n", since(start));
        makeTruth(volume->worldBox());
    }

    // Learns until it has taken kMostSteps.
    std::vector<Judged> learn(std::shared_ptr<const splat::Splats> from) {
        std::vector<Judged> judged;
        const auto shelf = std::make_shared<hybrid::ModelShelf>(1);
        auto model =
            hybrid::LiveModel::create(device_, *tracer_, shelf, nullptr, hybrid::liveModelOptions(*device_));
        model_.emplace(*std::move(model));
        EXPECT_TRUE(model_->show("phase", trace::Settings{}, std::move(from)).ok());
        double seconds = 0.0;
        std::uint64_t next = 0;
        while (model_->hasWork() && (judged.empty() || judged.back().steps < kMostSteps)) {
            const auto start = Clock::now();
            EXPECT_TRUE(model_->work(40.0, [] { return true; }).ok());
            seconds += since(start);
            const std::uint64_t steps = model_->news().steps;
            if (!model_->canBeDrawn() || steps < next) continue;
            next = steps / kJudgedEvery * kJudgedEvery + kJudgedEvery;
            judged.push_back({seconds, steps, psnrDb(*model_->shown(), model_->gain())});
            std::printf("  %6.1f s  %4llu steps  %5.2f dB  %zu splats%s\n", seconds,
                        static_cast<unsigned long long>(steps), judged.back().psnrDb, model_->shown()->size(),
                        hybrid::isFitToBeShown(model_->news()) ? "  fit" : "");
            std::fflush(stdout);
        }
        return judged;
    }
    std::shared_ptr<const splat::Splats> learnt() const { return model_->shown(); }

  private:
    struct Truth {
        Camera camera;
        std::vector<glm::vec4> light;
    };
    static double since(Clock::time_point start) {
        return std::chrono::duration<double>(Clock::now() - start).count();
    }

    void makeTruth(const Box& box) {
        truth_.clear();
        trace::Settings settings;
        settings.denoising = trace::Denoising::off;
        settings.errorThreshold = 0.0;
        ASSERT_TRUE(tracer_->setSettings(settings).ok());
        for (const ViewDirection from :
             {ViewDirection::anterior, ViewDirection::left, ViewDirection::superior}) {
            const Camera camera = frameBox(box, from, 20.0, 1.0);
            ASSERT_TRUE(tracer_->setView({.camera = camera, .width = kSidePx, .height = kSidePx}).ok());
            ASSERT_TRUE(tracer_->trace(kTruthSamples).ok());
            truth_.push_back({camera, tracer_->readColours().value().radiance});
        }
    }

    double psnrDb(const splat::Splats& splats, double gain) {
        auto painter = splat::ModelPainter::create(device_, splats).value();
        double sum = 0.0;
        double count = 0.0;
        for (const Truth& truth : truth_) {
            const auto view = splat::rasterView(truth.camera, glm::ivec2(kSidePx), splats.originMm).value();
            const auto picture = painter.draw(view).value();
            for (std::size_t n = 0; n < truth.light.size(); ++n)
                for (int channel = 0; channel < 3; ++channel) {
                    const double off =
                        shown(float(gain) * picture.rgba[n][channel]) - shown(truth.light[n][channel]);
                    sum += off * off;
                    count += 1.0;
                }
        }
        return -10.0 * std::log10(sum / count);
    }

    std::shared_ptr<gpu::Device> device_;
    TransferFunction function_;
    trace::Environment lights_ = trace::Environment::constant(glm::vec3(1.0f));
    std::optional<trace::PathTracer> tracer_;
    std::optional<hybrid::LiveModel> model_;
    std::vector<Truth> truth_;
};

void measure(const std::string& what, const std::shared_ptr<const Volume>& first,
             const std::shared_ptr<const Volume>& second) {
    Bench bench;
    std::printf("%s, %d x %d x %d\nphase 1, from points\n", what.c_str(), first->size().x, first->size().y,
                first->size().z);
    bench.show(first);
    bench.learn(nullptr);
    const auto neighbour = bench.learnt();
    bench.show(second);
    std::printf("phase 2, from points\n");
    const std::vector<Judged> cold = bench.learn(nullptr);
    std::printf("phase 2, from phase 1\n");
    const std::vector<Judged> warm = bench.learn(neighbour);
    ASSERT_FALSE(cold.empty() || warm.empty());
    for (const Judged& wanted : cold) {
        for (const Judged& reached : warm) {
            if (reached.psnrDb < wanted.psnrDb) continue;
            std::printf("%.2f dB: %.1f s from points, %.1f s from the neighbour\n", wanted.psnrDb,
                        wanted.seconds, reached.seconds);
            break;
        }
    }
}

// Two phases of the phantom: the second is moved by 6 mm, and 5 % larger.
TEST(PhasesCost, OfTheNextPhase) {
    if (std::getenv("MACULA_MEASURE_PHASES") == nullptr)
        GTEST_SKIP() << "MACULA_MEASURE_PHASES=1 measures it";
    const phantom::Options small{.size = {96, 84, 60}, .spacingMm = {3.2, 3.2, 5.0}};
    const auto first = std::make_shared<const Volume>(phantom::make(small));
    VolumeOptions options{.size = small.size,
                          .worldFromVoxel = phantom::worldFromVoxel(small),
                          .unitsFromStored = first->unitsFromStored(),
                          .unit = first->unit(),
                          .modality = first->modality()};
    std::vector<std::uint16_t> moved;
    for (int k = 0; k < small.size.z; ++k)
        for (int j = 0; j < small.size.y; ++j)
            for (int i = 0; i < small.size.x; ++i) {
                const glm::dvec3 at = transformPoint(options.worldFromVoxel, glm::dvec3(i, j, k));
                moved.push_back(
                    std::uint16_t(phantom::valueHu((at - glm::dvec3(6.0, 0.0, 0.0)) / 1.05) + 1024));
            }
    measure("phantom", first,
            std::make_shared<const Volume>(Volume::create(std::move(options), std::move(moved)).value()));
}

TEST(PhasesCost, OfTheNextPhaseOfAFolder) {
    const char* folder = std::getenv("MACULA_MEASURE_PHASES_OF");
    if (folder == nullptr) GTEST_SKIP() << "MACULA_MEASURE_PHASES_OF=FOLDER measures it";
    Progress progress;
    const auto study = study::openStudy(folder, progress);
    ASSERT_TRUE(study.ok());
    const std::vector<study::Phase> phases = study::phasesOf(*study->found, study->volumeIndex);
    ASSERT_GE(phases.size(), 2u);
    const auto first = study::openFoundVolume(study->found, phases[0].volume, progress);
    const auto second = study::openFoundVolume(study->found, phases[1].volume, progress);
    measure("folder", first.value().volume, second.value().volume);
}

}  // namespace
}  // namespace macula::live
