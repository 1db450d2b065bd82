// How long the parts of learning take on this device, and so which may be done in the time that is left
// before a frame is due: the rules alone, without device or clock.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace macula::hybrid {

// What learning cannot be interrupted in.
enum class LearningPart {
    step,   // of training, or of judging
    show,   // the model that was learnt becomes the one that is drawn
    ask,    // for the view that teaches most
    trace,  // a dispatch of it
    take,   // it is read back, and given to the trainer
};
inline constexpr std::size_t kLearningParts = 5;

// The name as in reports; a literal.
std::string_view nameOf(LearningPart part);

class LearningPace {
  public:
    // What took longer than expected is believed at once, what was faster by and by: whoever waits for a
    // frame waits for the slowest.
    void took(LearningPart part, double ms);
    // A step was not begun for lack of time. One that had more to do, such as judging, must not keep all
    // others from being tried for ever.
    void refusedStep();
    // Nothing before it was done once.
    std::optional<double> expectedMs(LearningPart part) const;
    // Whether it is expected to be done in that time, with something to spare.
    bool fits(LearningPart part, double leftMs) const;

  private:
    std::array<std::optional<double>, kLearningParts> expectedMs_;
};

}  // namespace macula::hybrid
