// Matter that is denser than the bound of its brick is counted.
#include "pipeline/gpu/transfer.h"
#include "pipeline/trace/film.h"
#include "pipeline/trace/reference_tracer.h"
#include "pipeline/trace/scene_view.h"
#include "pipeline/trace/trace_kernels.h"
#include "trace/gpu_scene.h"
#include "trace/scenes.h"

namespace macula::trace {
namespace {

using Bounds = DeviceTest;

constexpr int kBoundBinding = 4;  // of shaders/trace/host.glsl
constexpr int kSize = 16;         // pixels each way

// A picture of one sample, of a cube of matter whose bounds were multiplied: what was counted.
Film::Faults faultsWith(const std::shared_ptr<gpu::Device>& device, float boundsTimes, bool isSideBySide) {
    const auto volume =
        scenes::volumeOf({16, 16, 16}, glm::dmat4(1.0), [](int, int, int) { return std::uint16_t(1); });
    const TransferFunction function = scenes::homogeneous(0.3);
    SceneView view = SceneView::create(std::make_shared<DeviceScene>(device, MemoryLimits{})).value();
    EXPECT_TRUE(view.scene().setVolume(volume).ok());
    EXPECT_TRUE(view.scene().setTransferFunction(function).ok());
    EXPECT_TRUE(view.scene().setEnvironment(Environment::constant(glm::vec3(1.0f))).ok());
    const View from{.camera = frameBox(volume->worldBox(), ViewDirection::left, 30, 1.0),
                    .width = kSize,
                    .height = kSize};
    const Settings settings{.bounces = 2};
    EXPECT_TRUE(view.look(from, settings).ok());

    std::vector<float> bounds = makeMedium(*volume, makeBrickGrid(*volume), function).bounds;
    for (float& bound : bounds) bound *= boundsTimes;
    const auto texels = gpu::TexelBuffer::create(
        device, {.label = "bounds",
                 .elements = bounds.size(),
                 .format = VK_FORMAT_R32_SFLOAT,
                 .usage = VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT});
    EXPECT_TRUE(gpu::uploadTo(texels->buffer(), std::span<const float>(bounds)).ok());
    std::vector<gpu::Binding> bindings = view.bindings();
    bindings.at(kBoundBinding) = gpu::Binding(*texels);

    const Film film = Film::create(device, kSize, kSize).value();
    std::vector<shared::PlannedBlock> plan;
    for (unsigned block = 0; block < 4; ++block) plan.push_back({block, 0, 1});
    const auto planned =
        gpu::Buffer::create(device, {.label = "plan", .bytes = plan.size() * sizeof(plan.front())});
    EXPECT_TRUE(gpu::uploadTo(*planned, std::span<const shared::PlannedBlock>(plan)).ok());
    const auto traced =
        gpu::Buffer::create(device, {.label = "traced", .bytes = plan.size() * 64 * sizeof(glm::vec4)});
    if (isSideBySide) {
        bindings.insert(bindings.end(), {*planned, *traced, film.faultsBuffer()});
    } else {
        film.appendTo(bindings);
        bindings.emplace_back(*planned);
    }
    EXPECT_TRUE(view.scene().indirect().makeBindable().ok());
    view.scene().indirect().appendTo(bindings);
    const auto taken = gpu::Buffer::create(device, {.label = "taken", .bytes = sizeof(std::uint32_t)});
    if (isSideBySide) bindings.emplace_back(*taken);
    TraceVariant variant = variantOf(settings, kindOf(view.scene()));
    variant.isSideBySide = isSideBySide;
    TraceKernels kernels(device);
    auto recorder = gpu::Recorder::create(device, "trace").value();
    film.clear(recorder);
    recorder.fill(*taken, 0);
    const gpu::Kernel& kernel = *kernels.samples(variant)->kernel;
    if (isSideBySide) {
        recorder.dispatch(kernel, {std::uint32_t(64 * plan.size())},
                          shared::SidePush{std::uint32_t(plan.size()), 1}, bindings);
    } else {
        recorder.dispatch(kernel, {std::uint32_t(8 * plan.size()), 8}, bindings);
    }
    EXPECT_TRUE(recorder.submit().ok());
    return film.faults().value();
}

TEST_F(Bounds, MatterThatIsDenserIsCounted) {
    for (const bool isSideBySide : {false, true}) {
        EXPECT_EQ(faultsWith(device(), 1.0f, isSideBySide).aboveBound, 0u);
        EXPECT_EQ(faultsWith(device(), 2.0f, isSideBySide).aboveBound, 0u);
        EXPECT_GT(faultsWith(device(), 0.5f, isSideBySide).aboveBound, 50u);
        // Shadow rays begin with looser bounds.
        EXPECT_GT(faultsWith(device(), 0.9f, isSideBySide).aboveBound, 50u);
    }
}

}  // namespace
}  // namespace macula::trace
