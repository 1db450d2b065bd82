#include "pipeline/trace/guides.h"

#include <algorithm>

#include "pipeline/gpu/reading.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/trace/portions.h"
#include "pipeline/trace/scene_view.h"

namespace macula::trace {

namespace {

Result<gpu::TexelBuffer> makeTexels(const std::shared_ptr<gpu::Device>& device, const char* label,
                                    std::uint64_t pixels) {
    return gpu::TexelBuffer::create(
        device, {.label = label,
                 .elements = pixels,
                 .format = VK_FORMAT_R32G32B32A32_SFLOAT,
                 .usage = VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
}

}  // namespace

Guides::Guides(int width, int height, gpu::TexelBuffer surfaces, gpu::TexelBuffer matters,
               gpu::TexelBuffer motions)
    : width_(width),
      height_(height),
      surfaces_(std::move(surfaces)),
      matters_(std::move(matters)),
      motions_(std::move(motions)) {}

Result<Guides> Guides::create(const std::shared_ptr<gpu::Device>& device, int width, int height) {
    const std::uint64_t pixels = std::uint64_t(width) * std::uint64_t(height);
    MACULA_TRY(gpu::TexelBuffer surfaces, makeTexels(device, "surfaces", pixels));
    MACULA_TRY(gpu::TexelBuffer matters, makeTexels(device, "matters", pixels));
    MACULA_TRY(gpu::TexelBuffer motions, makeTexels(device, "motions", pixels));
    return Guides(width, height, std::move(surfaces), std::move(matters), std::move(motions));
}

Result<void> Guides::compute(const SceneView& scene, const gpu::Kernel& kernel,
                             const shared::GuidePush& before, const std::function<bool()>& keepGoing) {
    const auto& device = surfaces_.buffer().device();
    const int rows = rowsToMarchAtOnce(device->isCpu(), width_, height_);
    shared::GuidePush push = before;
    while (!isWhole()) {
        push.firstRow = rows_;
        MACULA_TRY(auto recorder, gpu::Recorder::create(device, "guides"));
        std::vector<gpu::Binding> bindings = scene.bindings();
        for (const gpu::TexelBuffer* texels : {&surfaces_, &matters_, &motions_})
            bindings.emplace_back(texels->buffer());
        recorder.dispatch(kernel,
                          {static_cast<std::uint32_t>(width_),
                           static_cast<std::uint32_t>(std::min(rows, height_ - push.firstRow))},
                          push, bindings);
        MACULA_TRY(const gpu::Ticket ticket, recorder.submit());
        rows_ += rows;
        if (!keepGoing) continue;
        MACULA_TRY([[maybe_unused]] const bool done, device->waitFor(ticket));
        if (!keepGoing()) break;
    }
    return {};
}

Result<std::vector<float>> Guides::readCoverage() const {
    MACULA_TRY(const auto matters, gpu::read<glm::vec4>(matters_.buffer()));
    std::vector<float> coverage(matters.size());
    std::transform(matters.begin(), matters.end(), coverage.begin(), [](const glm::vec4& m) { return m.w; });
    return coverage;
}

Result<std::vector<GuidePixel>> Guides::read() const {
    gpu::Reading reading;  // all at once: choosing views reads dozens of small pictures
    MACULA_TRY_VOID(reading.begin({&surfaces_.buffer(), &matters_.buffer(), &motions_.buffer()}));
    MACULA_TRY_VOID(reading.finish());
    const auto surfaces = reading.part<glm::vec4>(0);
    const auto matters = reading.part<glm::vec4>(1);
    const auto motions = reading.part<glm::vec4>(2);
    std::vector<GuidePixel> pixels(surfaces.size());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        pixels[i] = {.depthMm = surfaces[i].w,
                     .confidence = motions[i].z,
                     .coverage = matters[i].w,
                     .beforeMm = motions[i].w,
                     .albedo = glm::vec3(matters[i]),
                     .normal = glm::vec3(surfaces[i]),
                     .motion = glm::vec2(motions[i])};
    }
    return pixels;
}

}  // namespace macula::trace
