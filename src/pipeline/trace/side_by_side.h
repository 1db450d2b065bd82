// How many samples of a pixel are traced side by side, each by its own thread.
//
// Where the pixels alone keep a graphics card busy, one thread traces all samples of a pixel, one after
// another. A smaller picture, such as that of a fovea, would take as long as its slowest thread, with most of
// the card idle; so there a thread that is done takes the next sample of any pixel. Measured on an H200
// (docs/measurements/gpu.md): up to twice as fast at 720 x 720, some 7 times at 181 x 181, no difference at
// 1440 x 1440. A CPU device has only a thread for each core, so there is nothing to gain: all samples of a
// pixel stay in one thread.
//
// Pictures do not depend on this choice: a sample is a function of pixel, seed and index, and the light of
// samples is summed in the order of their indices (shaders/trace/add_samples.comp).
#pragma once

#include <cstdint>

namespace macula::trace {

class SideBySide {
  public:
    // `threadsAtOnce` as in DeviceInfo; 0: all samples of a pixel stay in one thread.
    explicit SideBySide(std::uint32_t threadsAtOnce);

    // For tests and measurements: traces so many samples of each pixel side by side on any device; 0: as
    // described above.
    void force(std::uint32_t samples) { forced_ = samples; }

    // The number of blocks that keep the whole device busy with one thread for each pixel; 0: a single block
    // does.
    std::uint32_t blocksAtOnce() const { return blocksAtOnce_; }
    // The fewest blocks of a dispatch with at most `samples` for each block. With one thread for each pixel
    // they keep the device busy once. Side by side, where threads are shorter, they fill it up to four times
    // over: otherwise much of the time would be spent on the longest path of each dispatch.
    std::uint32_t leastBlocks(bool isSideBySide, std::uint32_t samples) const;
    // Whether a picture of so many blocks is traced side by side. Depends on nothing that changes between
    // passes, so that neither chance nor timing decides which kernel makes a picture.
    bool isFor(std::uint32_t blocks) const;

    // The threads of a dispatch of so many blocks with at most `samples` each: one for each sample, but no
    // more than the device holds at once, because a thread that is done takes the next sample.
    std::uint32_t threads(std::uint32_t blocks, std::uint32_t samples) const;
    // The threads for each pixel of a block with at most `samples`, if the device held any number; all take
    // the same number of samples, or one fewer. At least 1.
    std::uint32_t threadsPerPixel(std::uint32_t samples) const;
    // The most samples of a pixel in a pass over so many blocks, with at most `samplesPerThread` in a thread;
    // fewer where their light would need more memory than kMostBlockSamples. At least 1.
    std::uint32_t mostSamples(std::uint32_t blocks, std::uint32_t samplesPerThread) const;
    // The most block samples (blocks times samples) whose light a dispatch keeps, 64 MiB; one for each block
    // if there are more blocks.
    static constexpr std::uint32_t kMostBlockSamples = 1 << 16;

  private:
    std::uint32_t mostThreads() const;  // for each pixel

    std::uint32_t blocksAtOnce_;
    std::uint32_t forced_ = 0;
};

}  // namespace macula::trace
