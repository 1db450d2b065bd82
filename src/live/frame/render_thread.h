// The one thread that uses the GPU.
#pragma once

#include <memory>
#include <string>
#include <thread>

#include "live/frame/frame_input.h"
#include "live/frame/latest.h"
#include "live/frame/render_events.h"
#include "live/frame/scene_keeper.h"
#include "pipeline/gpu/instance.h"

namespace macula::live {

// Takes inputs, of which the latest wins, and reports events. Publishing never waits for the GPU. Only the
// thread that created the object may call its members.
class RenderThread {
  public:
    // The render thread opens the device, and reports failure as an event. `keeper` as in FrameRenderer.
    // `listener` is called on the render thread.
    RenderThread(gpu::Instance instance, std::string preferredDevice, std::shared_ptr<SceneKeeper> keeper,
                 RenderListener listener);
    // Stops and joins; waits for the dispatch in flight.
    ~RenderThread();

    // Sets the sequence number and the time, and returns the number.
    std::uint64_t publish(FrameInput input);

    // Waits until nothing refers to the place, before the window system destroys its surface. The wait has no
    // limit, because a driver that loses a surface in use ends the process. Nowhere else does the UI thread
    // wait for the render thread.
    void releaseScreen();

  private:
    void run(const std::stop_token& stop, gpu::Instance instance, std::string preferredDevice,
             std::shared_ptr<SceneKeeper> keeper, RenderListener listener);

    FrameInput last_;
    Latest<FrameInput> inputs_;
    Latest<std::uint64_t> released_;  // sequence of the last taken input without a place
    std::jthread thread_;             // last, because it uses all of the above
};

}  // namespace macula::live
