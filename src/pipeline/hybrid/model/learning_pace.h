// How long the parts of learning take on this device, and so which ones fit into the time before the next
// frame is due. Only the rules: no device, no clock.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace macula::hybrid {

// The parts of learning that cannot be interrupted.
enum class LearningPart {
    step,   // of training or judging
    show,   // make the learnt model the drawn one
    ask,    // which view teaches most
    trace,  // a dispatch of that view
    take,   // read it back, and give it to the trainer
};
inline constexpr std::size_t kLearningParts = 5;

// The name in reports; a string literal.
std::string_view nameOf(LearningPart part);

class LearningPace {
  public:
    // Notes how long a part took. A longer time than expected counts at once, a shorter one gradually: a
    // frame has to wait for the slowest.
    void took(LearningPart part, double ms);
    // Notes that a step was not begun for lack of time, and expects a little less from now on: otherwise one
    // slow step, such as one of judging, would forbid all later ones.
    void refusedStep();
    // Nothing until the part has been done once.
    std::optional<double> expectedMs(LearningPart part) const;
    // Whether the part is expected to fit into `leftMs`, with some time to spare.
    bool fits(LearningPart part, double leftMs) const;

  private:
    std::array<std::optional<double>, kLearningParts> expectedMs_;
};

}  // namespace macula::hybrid
