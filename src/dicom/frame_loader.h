// One image of a stack by itself.
#pragma once

#include <cstddef>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "dicom/stack/stack.h"

namespace macula::dicom {

// As acquired: row by row from the first one, columns as in the file.
struct LoadedFrame {
    int columns = 0;
    int rows = 0;
    std::vector<float> values;  // in units, as those of loadVolume; NaN is padding
};

// Decodes stack.frames[frame] and reads no other; also of a stack that is no volume. Bits beyond the stored
// ones are dropped, and a HighBit that its pixels contradict is not believed, without the look at other
// frames that loadVolume takes. Fails with inputNotUsable (of colour too; `where` is the file), outOfMemory,
// or cancelled. May take long where the file does.
Result<LoadedFrame> loadFrame(const Stack& stack, std::size_t frame, const CancelToken& cancel = {});

}  // namespace macula::dicom
