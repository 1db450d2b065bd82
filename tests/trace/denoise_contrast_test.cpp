// What a radiologist looks for and noise hides: the denoiser must not take it for noise. Measured by
// contrast, beside that of a converged picture that was not denoised.
#include <algorithm>
#include <array>
#include <cmath>

#include "trace/gpu_scene.h"
#include "trace/scenes.h"

namespace macula::trace {
namespace {

using DenoiseContrast = DeviceTest;

constexpr int kSide = 64;             // pixels
constexpr double kFieldMm = 48.0;     // that they show
constexpr double kLesionXMm = -10.0;  // mm, its middle
constexpr double kLesionRadiusMm = 5.0;
constexpr double kFissureXMm = 10.5;  // mm, a gap one voxel wide

// A block of tissue, its face towards the eye. In the face a round lesion, a little darker in colour, and a
// fissure from top to bottom, into which little light finds its way.
std::shared_ptr<const Volume> tissue() {
    const glm::ivec3 size{48, 32, 48};
    const glm::dvec3 first = 0.5 * (1.0 - glm::dvec3(size));
    return scenes::volumeOf(size, affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, first), [&](int i, int j, int k) {
        const glm::dvec3 mm = first + glm::dvec3(i, j, k);
        if (j < 6 || (mm.x == kFissureXMm && j < 20)) return 0;
        return glm::length(mm - glm::dvec3(kLesionXMm, first.y + 6, 0)) < kLesionRadiusMm ? 700 : 500;
    });
}

TransferFunction tissueFunction() {
    TransferFunction function = scenes::homogeneous(1.0, 0.9);
    function.opacity = {{200, 0.0}, {400, 0.6}};
    function.colour = {{500, {0.9, 0.75, 0.7}}, {700, {0.75, 0.61, 0.57}}};
    return function;
}

// How much darker each is than what is beside it, in parts of that.
struct Contrasts {
    double lesion = 0.0;
    double fissure = 0.0;
};
Contrasts contrasts(const TracedImage& image) {
    std::array<double, 4> sums{};
    std::array<int, 4> counts{};
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const double xMm = kFieldMm * ((x + 0.5) / kSide - 0.5);
            const double zMm = kFieldMm * (0.5 - (y + 0.5) / kSide);
            const double fromLesion = std::hypot(xMm - kLesionXMm, zMm);
            const double fromFissure = std::abs(xMm - kFissureXMm);
            const bool inTheMiddle = std::abs(zMm) < 16.0;
            int place = -1;
            if (fromLesion < 0.7 * kLesionRadiusMm) place = 0;
            if (fromLesion > 1.3 * kLesionRadiusMm && fromLesion < 1.8 * kLesionRadiusMm) place = 1;
            if (inTheMiddle && fromFissure < 0.4) place = 2;
            if (inTheMiddle && fromFissure > 3.0 && fromFissure < 6.0) place = 3;
            if (place < 0) continue;
            const glm::vec4& pixel = image.radiance[std::size_t(y * kSide + x)];
            sums[std::size_t(place)] += glm::dot(glm::dvec3(pixel), glm::dvec3(0.2126, 0.7152, 0.0722));
            ++counts[std::size_t(place)];
        }
    }
    const auto mean = [&](std::size_t i) { return sums[i] / counts[i]; };
    return {1.0 - mean(0) / mean(1), 1.0 - mean(2) / mean(3)};
}

// Of several pictures.
class Mean {
  public:
    void add(double part) {
        sum_ += part;
        squares_ += part * part;
        ++count_;
    }
    double mean() const { return sum_ / count_; }
    double error() const {  // of the mean
        return std::sqrt(std::max(squares_ / count_ - mean() * mean(), 0.0) / (count_ - 1));
    }

  private:
    double sum_ = 0.0;
    double squares_ = 0.0;
    int count_ = 0;
};

TEST_F(DenoiseContrast, ALowContrastLesionAndAFissureStay) {
    LightRig rig;
    rig.ambientHorizon = {0.4, 0.4, 0.4};
    rig.lights = {{.azimuthDeg = 40, .elevationDeg = 30, .angularRadiusDeg = 10, .radiance = 20}};
    const View view{.camera = {.positionMm = {0, -400, 0},
                               .verticalFovDeg = glm::degrees(2.0 * std::atan(0.5 * kFieldMm / 390.0))},
                    .width = kSide,
                    .height = kSide};
    PathTracer t =
        tracer(tissue(), tissueFunction(), Environment::fromRig(rig), view, {.bounces = 2, .seed = 1});
    ASSERT_TRUE(*t.trace(384));
    const Contrasts truth = contrasts(*t.readback());
    EXPECT_NEAR(truth.lesion, 0.12, 0.03);  // what radiologists call low
    EXPECT_GT(truth.fissure, 0.5);
    // Of the contrast, what is left: with few samples some is lost where light alone tells, then nearly none.
    struct Least {
        std::uint32_t samples;
        double lesion, fissure;
    };
    for (const auto& [samples, ofLesion, ofFissure] : {Least{8, 0.67, 0.7}, Least{32, 0.9, 0.93}}) {
        SCOPED_TRACE(samples);
        Mean lesion;
        Mean fissure;
        for (std::uint32_t seed = 0; seed < 6; ++seed) {
            Settings settings{.bounces = 2, .seed = 10 + seed};
            ASSERT_TRUE(
                t.scene().setTransferFunction(tissueFunction()).ok());  // nothing is known from before
            ASSERT_TRUE(t.setSettings(settings).ok());
            ASSERT_TRUE(*t.trace(samples));
            settings.denoising = Denoising::on;
            ASSERT_TRUE(t.setSettings(settings).ok());
            const Contrasts filtered = contrasts(*t.readback());
            lesion.add(filtered.lesion / truth.lesion);
            fissure.add(filtered.fissure / truth.fissure);
        }
        // Within two standard errors of what chance does to the lesion; the fissure has little of it.
        EXPECT_GT(lesion.mean() + 2.0 * lesion.error(), ofLesion);
        EXPECT_LT(lesion.mean() - 2.0 * lesion.error(), 1.1);
        EXPECT_LT(lesion.error(), 0.1);
        EXPECT_GT(fissure.mean(), ofFissure);
        EXPECT_LT(fissure.mean(), 1.05);
        EXPECT_LT(fissure.error(), 0.02);
    }
}

}  // namespace
}  // namespace macula::trace
