// How much is done in a frame, so that each is there when the headset wants it: as on a slow device fewer
// samples, then coarser pictures, and never fewer frames. Knows no OpenXR, device or clock.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace macula::xr {

struct FrameQuality {
    std::uint32_t mostSamples = 16;  // of each pixel of the fovea, while neither head nor eyes move
    int framesPerFovea = 1;          // it is traced on in every so manieth frame
    double scale = 1.0;              // of the sides of the pictures of the eyes

    bool operator==(const FrameQuality&) const = default;
};

enum class Work { fovea, model };  // what is done after a frame was submitted

class Governor {
  public:
    // From the best to what is always affordable: first the fovea, then the pictures.
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
    // Of the time between two frames; the rest is for the runtime, which takes its share of the device.
    static constexpr double kOurShare = 0.7;
    // A level is left for a better one when it would take less than that share there.
    static constexpr double kRoomShare = 0.5;
    // After so many frames with room; twice as many each time that the better level did not last, up to
    // kMostPatience times as many.
    static constexpr int kFramesWithRoom = 45;
    static constexpr int kMostPatience = 16;
    // Of all time, what work may take that does not fit: on a slow device nothing would be learnt else.
    static constexpr double kLateShare = 0.03;
    static constexpr double kLeastWorkMs = 1.0;

    const FrameQuality& quality() const { return kLevels[level_]; }
    std::size_t level() const { return level_; }
    std::uint64_t stepsDown() const { return stepsDown_; }
    std::uint64_t stepsUp() const { return stepsUp_; }

    // Of each frame with pictures: the time between two of them, and then from when it was begun to when the
    // device had drawn it. Times that are none are passed over; of a pause of seconds no more is believed
    // than that the frame was late.
    void notePeriod(double periodMs);
    void noteFrame(double drawnMs);

    // How long the next piece of work may be told to take, `usedMs` after the frame was begun; nothing: it
    // would make the next frame late. Once for each frame and kind.
    std::optional<double> timeFor(Work work, double usedMs);
    // What became of that: work goes on for at least one dispatch, whatever it was told.
    void noteWork(Work work, double toldMs, double tookMs);

  private:
    struct Habit {
        double overrunMs = 0.0;  // beyond what it was told, lately
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
    double usedMs_ = 0.0;    // of the frame for which there was time last
    std::uint64_t frames_ = 0;
    int late_ = 0;      // frames that took too long, of the last ones
    int withRoom_ = 0;  // frames in a row
    std::array<int, kLevels.size()> patience_ = filledWithOne();  // before each level is tried
    int sinceStepUp_ = -1;  // frames; below 0: the last step was none upwards, or it has lasted
    std::uint64_t stepsDown_ = 0;
    std::uint64_t stepsUp_ = 0;
    std::array<Habit, 2> habits_;
    double latePeriods_ = 0.0;  // that work may still take
};

}  // namespace macula::xr
