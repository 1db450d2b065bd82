// How pictures of splats are divided into tiles, and tiles among threads.
#pragma once

#include <cstdint>

namespace macula::splat {

// Where tile binning is done. `fast`: on a CPU device by the host, else by the device.
enum class ListMaker { fast, host, device };

// How the pixels of a tile are divided among threads. Zeros: the fastest values for the device.
struct RasterShape {
    int tileRows = 0;             // pixels, a multiple of rowsPerThread
    int rowsPerThread = 0;        // pixels of one column that a thread draws
    std::uint64_t mostPairs = 0;  // the most pairs of splat and tile in a picture
    ListMaker lists = ListMaker::fast;
};

}  // namespace macula::splat
