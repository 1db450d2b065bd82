// The measured pace of the device, by kind of dispatch. It decides how large the next dispatch may be.
#pragma once

#include <map>
#include <tuple>

#include "pipeline/trace/trace_kernels.h"

namespace macula::trace {

// A kind of dispatch, whose pace is learnt apart from that of others.
struct Work {
    TraceVariant variant;
    int bounces = 1;
    bool isAdaptive = false;  // of blocks that noise chooses, which take longer
    // Has fewer threads than the device holds. It takes as long as the longest row of samples of one thread,
    // and tells nothing about how fast a device is that is busy.
    bool leavesIdle = false;

    bool operator<(const Work& b) const {
        return std::tie(variant, bounces, isAdaptive, leavesIdle) <
               std::tie(b.variant, b.bounces, b.isAdaptive, b.leavesIdle);
    }
};

class Pace {
  public:
    // What is known of a device before anything is measured.
    struct Guess {
        double perMs = 0.1;   // samples of a block: those of a very slow CPU
        double faster = 2.0;  // at most so much larger is a dispatch than the one before
    };
    Pace() = default;
    explicit Pace(const Guess& guess) : guess_(guess) {}
    // Of a graphics card of ten years ago. From the guess for a CPU on it would take a card of today some
    // fifteen dispatches, each as long as a path is, until one keeps all of it busy.
    static constexpr Guess graphicsCard() { return {.perMs = 20.0, .faster = 8.0}; }

    // Samples of one block per millisecond; a careful guess until something was learnt.
    double perMs(const Work& work) const;
    void learn(const Work& work, double blockSamples, double ms);

  private:
    Guess guess_;
    std::map<Work, double> perMs_;
};

}  // namespace macula::trace
