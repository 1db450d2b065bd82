// Loads a single image of a stack.
#pragma once

#include <cstddef>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "dicom/stack/stack.h"

namespace macula::dicom {

// The image as in the file, row by row from the first one.
struct LoadedFrame {
    int columns = 0;
    int rows = 0;
    std::vector<float> values;  // in units, as those of loadVolume; NaN is padding
};

// Decodes stack.frames[frame] alone; the stack need not be a volume. Drops bits beyond the stored ones and
// corrects a HighBit that its pixels contradict, without the comparison with other frames in loadVolume.
// Fails with inputNotUsable (of colour too; `where` is the file), outOfMemory, or cancelled. May take as long
// as the file takes to read.
Result<LoadedFrame> loadFrame(const Stack& stack, std::size_t frame, const CancelToken& cancel = {});

}  // namespace macula::dicom
