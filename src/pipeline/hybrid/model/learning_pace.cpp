#include "pipeline/hybrid/model/learning_pace.h"

#include <cmath>

namespace macula::hybrid {

namespace {

constexpr double kWeightOfFaster = 0.2;
constexpr double kSpare = 1.25;
constexpr double kForgottenByRefusal = 0.97;  // one refusal a frame: halved in a third of a second

}  // namespace

std::string_view nameOf(LearningPart part) {
    switch (part) {
        case LearningPart::step:
            return "model: training steps";
        case LearningPart::show:
            return "model: make drawable";
        case LearningPart::ask:
            return "model: choose view";
        case LearningPart::trace:
            return "model: trace view";
        case LearningPart::take:
            return "model: take view";
    }
    return {};
}

void LearningPace::took(LearningPart part, double ms) {
    if (!std::isfinite(ms) || ms < 0.0) return;
    std::optional<double>& expected = expectedMs_.at(std::size_t(part));
    if (!expected || ms > *expected)
        expected = ms;
    else
        *expected += kWeightOfFaster * (ms - *expected);
}

void LearningPace::refusedStep() {
    std::optional<double>& expected = expectedMs_.at(std::size_t(LearningPart::step));
    if (expected) *expected *= kForgottenByRefusal;
}

std::optional<double> LearningPace::expectedMs(LearningPart part) const {
    return expectedMs_.at(std::size_t(part));
}

bool LearningPace::fits(LearningPart part, double leftMs) const {
    const std::optional<double> expected = expectedMs(part);
    return expected && kSpare * *expected <= leftMs;
}

}  // namespace macula::hybrid
