#include "pipeline/hybrid/model/live_model_options.h"

namespace macula::hybrid {

namespace {

constexpr int kSideOnCpuPx = 384;  // a view of 2 samples is traced in half a second to one on two cores
constexpr int kRoughSideOnCpuPx = 192;

}  // namespace

LiveModelOptions liveModelOptions(const gpu::Device& device) {
    LiveModelOptions options;
    if (device.isCpu()) {
        options.model.wanted.sizePx = glm::ivec2(kSideOnCpuPx);
        // A person waits until the model is sharp, so it begins with few points.
        options.points.count = 5000;
        options.points.candidatesPerPoint = 2;
        options.roughSidePx = kRoughSideOnCpuPx;
        options.roughSteps = 160;
    }
    return options;
}

}  // namespace macula::hybrid
