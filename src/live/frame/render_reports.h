// What a renderer tells its listener.
#pragma once

#include <chrono>
#include <cstdint>
#include <utility>

#include "base/timeline.h"
#include "live/frame/render_events.h"
#include "pipeline/hybrid/model/model_news.h"

namespace macula::live {

// Used by the render thread alone: there the listener is called.
class RenderReports {
  public:
    explicit RenderReports(RenderListener listener) : listener_(std::move(listener)) {}

    void tell(RenderEvent event) const { listener_(std::move(event)); }
    // Tells of the model no more often than a person can read it.
    void tellOfModel(std::uint64_t study, const hybrid::ModelNews& news);
    // Tells a few times a second, however often it is called.
    void tellOfTime(const Timeline& timeline);

  private:
    using Clock = std::chrono::steady_clock;

    RenderListener listener_;
    hybrid::ModelNews modelTold_;
    Clock::time_point modelToldAt_{};
    Clock::time_point timeToldAt_{};
};

}  // namespace macula::live
