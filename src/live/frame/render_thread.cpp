#include "live/frame/render_thread.h"

#include <chrono>
#include <exception>
#include <optional>
#include <utility>

#include "base/log.h"
#include "live/device/open_device.h"
#include "live/frame/frame_renderer.h"

namespace macula::live {

namespace {

// A release that takes longer is logged. A dispatch takes far less time, and so does nearly every scene part.
constexpr std::chrono::milliseconds kReleaseIsSlow{5000};

}  // namespace

RenderThread::RenderThread(gpu::Instance instance, std::string preferredDevice,
                           std::shared_ptr<SceneKeeper> keeper, RenderListener listener)
    : thread_([this, instance = std::move(instance), preferredDevice = std::move(preferredDevice),
               keeper = std::move(keeper),
               listener = std::move(listener)](const std::stop_token& stop) mutable {
          run(stop, std::move(instance), std::move(preferredDevice), std::move(keeper), std::move(listener));
      }) {}

RenderThread::~RenderThread() {
    thread_.request_stop();
    inputs_.close();
}

std::uint64_t RenderThread::publish(FrameInput input) {
    input.sequence = last_.sequence + 1;
    input.published = std::chrono::steady_clock::now();
    last_ = input;
    inputs_.publish(std::move(input));
    return last_.sequence;
}

void RenderThread::releaseScreen() {
    if (!last_.place) return;
    FrameInput without = last_;
    without.place = nullptr;
    const std::uint64_t sequence = publish(std::move(without));
    bool told = false;
    while (true) {
        const auto released = released_.takeFor(kReleaseIsSlow);
        if (released && *released >= sequence) return;  // otherwise it answers an earlier release
        if (!released && !std::exchange(told, true))
            log::warning("Waiting for the graphics device to let go of the window.");
    }
}

void RenderThread::run(const std::stop_token& stop, gpu::Instance instance, std::string preferredDevice,
                       std::shared_ptr<SceneKeeper> keeper, RenderListener listener) {
    gpu::DeviceOptions device = deviceOptions(preferredDevice);
    device.givesWay = true;
    FrameRenderer renderer(std::move(instance), std::move(device), std::move(keeper), std::move(listener));
    const Interrupts interrupts{.newInput = [this] { return inputs_.pending(); },
                                .stopping = [&stop] { return stop.stop_requested(); }};
    std::optional<std::uint64_t> owed;  // the release that releaseScreen() waits for
    while (!stop.stop_requested()) {
        try {
            std::optional<FrameInput> input = renderer.hasWork() || owed ? inputs_.tryTake() : inputs_.take();
            if (input) {
                if (!input->place) owed = input->sequence;
                renderer.accept(std::move(*input));
            }
            if (owed) {
                renderer.releaseScreen();
                released_.publish(*std::exchange(owed, std::nullopt));
            }
        } catch (const std::exception&) {
            renderer.fail(noMemoryToShow);
        }
        renderer.step(interrupts);
    }
}

}  // namespace macula::live
