// Reports of a renderer to its listener.
#pragma once

#include <chrono>
#include <cstdint>
#include <utility>

#include "base/timeline.h"
#include "live/frame/render_events.h"
#include "pipeline/hybrid/model/model_news.h"

namespace macula::live {

// Used by the render thread alone; it calls the listener.
class RenderReports {
  public:
    explicit RenderReports(RenderListener listener) : listener_(std::move(listener)) {}

    void tell(RenderEvent event) const { listener_(std::move(event)); }
    // Reports the state of the model, but no more often than a person can read.
    void tellOfModel(std::uint64_t study, const hybrid::ModelNews& news);
    // Reports the time spent by stage, a few times a second at most.
    void tellOfTime(const Timeline& timeline);

  private:
    using Clock = std::chrono::steady_clock;

    RenderListener listener_;
    hybrid::ModelNews modelTold_;
    Clock::time_point modelToldAt_{};
    Clock::time_point timeToldAt_{};
};

}  // namespace macula::live
