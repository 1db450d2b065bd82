// Measures where the time of a thread goes, in named, nested stages. Each instant belongs to the innermost
// stage, so that the times of all stages add up to the time that was watched.
//
//     Timeline timeline;
//     {
//         const Timeline::Watch watch(timeline);     // from now on, timeline records this thread's stages
//         const TimelineStage stage("train");
//         ... { const TimelineWait wait; ... }       // for the device, say
//     }
//
// On a thread that no timeline watches, a stage costs nothing.
#pragma once

#include <chrono>
#include <cstdint>
#include <string_view>
#include <vector>

namespace macula {

// Milliseconds exclude the stages within this one.
struct StageTimes {
    std::string_view name;  // a literal
    std::uint64_t times = 0;
    double ms = 0.0;
    double waitedMs = 0.0;   // the part of `ms` in which the thread waited
    double longestMs = 0.0;  // of a single run
};

// Subtracts `before`, an earlier state of the same timeline, from `now`, and drops the stages that did not
// run in between. `longestMs` still covers the time since the beginning.
std::vector<StageTimes> since(const std::vector<StageTimes>& before, std::vector<StageTimes> now);

// Used by one thread at a time.
class Timeline {
  public:
    class Watch {
      public:
        explicit Watch(Timeline& timeline);
        Watch(const Watch&) = delete;
        Watch& operator=(const Watch&) = delete;
        ~Watch();

      private:
        Timeline* outer_;
    };

    // The stages are in the order in which they first ended.
    const std::vector<StageTimes>& stages() const { return stages_; }

  private:
    friend class TimelineStage;
    friend class TimelineWait;

    std::vector<StageTimes> stages_;
    class TimelineStage* innermost_ = nullptr;
};

class TimelineStage {
  public:
    explicit TimelineStage(std::string_view name);  // a literal
    TimelineStage(const TimelineStage&) = delete;
    TimelineStage& operator=(const TimelineStage&) = delete;
    ~TimelineStage();

  private:
    friend class TimelineWait;
    using Clock = std::chrono::steady_clock;

    Timeline* timeline_;
    TimelineStage* outer_ = nullptr;
    std::string_view name_;
    Clock::time_point start_;
    double innerMs_ = 0.0;  // time of the stages within this one
    double waitedMs_ = 0.0;
};

// Counts its lifetime as waiting time of the innermost stage.
class TimelineWait {
  public:
    TimelineWait();
    TimelineWait(const TimelineWait&) = delete;
    TimelineWait& operator=(const TimelineWait&) = delete;
    ~TimelineWait();

  private:
    TimelineStage* stage_;
    std::chrono::steady_clock::time_point start_;
};

}  // namespace macula
