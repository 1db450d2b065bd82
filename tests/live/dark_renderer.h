// A renderer with a device, whose screen nobody sees.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/phantom.h"
#include "live/frame/frame_renderer.h"
#include "pipeline/gpu/transfer.h"
#include "scene/choice/preset_choice.h"

namespace macula::live {

// Shows whatever it is given, to nobody.
class DarkScreen final : public Screen {
  public:
    // `pixels` receives each picture, RGBA8.
    DarkScreen(std::shared_ptr<gpu::Device> device, std::shared_ptr<std::vector<std::byte>> pixels)
        : device_(std::move(device)), pixels_(std::move(pixels)) {}
    Result<void> resize(VkExtent2D) override { return {}; }
    void setText(std::shared_ptr<const PictureText> text) override { text_ = std::move(text); }
    void setMarks(std::shared_ptr<const PictureText> marks) override { marks_ = std::move(marks); }
    const std::shared_ptr<const PictureText>& marks() const override { return marks_; }
    const std::shared_ptr<const PictureText>& text() const override { return text_; }
    Result<bool> show(const gpu::Image& picture) override {
        MACULA_TRY_VOID(device_->waitForAll());
        MACULA_TRY(*pixels_, gpu::readBytes(picture));
        return true;
    }
    Result<bool> showAgain() override { return false; }
    bool owes() const override { return false; }
    void forget() override {}
    Result<bool> showColour(const VkClearColorValue&) override { return true; }

  private:
    std::shared_ptr<gpu::Device> device_;
    std::shared_ptr<std::vector<std::byte>> pixels_;
    std::shared_ptr<const PictureText> text_;
    std::shared_ptr<const PictureText> marks_;
};

class DarkPlace final : public ScreenPlace {
  public:
    explicit DarkPlace(std::shared_ptr<std::vector<std::byte>> pixels) : pixels_(std::move(pixels)) {}
    std::vector<const char*> deviceExtensions() const override { return {}; }
    Result<std::unique_ptr<Screen>> open(const std::shared_ptr<gpu::Device>& device,
                                         VkExtent2D) const override {
        return std::unique_ptr<Screen>(std::make_unique<DarkScreen>(device, pixels_));
    }

  private:
    std::shared_ptr<std::vector<std::byte>> pixels_;
};

// Has what a test put there, and remembers what it was given.
class EmptyKeeper final : public SceneKeeper {
  public:
    void willShow(const std::string& name, std::shared_ptr<const Volume>, const scene::Drawing&) override {
        lookedFor_.push_back(name);
    }
    hybrid::StoredModel find(const std::string& name) override {
        const auto state = stored_.find(name);
        if (state == stored_.end()) return {.answer = hybrid::StoredModel::Answer::none};
        return {.answer = hybrid::StoredModel::Answer::whole,
                .splats = state->second->shown
                              ? state->second->shown
                              : std::make_shared<const splat::Splats>(state->second->training.splats),
                .steps = state->second->training.steps,
                .gain = state->second->gain,
                .seenMm = state->second->seenMm,
                .state = state->second};
    }
    void keep(std::shared_ptr<const hybrid::PeripheralState> state) override {
        kept_.push_back(std::move(state));
    }

    std::map<std::string, std::shared_ptr<const hybrid::PeripheralState>> stored_;  // by name
    std::vector<std::string> lookedFor_;
    std::vector<std::shared_ptr<const hybrid::PeripheralState>> kept_;
};

class FrameRendererTest : public testing::Test {
  protected:
    void SetUp() override {
        makeRenderer();
        if (!renderer_) return;
        input_.place = std::make_shared<const DarkPlace>(pixels_);
        input_.width = 48;
        input_.height = 36;
        input_.visible = true;
        input_.study = 1;
        input_.volume = std::make_shared<const Volume>(
            phantom::make({.size = {32, 28, 20}, .spacingMm = {9.6, 9.6, 15.0}}));
        trace::LightRig rig;
        rig.ambientZenith = rig.ambientHorizon = rig.ambientNadir = glm::dvec3(1.0);
        input_.drawing = {.transferFunction = std::make_shared<const TransferFunction>(
                              scene::choosePreset("cinematic-bone")->function),
                          .lights = std::make_shared<const trace::LightRig>(rig)};
        input_.camera = frameBox(input_.volume->worldBox(), ViewDirection::anterior, 20.0, 4.0 / 3.0);
        input_.sampleLimit = 1;
    }

    void makeRenderer() {
        auto instance = gpu::Instance::create();
        if (!instance) FAIL() << "packaging/bootstrap installs a Vulkan driver: " << instance.error().message;
        renderer_.emplace(std::move(*instance), gpu::DeviceOptions{}, keeper_,
                          [this](const RenderEvent& event) { hear(event); });
    }
    void hear(const RenderEvent& event) {
        if (const auto* changed = std::get_if<ModelChanged>(&event)) news_ = changed->model;
        if (const auto* frame = std::get_if<FrameShown>(&event)) {
            news_ = frame->model;
            shown_ = *frame;
        }
        if (std::holds_alternative<Preparing>(event)) ++preparing_;
        if (std::holds_alternative<PictureRemoved>(event)) ++removed_;
        if (const auto* outline = std::get_if<OutlineFound>(&event)) {
            ++outlines_;
            outline_ = *outline;
        }
        if (const auto* taken = std::get_if<ModelSnapshot>(&event)) taken_ = *taken;
        if (const auto* phases = std::get_if<PhaseModelsChanged>(&event)) {
            phases_ = *phases;
            if (onPhases_) onPhases_(*phases);
        }
        if (const auto* failure = std::get_if<RenderFailure>(&event))
            failures_.push_back(failure->error.message.english());
    }
    // The mean column of the pixels of the last picture that are brighter than dark grey.
    double litColumn() const {
        double sum = 0.0;
        double count = 0.0;
        for (std::size_t n = 0; n < pixels_->size() / 4; ++n) {
            if (std::to_integer<int>((*pixels_)[4 * n + 1]) < 60) continue;
            sum += double(n % std::size_t(input_.width));
            count += 1.0;
        }
        return sum / count;
    }

    // Whether it came to that; a machine may be slow.
    template <class IsDone>
    bool stepUntil(const IsDone& isDone) {
        const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(8);
        while (!isDone() && std::chrono::steady_clock::now() < deadline)
            renderer_->step({.newInput = [] { return false; }, .stopping = [] { return false; }});
        return isDone();
    }

    const std::shared_ptr<EmptyKeeper> keeper_ = std::make_shared<EmptyKeeper>();
    hybrid::ModelNews news_;
    std::vector<std::string> failures_;
    int preparing_ = 0;
    int removed_ = 0;
    int outlines_ = 0;
    std::optional<OutlineFound> outline_;
    PhaseModelsChanged phases_;
    std::function<void(const PhaseModelsChanged&)> onPhases_;
    const std::shared_ptr<std::vector<std::byte>> pixels_ = std::make_shared<std::vector<std::byte>>();
    std::optional<FrameShown> shown_;
    std::optional<ModelSnapshot> taken_;
    FrameInput input_;
    std::optional<FrameRenderer> renderer_;
};

}  // namespace macula::live
