// How many samples of a pixel are traced side by side, each by a thread of its own.
//
// One thread takes all samples of a pixel, one after another, where the pixels alone keep a graphics card
// busy for long. A smaller picture, as that for a fovea, takes as long as the longest row of samples of one
// thread, while most of the card is idle; so there a thread takes
// one sample after another, of whichever pixel comes next. Measured on an H200
// (docs/measurements/gpu.md): up to twice as fast at 720 x 720, some 7 times at 181 x 181, no difference at
// 1440 x 1440. CPU devices have a thread for each core: there is nothing to gain, and all samples of a pixel
// stay in one thread.
//
// Pictures do not depend on it: a sample is a function of pixel, seed and number, and what they bring is
// summed in the order of their numbers (shaders/trace/add_samples.comp).
#pragma once

#include <cstdint>

namespace macula::trace {

class SideBySide {
  public:
    // As DeviceInfo has them; 0: all samples of a pixel stay in one thread.
    explicit SideBySide(std::uint32_t threadsAtOnce);

    // For tests and measurements: so many samples of each pixel, whatever the device; 0: as it is above.
    void force(std::uint32_t samples) { forced_ = samples; }

    // Blocks that keep all of the device busy with one thread for each pixel; 0: one does.
    std::uint32_t blocksAtOnce() const { return blocksAtOnce_; }
    // The fewest blocks of a dispatch, of which a block has so many samples: with one thread for each pixel
    // so many as keep the device busy; side by side as many as fill it up to four times, with threads that
    // are done sooner, as otherwise much of the time would go to the longest path of each dispatch.
    std::uint32_t leastBlocks(bool isSideBySide, std::uint32_t samples) const;
    // Whether a picture of so many blocks is traced so. It decides about all of its passes, so that chance
    // and time have no part in which kernel a picture is made with.
    bool isFor(std::uint32_t blocks) const;

    // Threads of a dispatch of so many blocks that have at most so many samples each: one for each of them,
    // but no more than the device holds at once, because each takes the next sample when it is done.
    std::uint32_t threads(std::uint32_t blocks, std::uint32_t samples) const;
    // Threads for each pixel, if there were any number of them, in a dispatch of blocks that have at most so
    // many samples; each takes as many samples, or one fewer. At least 1.
    std::uint32_t threadsPerPixel(std::uint32_t samples) const;
    // The most samples of a pixel in a pass over so many blocks, of which a thread takes at most
    // `samplesPerThread`; fewer where what they bring would need more memory than kMostBlockSamples. At least
    // 1.
    std::uint32_t mostSamples(std::uint32_t blocks, std::uint32_t samplesPerThread) const;
    // Samples of blocks that a dispatch keeps, but for one sample of each where there are more blocks: 64
    // MiB.
    static constexpr std::uint32_t kMostBlockSamples = 1 << 16;

  private:
    std::uint32_t mostThreads() const;  // for each pixel

    std::uint32_t blocksAtOnce_;
    std::uint32_t forced_ = 0;
};

}  // namespace macula::trace
