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

namespace macula::app {

// Takes inputs, latest wins; reports events. Publishing never waits for the GPU. All members are called by
// the thread that made it.
class RenderThread {
  public:
    // The device is made on the thread; a failure comes as an event. `keeper` as FrameRenderer. `listener` is
    // called on that thread.
    RenderThread(gpu::Instance instance, std::string preferredDevice, std::shared_ptr<SceneKeeper> keeper,
                 RenderListener listener);
    // Stops and joins: takes as long as the dispatch in flight.
    ~RenderThread();

    // Sets the sequence number and the time, and returns the number.
    std::uint64_t publish(FrameInput input);

    // Waits until nothing refers to the place any more, whose surface the window system destroys next: as
    // long as it takes, because a driver that loses a surface in use takes the process with it. The only wait
    // in the other direction.
    void releaseScreen();

  private:
    void run(const std::stop_token& stop, gpu::Instance instance, std::string preferredDevice,
             std::shared_ptr<SceneKeeper> keeper, RenderListener listener);

    FrameInput last_;
    Latest<FrameInput> inputs_;
    Latest<std::uint64_t> released_;  // sequence of the input without place that was taken
    std::jthread thread_;             // last: it uses all of the above
};

}  // namespace macula::app
