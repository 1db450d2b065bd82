#include "dicom/split/other_series.h"

#include <algorithm>
#include <cmath>

#include "dicom/split/stack_ends.h"

namespace macula::dicom {

namespace {

struct OfSeries {
    const Series* series = nullptr;
    Stack* stack = nullptr;
};

struct Farther {
    Text what;
    double mm = 0.0;
};

StackEnd opposite(StackEnd end) {
    return end == StackEnd::first ? StackEnd::last : StackEnd::first;
}

Farther fartherVolume(const OfSeries& of, const std::vector<OfSeries>& volumes, StackEnd end) {
    constexpr double kFewestSlices = 5.0;
    constexpr double kLeastMm = 15.0;
    constexpr double kLeastShare = 0.1;
    const Stack& stack = *of.stack;
    const double lengthMm = stepMm(stack) * static_cast<double>(stack.frames.size() - 1);
    Farther farthest{.mm = std::max({kFewestSlices * stepMm(stack), kLeastMm, kLeastShare * lengthMm})};
    for (const OfSeries& other : volumes) {
        if (other.series == of.series || other.stack->modality != stack.modality) continue;
        const auto reach = reachOfParallel(stack, *other.stack);
        if (!reach || !endsAlike(stack, *other.stack, *reach, opposite(end))) continue;
        const double mm = beyondMm(stack, *reach, end);
        if (mm < farthest.mm) continue;
        const int number = other.series->number.value_or(0);
        farthest = {number > 0 ? Text("Series {}", number) : Text("Another series"), mm};
    }
    return farthest;
}

// CT is planned on its localizers, so that these normally end not far beyond the slices.
Farther fartherLocalizer(const Stack& stack, const std::vector<Series>& all, StackEnd end) {
    constexpr double kLeastShare = 0.4;
    constexpr double kMostAtOtherEnd = 0.25;
    Farther farther;
    if (stack.modality != "CT") return farther;
    for (const Series& series : all) {
        for (const Stack& localizer : series.stacks) {
            if (!isLocalizer(localizer)) continue;
            const auto reach = reachOfLocalizer(stack, localizer);
            if (!reach) continue;
            const double coveredMm = reach->lastMm - reach->firstMm;
            const double mm = beyondMm(stack, *reach, end);
            const double otherMm = beyondMm(stack, *reach, opposite(end));
            if (mm >= kLeastShare * coveredMm && std::abs(otherMm) <= kMostAtOtherEnd * coveredMm)
                farther = {Text("The localizer"), mm};
        }
    }
    return farther;
}

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

void reportFartherReach(std::vector<Series>& series) {
    std::vector<OfSeries> volumes;
    for (Series& s : series) {
        for (Stack& stack : s.stacks) {
            if (stack.canBeVolume() && stack.frames.size() > 1) volumes.push_back({&s, &stack});
        }
    }
    constexpr std::size_t kMostCompared = 2000;
    if (volumes.size() > kMostCompared) return;
    for (const OfSeries& of : volumes) {
        for (const StackEnd end : kStackEnds) {
            Farther farther = fartherVolume(of, volumes, end);
            if (farther.what.empty()) farther = fartherLocalizer(*of.stack, series, end);
            if (farther.what.empty()) continue;
            of.stack->messages.push_back(
                message(key::kOthersReachFarther,
                        {{"other", farther.what}, {"mm", farther.mm}, {"side", sideBeyond(*of.stack, end)}}));
        }
    }
}

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
