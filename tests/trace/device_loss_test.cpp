// The tracer on devices that are lost: nothing crashes, hangs or is left behind, and the picture made on the
// next device is the one that would have been.
#include <functional>
#include <utility>

#include "base/phantom.h"
#include "gpu/lose_device.h"
#include "pipeline/gpu/recovery.h"
#include "pipeline/volume/transfer_function_json.h"
#include "presets/embedded_files.h"
#include "trace/gpu_scene.h"

namespace macula::trace {
namespace {

using test::VulkanCall;

// What a study was opened and set to: all that is needed to begin anew.
struct Study {
    std::shared_ptr<const Volume> volume =
        std::make_shared<const Volume>(phantom::make({.size = {40, 36, 32}, .spacingMm = {7.0, 7.0, 8.0}}));
    TransferFunction function;
    Clip clip;
    Settings settings{.seed = 7, .denoising = Denoising::on};
    View view{
        .camera = frameBox(volume->worldBox(), ViewDirection::anterior, 30, 1.0), .width = 24, .height = 24};

    Study() {
        for (const presets::EmbeddedFile& file : presets::transferFiles()) {
            if (file.name == "cinematic-bone")
                function = *transferFunctionFromJson(file.text, std::string(file.name));
        }
        clip.planes.push_back({.normal = {0, 0, 1}, .offsetMm = volume->worldBox().centre().z});
    }
};

struct Drawn {
    std::vector<std::uint8_t> display;
    std::vector<glm::vec4> radiance;
    std::vector<float> depthMm;

    bool operator==(const Drawn&) const = default;
};

enum class Part { uploading, tracing, guides, denoising, reading };
using Begin = std::function<void(Part)>;

// Two views, the second denoised with what the first knew.
Result<void> draw(
    PathTracer& tracer, const Study& study, Drawn& drawn, const Begin& begin = [](Part) {}) {
    MACULA_TRY_VOID(tracer.scene().setVolume(study.volume));
    MACULA_TRY_VOID(tracer.scene().setClip(study.clip));
    begin(Part::uploading);
    MACULA_TRY_VOID(tracer.scene().setTransferFunction(study.function));
    MACULA_TRY_VOID(tracer.scene().setEnvironment(Environment::fromRig(LightRig{})));
    MACULA_TRY_VOID(tracer.setSettings(study.settings));
    View view = study.view;
    for (int i = 0; i < 2; ++i) {
        MACULA_TRY_VOID(tracer.setView(view));
        if (i == 1) begin(Part::tracing);
        MACULA_TRY([[maybe_unused]] const bool whole, tracer.trace(2));
        if (i == 1) begin(Part::guides);
        MACULA_TRY([[maybe_unused]] const Guides* guides, tracer.guides());
        if (i == 1) begin(Part::denoising);
        MACULA_TRY([[maybe_unused]] const gpu::Image* shown, tracer.display(glm::vec3(0.1f)));
        view.camera.positionMm.x += 5.0;
    }
    begin(Part::reading);
    MACULA_TRY(drawn.display, tracer.readDisplay(glm::vec3(0.1f)));
    MACULA_TRY(const TracedImage image, tracer.readback());
    drawn.radiance = image.radiance;
    drawn.depthMm = image.depthMm;
    return {};
}

class DeviceLossInTracing : public DeviceTest {
  protected:
    void TearDown() override {
        test::loseDeviceAt(VulkanCall::submit, 1, 0);
        DeviceTest::TearDown();
    }
    // Staging as on a card: more can go wrong.
    static std::shared_ptr<gpu::Device> card() {
        return *gpu::Device::create(instance(), {.separateMemory = true});
    }
    Study study_;
};

void expectLost(const Result<void>& result, const std::string& when) {
    ASSERT_FALSE(result.ok()) << when;
    EXPECT_EQ(result.error().code, ErrorCode::deviceLost) << when << ": " << result.error().message;
}

// At calls to the driver that can report it, spread over all the work; at each of the 118 when it was
// written.
TEST_F(DeviceLossInTracing, IsToldWheneverItHappensAndByEveryLaterCall) {
    struct Case {
        VulkanCall call;
        const char* name;
        int step;
    };
    for (const Case& lost :
         {Case{VulkanCall::submit, "submit", 7}, Case{VulkanCall::wait, "wait", 6},
          Case{VulkanCall::allocate, "allocate", 12}, Case{VulkanCall::compile, "compile", 2}}) {
        bool happened = true;
        int losses = 0;
        for (int nth = 1; happened; nth += lost.step) {
            const std::string when = fmt::format("{} {}", lost.name, nth);
            const auto device = card();
            test::loseDeviceAt(lost.call, nth);
            Drawn drawn;
            auto made = PathTracer::create(device);
            const Result<void> done = made.ok() ? draw(*made, study_, drawn) : made.error();
            happened = test::devicesLost() > 0;
            if (!happened) {
                EXPECT_TRUE(done.ok()) << when;
                break;
            }
            ++losses;
            expectLost(done, when);
            if (made.ok()) {
                expectLost(draw(*made, study_, drawn), when);
                EXPECT_FALSE(made->readDisplay({}).ok()) << when;
                EXPECT_FALSE(made->readGuides().ok()) << when;
                EXPECT_FALSE(made->traceFor(1000.0).ok()) << when;
            }
            EXPECT_EQ(test::callsOfLostDevice(), 0) << when;
        }
        EXPECT_GE(losses, 3) << lost.name;
    }
}

TEST_F(DeviceLossInTracing, ThePictureAfterwardsIsTheOneThatWouldHaveBeen) {
    Drawn expected;
    {
        auto tracer = *PathTracer::create(card());
        ASSERT_TRUE(draw(tracer, study_, expected).ok());
    }
    ASSERT_EQ(expected.radiance.size(), 24u * 24u);
    int told = 0;
    for (const auto& [part, call] :
         {std::pair(Part::uploading, VulkanCall::allocate), std::pair(Part::uploading, VulkanCall::submit),
          std::pair(Part::tracing, VulkanCall::wait), std::pair(Part::guides, VulkanCall::submit),
          std::pair(Part::denoising, VulkanCall::submit), std::pair(Part::reading, VulkanCall::wait)}) {
        auto lasting = *gpu::LastingDevice::open(*gpu::Instance::create(), {.separateMemory = true},
                                                 [&](const Text&) { ++told; });
        bool armed = false;
        Drawn drawn;
        const auto done = lasting.run([&](const std::shared_ptr<gpu::Device>& device) -> Result<void> {
            MACULA_TRY(PathTracer tracer, PathTracer::create(device));
            return draw(tracer, study_, drawn, [&](Part now) {
                if (now == part && !std::exchange(armed, true)) test::loseDeviceAt(call, 1);
            });
        });
        ASSERT_TRUE(done.ok()) << done.error().message;
        EXPECT_EQ(test::devicesLost(), 1) << int(part);
        EXPECT_TRUE(drawn == expected) << int(part);
    }
    EXPECT_EQ(told, 6);
}

}  // namespace
}  // namespace macula::trace
