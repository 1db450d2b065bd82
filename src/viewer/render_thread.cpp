#include "viewer/render_thread.h"

#include <utility>

#include "viewer/frame_renderer.h"

#ifdef __linux__
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace macula::viewer {

namespace {

// Where the device is the CPU, tracing takes every core for as long as it lasts. The threads of the driver
// inherit the priority of the one that makes the device, so a step down here lets the user interface and the
// window system go first. Where there is a GPU, this thread hardly runs.
void giveWayToTheUserInterface() {
#ifdef __linux__
    constexpr int kNiceness = 5;
    // On Linux this concerns the calling thread only. If it is refused, all works, only less smoothly.
    setpriority(PRIO_PROCESS, id_t(gettid()), kNiceness);
#endif
}

}  // namespace

RenderThread::RenderThread(gpu::Instance instance, std::string preferredDevice, RenderListener listener)
    : thread_([this, instance = std::move(instance), preferredDevice = std::move(preferredDevice),
               listener = std::move(listener)](const std::stop_token& stop) mutable {
          run(stop, std::move(instance), std::move(preferredDevice), std::move(listener));
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

bool RenderThread::releaseSurface(std::chrono::milliseconds timeout) {
    if (last_.surface == VK_NULL_HANDLE) return true;
    FrameInput without = last_;
    without.surface = VK_NULL_HANDLE;
    const std::uint64_t sequence = publish(std::move(without));
    const auto deadline = std::chrono::steady_clock::now() + timeout;
    // An earlier release whose wait timed out may still be in the slot.
    while (true) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
            deadline - std::chrono::steady_clock::now());
        if (left.count() <= 0) return false;
        if (const auto released = released_.takeFor(left); released && *released >= sequence) return true;
    }
}

void RenderThread::run(const std::stop_token& stop, gpu::Instance instance, std::string preferredDevice,
                       RenderListener listener) {
    giveWayToTheUserInterface();
    FrameRenderer renderer(std::move(instance), std::move(preferredDevice), std::move(listener));
    const Interrupts interrupts{.newInput = [this] { return inputs_.pending(); },
                                .stopping = [&stop] { return stop.stop_requested(); }};
    while (!stop.stop_requested()) {
        std::optional<FrameInput> input = renderer.hasWork() ? inputs_.tryTake() : inputs_.take();
        if (input) {
            const std::uint64_t sequence = input->sequence;
            const bool released = input->surface == VK_NULL_HANDLE;
            renderer.accept(std::move(*input));
            if (released) released_.publish(sequence);
        }
        renderer.step(interrupts);
    }
}

}  // namespace macula::viewer
