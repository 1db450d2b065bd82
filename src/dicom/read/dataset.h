// Reads headers. No file can make it throw, recurse, or take more memory than the header itself; without
// enough memory it throws std::bad_alloc.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "dicom/read/tags.h"

namespace macula::dicom {

// Rows and Columns are US in the standard; a header may use another VR, with any value.
inline constexpr int kMostRows = 65535;

enum class FileState {
    complete,
    notDicom,     // by its content, whatever the extension
    unreadable,   // cannot be opened or read
    offline,      // its content is elsewhere and not available now: a cloud drive, a share, a tape
    mediumError,  // the medium gives a read error: a scratched disc, a failing drive
    pathTooLong,  // for this system
    damaged,      // begins as DICOM, but cannot be parsed, or not safely (see outline.h)
    truncated,    // the header is whole, and the file ends inside the pixel data
};

class ByteSource;
struct HeaderFile;

// Reads the elements before the pixel data, and skips the pixels. Accepts files without preamble and file
// meta information (PS3.10 7.1). Once `cancel` is cancelled, a deflated file seems to end. Thread-safe.
HeaderFile readHeader(const std::filesystem::path& file, const CancelToken& cancel = {});

// A view of one file's data elements: those of its top level, of an item, or all that apply to one frame.
// Immutable, cheap to copy, safe to read from several threads; keeps the data that it needs alive.
class Dataset {
  public:
    // The transfer syntax UID of the file meta information, otherwise the one found from the content.
    const std::string& transferSyntaxUid() const;

    // Whether the element is present, and not empty.
    bool has(Tag tag) const;

    // All getters return nothing, and never a default, when the element is missing, empty, larger than 256
    // KiB (overlays: 8 MiB), or of another type. Text is UTF-8 (converted from SpecificCharacterSet, PS3.3
    // C.12.1.1.2) without padding and without direction controls (printable.h); text() keeps the backslashes
    // between several values, texts() splits at them.
    std::optional<std::string> text(Tag tag) const;
    std::vector<std::string> texts(Tag tag) const;
    // The same for elements that are read for every frame and short in real files: nothing for values above 4
    // KiB, and at most 64 bytes, or 16 values of 64 bytes.
    std::string shortText(Tag tag) const;  // empty when there is none
    std::vector<std::string> shortTexts(Tag tag) const;
    std::vector<double> shortNumbers(Tag tag) const;  // as allNumbers
    std::optional<double> number(Tag tag) const;      // finite
    std::optional<std::vector<double>> numbers(Tag tag,
                                               std::size_t count) const;  // exactly `count`, all finite
    std::vector<double> allNumbers(Tag tag) const;  // every value; none when any of them is not a number
    std::optional<int> integer(Tag tag) const;
    // The 16 bits of a US or SS, or of a whole number in another VR.
    std::optional<std::uint16_t> word(Tag tag) const;
    std::vector<std::uint16_t> words(Tag tag) const;  // all of US, SS or OW; of bytes, two make one

    // Whether some text of this view, outside sequences, contradicts the character set that the file declares
    // and was read by the fallback of character_set.h.
    bool charsetFallback() const;

    // The offset of the item in its file, by which the records of a DICOMDIR refer to each other; 0 for a top
    // level.
    std::uint32_t offset() const;

    // The items of a sequence, in their order; none when it is missing or no sequence.
    std::vector<Dataset> items(Tag sequence) const;
    std::size_t itemCount(Tag sequence) const;

    // Those of `tags` that occur twice, with different values, in one item of this view. The getters read the
    // first occurrence, as DCMTK does. A sequence that occurs twice counts as different.
    std::vector<Tag> contradicted(std::span<const Tag> tags) const;

    // The number of frames that the file claims; 1 when it does not say (PS3.3 C.7.6.6).
    int frameCount() const;
    // All that applies to frame `i`, from 0 (PS3.3 C.7.6.16): the macros of its item of
    // PerFrameFunctionalGroupsSequence, that item, the macros that all frames share, their item, and the top
    // level, searched in this order until one has a value. Only the first item of each macro counts; private
    // sequences are not macros. A frame without an item has only what all frames share. Costs little, however
    // many frames there are.
    Dataset frame(int i) const;

  private:
    struct File;
    struct Hit;
    Dataset(std::shared_ptr<const File> file, std::vector<std::uint32_t> items);
    Hit find(Tag tag) const;
    friend HeaderFile readHeader(const std::filesystem::path& file, const CancelToken& cancel);

    std::shared_ptr<const File> file_;
    std::vector<std::uint32_t> items_;  // items of the file's tree, searched in this order for a value
};

// The place of the pixel data in the file.
struct PixelDataExtent {
    Tag tag{};                  // PixelData, FloatPixelData or DoubleFloatPixelData
    bool encapsulated = false;  // as items of a sequence of fragments (PS3.5 A.4)
    std::uint64_t offset =
        0;  // where the value or the first item begins; in a deflated file, within the inflated data
    std::uint64_t bytesClaimed = 0;  // 0 when encapsulated
    std::uint64_t bytesPresent = 0;  // those of bytesClaimed that are in the file; 0 when encapsulated
    std::uint64_t fragments = 0;     // fragments and streams as in PixelDataOutline
    std::uint64_t streams = 0;
    bool whole = false;
    bool repeated = false;
};

struct HeaderFile {
    FileState state = FileState::notDicom;
    std::optional<Dataset> header;  // when complete or truncated
    std::uint64_t strayBytes = 0;   // bytes after the pixel data that are not elements
    std::optional<PixelDataExtent> pixels = {};
    std::string contradictedSyntaxUid = {};  // see Outline
};

// Whether the file has the 128 bytes and DICM of PS3.10 7.1.
bool hasPreamble(ByteSource& source);

// The tag of a standard data element by its keyword, as in PS3.6: "SliceThickness".
std::optional<Tag> tagOfKeyword(std::string_view keyword);

// offline, mediumError, pathTooLong or unreadable, by the errno of opening or reading a file.
FileState stateOfFailure(int error);

}  // namespace macula::dicom
