// Something small to learn: pictures of a known model from around, and a model that is not quite it.
#pragma once

#include <map>

#include "gpu/shared_device.h"
#include "pipeline/splat/train/trainer.h"
#include "splat/draw/reference_scenes.h"
#include "splat/model_support.h"

namespace macula::splat {

class TrainingTest : public gpu::SharedDeviceTest {
  protected:
    static constexpr std::size_t kSplats = 60;
    static constexpr std::uint32_t kNumber = 60;
    static constexpr int kViews = 5;

    static Splats truth(int degree = 0) { return singleOf(randomModel(21, kSplats, degree)); }

    static Splats start(int degree = 0) {
        Splats splats = truth(degree);
        Dice dice(5);
        for (std::size_t i = 0; i < splats.size(); ++i) {
            splats.position[i] += glm::vec3(dice.vec3(-5, 5));
            splats.logScale[i] += glm::vec3(dice.vec3(-0.3, 0.3));
            splats.opacityLogit[i] += static_cast<float>(dice.uniform(-0.7, 0.7));
            splats.dc[i] += glm::vec3(dice.vec3(-0.7, 0.7));
        }
        for (glm::vec3& sh : splats.sh) sh = glm::vec3(0.0f);
        return splats;
    }

    // From all around, half a metre away; 3 mm per pixel.
    static RasterView viewAt(double degrees, double heightMm = 0.0) {
        const double angle = glm::radians(degrees);
        const Camera camera{.positionMm = {500 * std::sin(angle), -500 * std::cos(angle), heightMm},
                            .verticalFovDeg = 14.0};
        return rasterView(camera, {45, 40}, glm::dvec3(0.0)).value();
    }
    static RasterView viewNumber(int i) { return viewAt(72.0 * i, i % 2 == 0 ? 120.0 : -80.0); }
    static RasterView heldOut() { return viewAt(36.0, 20.0); }

    static std::vector<glm::vec4> draw(const Splats& splats, const RasterView& view) {
        const auto room = static_cast<std::uint32_t>(std::max<std::size_t>(splats.size(), 1));
        auto parameters = *SplatBuffer::create(device(), "drawn", room, splats.shDegree);
        static std::map<std::pair<std::uint32_t, int>, Rasterizer> made;
        const auto key = std::pair(room, splats.shDegree);
        if (!made.contains(key)) made.emplace(key, *Rasterizer::create(device(), room, splats.shDegree));
        Rasterizer& rasterizer = made.at(key);
        EXPECT_TRUE(parameters.upload(componentsOf(splats)).ok());
        EXPECT_TRUE(
            rasterizer
                .draw(parameters, static_cast<std::uint32_t>(splats.size()), view, blendingOf(splats.lowPass))
                .ok());
        return *rasterizer.picture().read();
    }

    static std::vector<TrainingView> views(const Splats& of) {
        std::vector<TrainingView> made;
        for (int i = 0; i < kViews; ++i)
            made.push_back({.view = viewNumber(i), .pixels = draw(of, viewNumber(i))});
        return made;
    }
    // Drawn once.
    static const std::vector<TrainingView>& truthViews() {
        static const std::vector<TrainingView> made = views(truth());
        return made;
    }

    // Half-size pictures, then whole ones.
    static TrainerOptions options(std::uint64_t firstWhole = 60) {
        TrainerOptions o{
            .seed = 3, .stages = {{.firstStep = 0, .halvings = 1}, {.firstStep = firstWhole, .halvings = 0}}};
        o.optimizer.position = 0.05;
        o.optimizer.positionAtLast = 0.01;
        o.optimizer.positionSteps = 120;
        o.optimizer.dc = 0.02;
        o.optimizer.logScale = 0.02;
        return o;
    }

    static Trainer trainer(const Splats& model, const TrainerOptions& o, const std::vector<TrainingView>& of,
                           const std::shared_ptr<gpu::Device>& on = device()) {
        Trainer made = std::move(Trainer::create(on, model, o)).value();
        for (const TrainingView& view : of) EXPECT_TRUE(made.addView(view).ok());
        return made;
    }

    // Over red, green, blue and coverage.
    static double psnr(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
        double sum = 0.0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            const glm::dvec4 off = glm::dvec4(a[i]) - glm::dvec4(b[i]);
            sum += glm::dot(off, off) / 4.0;
        }
        return -10.0 * std::log10(sum / double(a.size()));
    }
    static double psnrOf(const Splats& splats) {
        return psnr(draw(splats, heldOut()), draw(truth(splats.shDegree), heldOut()));
    }
};

}  // namespace macula::splat
