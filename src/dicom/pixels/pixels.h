// Decodes the pixels of one file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "dicom/stack/intensity.h"

namespace macula::dicom {

// The pixel description of the header.
struct PixelLayout {
    std::string transferSyntaxUid;
    int columns = 0;
    int rows = 0;
    int frames = 1;
    CellFormat format;                      // of a sample
    int samplesPerPixel = 1;                // or 3
    std::string photometricInterpretation;  // of three samples
    bool isByPlane = false;                 // Planar Configuration 1, of three samples
};

// An open file, whose frames can be read in any order; deflated files are fastest in ascending order. Takes
// memory for one frame only. Movable; used by one thread at a time. Errors are inputNotUsable with the file's
// path in `where`, or outOfMemory.
class PixelReader {
  public:
    // Fails when the file is gone, changed since the scan, holds no pixel data that can be found, or is in a
    // transfer syntax this build cannot decode. For a deflated file, reading fails once `cancel` is
    // cancelled.
    static Result<PixelReader> open(const std::filesystem::path& file, const PixelLayout& layout,
                                    CancelToken cancel = {});
    PixelReader(PixelReader&&) noexcept;
    PixelReader& operator=(PixelReader&&) noexcept;
    ~PixelReader();

    // Whether the file ends before this frame does: read() will fail.
    bool isCutOff(int frame) const;

    // One sample per pixel: frame `frame`, from 0, into `cells` (rows * columns, row by row), as the file has
    // them: see unpackCells for what follows. Only for isNarrow formats. Fails also when the frame is cut
    // off, or damaged.
    Result<void> read(int frame, std::span<std::uint16_t> cells);

    // The same for all formats, as raw values: masked and with their sign.
    Result<void> readNumbers(int frame, std::span<double> numbers);

    // Three samples per pixel, of 8 or 16 bits allocated: pixel by pixel into `samples` (3 * rows * columns).
    // Returns their photometric interpretation: each pixel has its own colour, also after YBR_FULL_422.
    Result<std::string> readColours(int frame, std::span<std::uint16_t> samples);

  private:
    struct Impl;
    explicit PixelReader(std::unique_ptr<Impl> impl);

    std::unique_ptr<Impl> impl_;
};

}  // namespace macula::dicom
