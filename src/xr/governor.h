// Decides how much work fits into a frame, so that each is ready when the headset needs it: a slow device
// gets fewer samples, then coarser pictures, but never fewer frames. Knows no OpenXR, device or clock.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace macula::xr {

struct FrameQuality {
    std::uint32_t mostSamples = 16;  // per pixel of the fovea, while neither head nor eyes move
    int framesPerFovea = 1;          // tracing goes on in every n-th frame
    double scale = 1.0;              // of the width and height of the eyes' pictures

    bool operator==(const FrameQuality&) const = default;
};

enum class Work { fovea, model };  // what is done after a frame was submitted

class Governor {
  public:
    // From the best level to one that every device can afford: first the fovea gets less, then the pictures.
    static constexpr std::array<FrameQuality, 11> kLevels{{{16, 1, 1.0},
                                                           {8, 1, 1.0},
                                                           {4, 2, 1.0},
                                                           {1, 3, 1.0},
                                                           {1, 4, 0.84},
                                                           {1, 4, 0.71},
                                                           {1, 4, 0.59},
                                                           {1, 4, 0.5},
                                                           {1, 4, 0.42},
                                                           {1, 4, 0.35},
                                                           {1, 4, 0.3}}};
    // Our share of the time between two frames; the rest is for the runtime, which uses the device, too.
    static constexpr double kOurShare = 0.7;
    // Steps up to a better level when that would take less than this share.
    static constexpr double kRoomShare = 0.5;
    // Steps up after this many frames with room; twice as many each time that the better level did not last,
    // up to kMostPatience times as many.
    static constexpr int kFramesWithRoom = 45;
    static constexpr int kMostPatience = 16;
    // Share of frames that work may make late: on a slow device the model could not learn otherwise.
    static constexpr double kLateShare = 0.03;
    static constexpr double kLeastWorkMs = 1.0;

    const FrameQuality& quality() const { return kLevels[level_]; }
    std::size_t level() const { return level_; }
    std::uint64_t stepsDown() const { return stepsDown_; }
    std::uint64_t stepsUp() const { return stepsUp_; }

    // Call both for each frame with pictures: the frame period, and then the time from the frame's begin
    // until the device had drawn it. Invalid times are ignored; a pause of seconds counts only as one late
    // frame.
    void notePeriod(double periodMs);
    void noteFrame(double drawnMs);

    // The time budget of the next piece of work, `usedMs` after the frame was begun; nothing: it would make
    // the next frame late. Call it once for each frame and kind.
    std::optional<double> timeFor(Work work, double usedMs);
    // Notes how long the work took: it runs for at least one dispatch, whatever its budget.
    void noteWork(Work work, double toldMs, double tookMs);

  private:
    struct Habit {
        double overrunMs = 0.0;  // how far recent work exceeded its budget
    };

    static constexpr std::array<int, kLevels.size()> filledWithOne() {
        std::array<int, kLevels.size()> ones{};
        ones.fill(1);
        return ones;
    }
    void change(std::size_t level);
    double predictedMs(double drawnMs, std::size_t level) const;

    std::size_t level_ = 0;
    double periodMs_ = 0.0;  // 0: not known
    double usedMs_ = 0.0;    // as passed to the last timeFor()
    std::uint64_t frames_ = 0;
    int late_ = 0;      // + kForgetsLate for a late frame, - 1 for any other
    int withRoom_ = 0;  // frames with room, in a row
    std::array<int, kLevels.size()> patience_ = filledWithOne();  // factor of the wait for each level
    int sinceStepUp_ = -1;  // frames; below 0: the last step was down, or it has lasted
    std::uint64_t stepsDown_ = 0;
    std::uint64_t stepsUp_ = 0;
    std::array<Habit, 2> habits_;
    double latePeriods_ = 0.0;  // frame periods that work may still waste
};

}  // namespace macula::xr
