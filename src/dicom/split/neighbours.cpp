#include "dicom/split/neighbours.h"

#include <cmath>

namespace macula::dicom {

namespace {

constexpr double kSameMm = 0.01;
constexpr double kSameStep = 0.2;  // of the step

struct Candidate {
    Series* series;
    Stack* stack;
};

glm::dvec3 stepOf(const Stack& stack) {
    return glm::dvec3((*stack.worldFromVoxel)[2]);
}

bool follows(const Stack& first, const Stack& second) {
    const Frame& a = first.frames.front();
    const Frame& b = second.frames.front();
    if (a.frameOfReferenceUid.empty() || a.frameOfReferenceUid != b.frameOfReferenceUid) {
        return false;
    }
    if (first.columns != second.columns || first.rows != second.rows) return false;
    const glm::dmat4& m = *first.worldFromVoxel;
    const glm::dmat4& n = *second.worldFromVoxel;
    const double step = glm::length(stepOf(first));
    for (int axis = 0; axis < 2; ++axis) {
        if (glm::length(glm::dvec3(m[axis]) - glm::dvec3(n[axis])) > 1e-4 * glm::length(glm::dvec3(m[axis])))
            return false;
    }
    if (glm::length(stepOf(first) - stepOf(second)) > kSameStep * step) return false;
    const glm::dvec3 gap = *second.firstPositionMm - *first.lastPositionMm - stepOf(first);
    return glm::length(gap) <= kSameStep * step + kSameMm;
}

}  // namespace

void reportNeighbours(std::vector<Series>& series) {
    std::vector<Candidate> candidates;
    for (Series& s : series) {
        for (Stack& stack : s.stacks) {
            if (stack.isEven()) candidates.push_back({&s, &stack});
        }
    }
    constexpr std::size_t kMostCompared = 500;
    if (candidates.size() > kMostCompared) return;
    for (const Candidate& a : candidates) {
        for (const Candidate& b : candidates) {
            if (a.series == b.series || !a.series->number || !b.series->number ||
                !follows(*a.stack, *b.stack))
                continue;
            const auto tell = [](const Candidate& of, const Candidate& other) {
                of.stack->messages.push_back(
                    message(key::kContinuesInOtherSeries,
                            {{"number", std::int64_t(other.series->number.value_or(0))}}));
            };
            tell(a, b);
            tell(b, a);
        }
    }
}

}  // namespace macula::dicom
