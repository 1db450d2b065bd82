// What a model learns from a traced view, on its way to the host while the next view is traced.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/reading.h"
#include "shared/primary_vertex.h"

namespace macula::trace {

class SampledPicture;

// The radiance and samples of a TracedImage, and the guides' coverage along the centre rays: a quarter of the
// bytes of a TracedImage and its guides, and little work for the host.
struct TracedColours {
    int width = 0;
    int height = 0;
    std::vector<glm::vec4> radiance;
    std::vector<std::uint32_t> samples;
    std::vector<float> coverage;
    double meanSamples = 0.0;  // of `samples`
};

struct WantedReading {
    bool primaries = false;
    bool colours = false;
};

// PathTracer::beginReading may begin it again and again; only the thread that uses the device may begin,
// finish and destroy it. Once finished, any thread may read the results, until it begins again.
class ViewReading {
  public:
    Result<void> finish() { return reading_.finish(); }  // waits

    // As tracePrimaries returns them; empty if they were not wanted.
    std::span<const shared::PrimaryVertex> primaries() const;
    // As readColours returns them; only if they were wanted. Works on all cores.
    TracedColours colours() const;

  private:
    friend Result<void> beginReading(SampledPicture& picture, ViewReading& reading,
                                     const WantedReading& wanted);

    gpu::Reading reading_;  // primaries if wanted; matters, counts and light if colours are wanted
    int width_ = 0;
    int height_ = 0;
    std::uint32_t primarySamples_ = 0;  // 0: no primaries
    bool areMeans_ = false;             // the light is denoised
    double meanSamples_ = 0.0;
};

// PathTracer::beginReading
Result<void> beginReading(SampledPicture& picture, ViewReading& reading, const WantedReading& wanted);

}  // namespace macula::trace
