#include "pipeline/hybrid/frame/brightness_gauge.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "base/is_finite.h"
#include "pipeline/hybrid/views/view_tracing.h"

namespace macula::hybrid {

namespace {

constexpr int kSidePx = 128;
constexpr std::uint32_t kSamples = 2;
constexpr double kFieldDeg = 20.0;
constexpr std::size_t kLeastPixels = 64;
constexpr double kMostGain = 2.0;

double luminance(const glm::vec4& p) {
    return 0.2126 * double(p.x) + 0.7152 * double(p.y) + 0.0722 * double(p.z);
}

}  // namespace

double brightnessGain(std::span<const std::vector<glm::vec4>> traced,
                      std::span<const std::vector<glm::vec4>> drawn) {
    MACULA_CHECK_EQ(traced.size(), drawn.size());
    double ofTraced = 0.0;
    double ofDrawn = 0.0;
    std::size_t pixels = 0;
    for (std::size_t k = 0; k < traced.size(); ++k) {
        MACULA_CHECK_EQ(traced[k].size(), drawn[k].size());
        for (std::size_t i = 0; i < traced[k].size(); ++i) {
            const glm::vec4& a = traced[k][i];
            const glm::vec4& b = drawn[k][i];
            if (!isFinite(a) || !isFinite(b) || !(a.w > 0.5f) || !(b.w > 0.5f)) continue;
            ofTraced += luminance(a);
            ofDrawn += luminance(b);
            ++pixels;
        }
    }
    if (pixels < kLeastPixels || !(ofTraced > 0.0) || !(ofDrawn > 0.0)) return 1.0;
    return std::clamp(ofTraced / ofDrawn, 1.0 / kMostGain, kMostGain);
}

BrightnessGauge::BrightnessGauge(const Box& seenMm) {
    // A model never learns from the first and the fourth: neither is anterior, with which most people begin.
    for (const ViewDirection side : {ViewDirection::posterior, ViewDirection::anterior, ViewDirection::left,
                                     ViewDirection::right, ViewDirection::superior, ViewDirection::inferior})
        cameras_.push_back(frameBox(seenMm, side, kFieldDeg, 1.0));
}

Result<void> BrightnessGauge::traceSome(trace::PathTracer& tracer, const trace::Settings& settings,
                                        const std::function<bool()>& keepGoing) {
    while (!isWhole()) {
        if (!std::exchange(hasBegun_, true)) {
            trace::Settings own = settings;
            own.denoising = trace::Denoising::little;
            own.seed += static_cast<std::uint32_t>(pictures_.size());
            tracer.forgetViews();
            MACULA_TRY_VOID(tracer.setSettings(own));
            MACULA_TRY_VOID(
                tracer.setView({.camera = cameras_[pictures_.size()], .width = kSidePx, .height = kSidePx}));
        }
        MACULA_TRY(const trace::Statistics before, tracer.statistics());
        if (before.samplesPerPixel < kSamples) {
            const auto missing = kSamples - static_cast<std::uint32_t>(before.samplesPerPixel);
            MACULA_TRY(const bool isTraced, tracer.trace(missing, keepGoing));
            if (!isTraced || !keepGoing()) return {};
        }
        MACULA_TRY(const bool isDeveloped, tracer.develop(keepGoing));
        if (!isDeveloped) return {};
        MACULA_TRY(TracedView picture, readToLearnFrom(tracer, cameras_[pictures_.size()]));
        pictures_.push_back(std::move(picture));
        hasBegun_ = false;
        if (!keepGoing()) return {};
    }
    return {};
}

Result<double> BrightnessGauge::gainOf(splat::ModelPainter& painter, const glm::dvec3& originMm) const {
    MACULA_CHECK(isWhole());
    std::vector<std::vector<glm::vec4>> traced;
    for (const TracedView& picture : pictures_) traced.push_back(picture.rgba);
    std::vector<std::vector<glm::vec4>> drawn;
    for (const Camera& camera : cameras_) {
        MACULA_TRY(const splat::RasterView view, splat::rasterView(camera, glm::ivec2(kSidePx), originMm));
        MACULA_TRY(const splat::DevicePicture* picture, painter.drawOnDevice(view));
        MACULA_TRY(std::vector<glm::vec4> pixels, picture->read());
        drawn.push_back(std::move(pixels));
    }
    return brightnessGain(traced, drawn);
}

}  // namespace macula::hybrid
