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

    bool operator<(const Work& b) const {
        return std::tie(variant, bounces, isAdaptive) < std::tie(b.variant, b.bounces, b.isAdaptive);
    }
};

class Pace {
  public:
    // Samples of one block per millisecond; a careful guess until something was learnt.
    double perMs(const Work& work) const;
    void learn(const Work& work, double blockSamples, double ms);

  private:
    std::map<Work, double> perMs_;
};

}  // namespace macula::trace
