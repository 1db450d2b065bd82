// Whether frames were in time, and where their time went. Knows no OpenXR.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace macula::xr {

// The times of one frame.
struct FrameTimes {
    std::int64_t displayedNs = 0;  // the predicted time of display
    double periodMs = 0.0;
    bool isEmpty = false;  // submitted without pictures
    double waitMs = 0.0;   // waiting for the headset, before the frame began
    double lookMs = 0.0;   // reading hands and eyes
    double lendMs = 0.0;   // waiting until the headset lent images
    double drawMs = 0.0;   // recording the device's commands
    double submitMs = 0.0;
    double deviceMs = 0.0;  // waiting until the device had drawn
    double workMs = 0.0;    // spent on later frames
    double drawnMs = 0.0;   // from the frame's begin until the device had drawn
    std::size_t level = 0;  // the governor's level
};

struct FrameFigures {
    std::uint64_t frames = 0;  // submitted
    std::uint64_t empty = 0;   // how many of them had no pictures
    // Display times for which the headset had no new frame.
    std::uint64_t missed = 0;
    std::uint64_t late = 0;  // frames after which some were missed
    double periodMs = 0.0;   // the mean
    double longestMs = 0.0;  // the longest drawnMs
    FrameTimes mean;         // of frames with pictures
    std::size_t worstLevel = 0;
    std::size_t lastLevel = 0;

    // The share of display times with a new frame; 100 before the first frame.
    double inTimePercent() const;
};

class FrameStatistics {
  public:
    void note(const FrameTimes& frame);
    // The headset wanted no frames for a while, or another session began.
    void pause() { displayedNs_.reset(); }
    FrameFigures figures() const;

  private:
    FrameFigures sums_;  // means are sums
    std::optional<std::int64_t> displayedNs_;
};

// Lines for a person.
std::string textOf(const FrameFigures& figures);

}  // namespace macula::xr
