// The film, which sums samples pixel by pixel.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/resources.h"

namespace macula::trace {

// Lies on the device, row 0 on top. Used by one thread at a time, the one that uses the device.
class Film {
  public:
    static Result<Film> create(const std::shared_ptr<gpu::Device>& device, int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }

    void clear(gpu::Recorder& recorder) const;
    // The first bindings of shaders/trace/film.glsl; the plan comes after them.
    void appendTo(std::vector<gpu::Binding>& bindings) const;

    const gpu::Buffer& sums() const { return sums_; }       // vec4: premultiplied radiance and coverage
    const gpu::Buffer& counts() const { return counts_; }   // uint: finite samples
    const gpu::Image& picture() const { return picture_; }  // RGBA8, as PathTracer::display() makes it

    const gpu::Buffer& squares() const {
        return squares_;
    }  // vec2: sum of squares of luminance, and its compensation

    struct Faults {
        std::uint32_t nonFinite = 0;   // samples that were not finite, which the sums leave out
        std::uint32_t abandoned = 0;   // paths cut off at the limit of rounds (kMaxRounds)
        std::uint32_t aboveBound = 0;  // collisions in matter denser than its brick's majorant
    };
    Result<Faults> faults() const;  // waits
    const gpu::Buffer& faultsBuffer() const { return faults_; }

  private:
    Film(int width, int height, gpu::Buffer sums, gpu::Buffer lost, gpu::Buffer counts, gpu::Buffer faults,
         gpu::Buffer squares, gpu::Image picture);

    int width_;
    int height_;
    gpu::Buffer sums_;
    gpu::Buffer lost_;  // vec4: the compensation of Kahan's summation
    gpu::Buffer counts_;
    gpu::Buffer faults_;
    gpu::Buffer squares_;
    gpu::Image picture_;
};

}  // namespace macula::trace
