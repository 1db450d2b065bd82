// The measured pace of the device, by kind of dispatch, from which the size of the next dispatch follows.
#pragma once

#include <map>
#include <tuple>

#include "pipeline/trace/trace_kernels.h"

namespace macula::trace {

// A kind of dispatch; the pace of each kind is learnt separately.
struct Work {
    TraceVariant variant;
    int bounces = 1;
    bool isAdaptive = false;  // on blocks chosen for their noise, which take longer
    // The dispatch has fewer threads than the device holds. It then takes as long as the slowest thread,
    // which says nothing about the pace of a device that is fully busy.
    bool leavesIdle = false;

    bool operator<(const Work& b) const {
        return std::tie(variant, bounces, isAdaptive, leavesIdle) <
               std::tie(b.variant, b.bounces, b.isAdaptive, b.leavesIdle);
    }
};

class Pace {
  public:
    // The pace assumed for a device before anything is measured.
    struct Guess {
        double perMs = 0.1;   // samples of a block, on a very slow CPU
        double faster = 2.0;  // the most by which a dispatch may exceed the last one
    };
    Pace() = default;
    explicit Pace(const Guess& guess) : guess_(guess) {}
    // For a graphics card of ten years ago. From the guess for a CPU, a card of today would need some fifteen
    // dispatches, each as long as its longest path, to reach one that keeps it busy.
    static constexpr Guess graphicsCard() { return {.perMs = 20.0, .faster = 8.0}; }

    // Samples of one block per millisecond; a cautious guess until learn() has measured some.
    double perMs(const Work& work) const;
    void learn(const Work& work, double blockSamples, double ms);

  private:
    Guess guess_;
    std::map<Work, double> perMs_;
};

}  // namespace macula::trace
