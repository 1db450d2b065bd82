#include "dicom/read/outline.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcxfer.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "dicom/read/dataset.h"
#include "dicom/read/transfer_syntax.h"

namespace macula::dicom {

namespace {

constexpr std::uint32_t kUndefined = 0xFFFFFFFF;
constexpr std::uint64_t kNoEnd = std::numeric_limits<std::uint64_t>::max();
constexpr std::size_t kDeepest = 64;
constexpr std::uint64_t kInflatedSpare = std::uint64_t{64} << 20;
constexpr std::uint64_t kMostInflated = std::uint64_t{2} << 30;
constexpr std::uint32_t kLargestValueKept = 256 << 10;          // twice the largest lookup table
constexpr std::uint32_t kLargestOverlayKept = 8 << 20;          // of an image of 8192 x 8192
constexpr std::size_t kLargestHeader = std::size_t{128} << 20;  // 50 000 frames
constexpr std::uint32_t kLongestFirstElement = 4096;

struct Encoding {
    bool explicitVr = true;
    bool bigEndian = false;

    bool operator==(const Encoding&) const = default;
};

struct Header {
    Tag tag{};
    Vr vr = 0;  // 0 when implicit, or when it is not a VR at all
    std::uint32_t length = 0;

    bool isItem() const { return tag == Tag{0xFFFE, 0xE000}; }
    bool isItemEnd() const { return tag == Tag{0xFFFE, 0xE00D}; }
    bool isSequenceEnd() const { return tag == Tag{0xFFFE, 0xE0DD}; }
};

// A level of nesting that the walk is in: a sequence, or one of its items.
struct Level {
    bool isSequence = false;
    bool ofFragments = false;  // items are bytes, not datasets
    bool ofPixels = false;     // the fragments of the image itself
    std::uint64_t end = kNoEnd;
    Encoding encoding;
};

bool isUpper(unsigned char c) {
    return c >= 'A' && c <= 'Z';
}

constexpr std::string_view kShortVrs = "AE AS AT CS DA DS DT FL FD IS LO LT PN SH SL SS ST TM UI UL US ";
constexpr std::string_view kLongVrs = "OB OD OF OL OV OW SQ SV UC UN UR UT UV ";

bool isOneOf(std::string_view vrs, unsigned char first, unsigned char second) {
    const std::array<char, 3> name{static_cast<char>(first), static_cast<char>(second), ' '};
    return vrs.find(std::string_view(name.data(), 3)) != std::string_view::npos;
}

bool isKnownVr(unsigned char first, unsigned char second) {
    return isUpper(first) && isUpper(second) &&
           (isOneOf(kShortVrs, first, second) || isOneOf(kLongVrs, first, second));
}

// VRs with a length of 16 bits (PS3.5 7.1.2). Unknown ones of two capitals have 32 bits, anything else 16: as
// DCMTK reads them.
bool hasShortLength(unsigned char first, unsigned char second) {
    return !isUpper(first) || !isUpper(second) || isOneOf(kShortVrs, first, second);
}

std::uint16_t wordAt(const unsigned char* b, bool bigEndian) {
    return static_cast<std::uint16_t>(bigEndian ? b[0] << 8 | b[1] : b[1] << 8 | b[0]);
}

std::uint32_t doubleWordAt(const unsigned char* b, bool bigEndian) {
    const std::uint32_t first = wordAt(b, bigEndian);
    const std::uint32_t second = wordAt(b + 2, bigEndian);
    return bigEndian ? first << 16 | second : second << 16 | first;
}

bool isPixelData(Tag tag) {
    return tag == tag::kPixelData || tag == Tag{0x7FE0, 0x0008} || tag == Tag{0x7FE0, 0x0009};
}

class Walk {
  public:
    Walk(ByteSource& source, ElementTree* tree) : source_(source), tree_(tree) {}

    Outline run(bool hasPreamble) {
        if (!hasPreamble || source_.skip(132)) {
            if (readMetaInformation() && beginDataset()) {
                while (step()) {
                }
            }
        }
        outline_.headerWhole = outline_.pixels || endedWell_;
        if (outline_.pixels && outline_.pixels->whole && !endedWell_) {
            outline_.strayBytes = source_.inflating() || source_.fileBytes() <= wellUntil_
                                      ? 1
                                      : source_.fileBytes() - wellUntil_;
        }
        if (tree_) tree_->finish();
        return outline_;
    }

  private:
    bool readHeader(const Encoding& encoding, Header& header) {
        std::array<unsigned char, 8> b{};
        if (!source_.read(b)) return false;
        header.tag = {wordAt(b.data(), encoding.bigEndian), wordAt(b.data() + 2, encoding.bigEndian)};
        header.vr = 0;
        if (!encoding.explicitVr || header.tag.group == 0xFFFE) {
            header.length = doubleWordAt(b.data() + 4, encoding.bigEndian);
            return true;
        }
        if (isUpper(b[4]) && isUpper(b[5])) header.vr = static_cast<Vr>(b[4] << 8 | b[5]);
        if (hasShortLength(b[4], b[5])) {
            header.length = wordAt(b.data() + 6, encoding.bigEndian);
            return true;
        }
        std::array<unsigned char, 4> length{};
        if (!source_.read(length)) return false;
        header.length = doubleWordAt(length.data(), encoding.bigEndian);
        return true;
    }

    // Group 2 is Explicit VR Little Endian, always (PS3.10 7.1), but not for all writers.
    bool readMetaInformation() {
        std::uint64_t end = kNoEnd;
        std::array<unsigned char, 8> first{};
        Encoding encoding;
        encoding.explicitVr = !source_.peek(first) || (isUpper(first[4]) && isUpper(first[5]));
        std::array<unsigned char, 2> group{};
        while (source_.position() < end && source_.peek(group)) {
            if (end == kNoEnd && wordAt(group.data(), false) != 2) break;
            Header header;
            if (!readHeader(encoding, header)) return false;
            if (header.tag.group != 2 || header.vr == vrOf("SQ") || header.length == kUndefined) return false;
            constexpr std::uint32_t kLongestKept = 64;  // a UID
            if (header.length > kLongestKept) {
                if (!source_.skip(header.length)) return false;
                continue;
            }
            std::array<unsigned char, kLongestKept> bytes{};
            const auto value = std::span(bytes).first(header.length);
            if (!source_.read(value)) return false;
            if (tree_) {
                const auto kept =
                    tree_->addValue({.tag = header.tag, .vr = header.vr, .length = header.length});
                std::copy(value.begin(), value.end(), kept.begin());
            }
            if (header.tag == Tag{0x0002, 0x0000} && header.length == 4) {
                // Uses the group length only if nothing else shows where the group ends: before deflated
                // data.
                groupEnd_ = source_.position() + doubleWordAt(value.data(), false);
            } else if (header.tag == Tag{0x0002, 0x0010}) {
                const std::string_view uid(reinterpret_cast<const char*>(value.data()), value.size());
                outline_.transferSyntaxUid = uid.substr(0, uid.find('\0'));
                while (outline_.transferSyntaxUid.ends_with(' ')) outline_.transferSyntaxUid.pop_back();
                if (groupEnd_ &&
                    DcmXfer(outline_.transferSyntaxUid.c_str()).getStreamCompression() == ESC_zlib)
                    end = *groupEnd_;
            }
        }
        return true;
    }

    bool beginDataset() {
        const DcmXfer syntax(outline_.transferSyntaxUid.c_str());
        outline_.datasetOffset = source_.position();
        const bool known = !outline_.transferSyntaxUid.empty() && syntax.getXfer() != EXS_Unknown;
        if (known && syntax.getStreamCompression() == ESC_zlib) {
            source_.beginInflating();
            encoding_ = {static_cast<bool>(syntax.isExplicitVR()), static_cast<bool>(syntax.isBigEndian())};
            return true;
        }
        std::array<unsigned char, 8> head{};
        if (!source_.peek(head)) return source_.ahead(1).empty();
        if (known) {
            encoding_ = {static_cast<bool>(syntax.isExplicitVR()), static_cast<bool>(syntax.isBigEndian())};
            const Encoding found = encodingOf(head);
            // Overrules the declared encoding only if the data cannot have it: otherwise another one would be
            // a guess.
            if (!encoding_.bigEndian && !found.bigEndian) encoding_ = found;
            return true;
        }
        encoding_ = {isUpper(head[4]) && isUpper(head[5]), head[0] == 0};
        if (outline_.transferSyntaxUid.empty()) {
            outline_.transferSyntaxUid = !encoding_.explicitVr ? "1.2.840.10008.1.2"
                                         : encoding_.bigEndian ? "1.2.840.10008.1.2.2"
                                                               : "1.2.840.10008.1.2.1";
        }
        return true;
    }

    // The encoding by the first element: a VR, or a length that is plausible.
    Encoding encodingOf(std::span<const unsigned char, 8> head) const {
        if (isKnownVr(head[4], head[5])) return {true, head[0] == 0 && head[1] != 0};
        const bool plausible = doubleWordAt(head.data() + 4, false) <= kLongestFirstElement;
        return plausible ? Encoding{false, false} : encoding_;
    }

    // Reads one element header, and then keeps, enters or skips its value. False at the end of the walk.
    bool step() {
        while (!levels_.empty() && source_.position() >= levels_.back().end) {
            if (source_.position() > levels_.back().end) return false;  // extends beyond its parent
            pop();
        }
        if (levels_.empty() && source_.ahead(1).empty()) {
            endedWell_ = source_.error() == 0;
            return false;
        }
        if (tree_ && tree_->bytes() > kLargestHeader) {
            outline_.headerTooLarge = true;
            return false;
        }
        const Encoding encoding = levels_.empty() ? encoding_ : levels_.back().encoding;
        if (levels_.empty()) wellUntil_ = source_.position();
        Header header;
        if (!readHeader(encoding, header)) return false;
        if (source_.inflating() && source_.position() > inflatedLimit()) return inflatesTooFar();
        if (!levels_.empty() && levels_.back().isSequence) return stepInSequence(header);
        if (header.isItemEnd() && !levels_.empty()) {
            pop();
            return true;
        }
        if (header.tag.group == 0xFFFE) return false;
        if (levels_.empty() && header.tag.key() > tag::kPixelData.key()) {
            endedWell_ = !outline_.pixels || isPlausibleAfterPixels(header, encoding);
            return false;
        }
        if (levels_.empty() && outline_.pixels) {
            // Tags ascend (PS3.5 7.1): none up to PixelData may follow the pixel data, except pixel data once
            // more.
            if (!isPixelData(header.tag)) return false;
            outline_.pixels->repeated = true;
        }
        return stepIntoElement(header, encoding);
    }

    // Whether an element follows the pixel data, and not stray bytes or further pixels.
    bool isPlausibleAfterPixels(const Header& header, const Encoding& encoding) const {
        if (encoding.explicitVr && header.vr == 0) return false;
        return header.length == kUndefined || source_.inflating() || header.length <= source_.bytesLeft();
    }

    bool stepInSequence(const Header& header) {
        if (header.isSequenceEnd()) {
            pop();
            return true;
        }
        if (!header.isItem()) return false;
        if (levels_.back().ofFragments) {
            if (header.length == kUndefined) return false;
            if (source_.inflating() && source_.position() + header.length > inflatedLimit())
                return inflatesTooFar();
            if (levels_.back().ofPixels) noteFragment(header.length);
            return source_.skip(header.length);
        }
        constexpr std::uint64_t kItemHeaderBytes = 8;
        if (tree_) tree_->openItem(source_.position() - kItemHeaderBytes);
        levels_.push_back({.end = endOf(header.length), .encoding = levels_.back().encoding});
        return true;
    }

    // Examines how a fragment of the image begins.
    void noteFragment(std::uint32_t bytes) {
        if (std::exchange(beforeOffsetTable_, false)) return;  // the first item is that table
        PixelDataOutline& pixels = *outline_.pixels;
        constexpr std::size_t kMostMarkers = 4096;  // bytes that may precede the frame header of JPEG
        constexpr std::size_t kMagic = 16;
        const auto most = [&](std::size_t count) { return std::min<std::size_t>(count, bytes); };
        if (beginsStream(source_.ahead(most(kMagic)))) ++pixels.streams;
        if (++pixels.fragments > 1 || bytes == 0) return;
        const std::string_view found =
            syntaxInstead(outline_.transferSyntaxUid, source_.ahead(most(kMostMarkers)));
        if (found.empty()) return;
        outline_.contradictedSyntaxUid = std::move(outline_.transferSyntaxUid);
        outline_.transferSyntaxUid = found;
    }

    bool stepIntoElement(const Header& header, const Encoding& encoding) {
        const bool undefined = header.length == kUndefined;
        const Element element{.tag = header.tag,
                              .vr = header.vr,
                              .bigEndian = encoding.bigEndian,
                              .length = undefined ? 1 : header.length};
        if (levels_.empty() && isPixelData(header.tag) && !outline_.pixels)
            return stepIntoPixels(header, element, encoding);
        if (header.tag == tag::kPixelData && undefined) {  // the pixels of an icon
            if (tree_) tree_->add(element);
            return push(header.length, encoding, {.ofFragments = true});
        }
        if (undefined) {
            const bool unknown = header.vr == vrOf("UN");  // then implicit inside: PS3.5 6.2.2 note 2
            if (header.vr != 0 && !unknown && header.vr != vrOf("SQ") && header.vr != vrOf("OB") &&
                header.vr != vrOf("OW"))
                return false;
            if (tree_) tree_->openSequence(element);
            return push(header.length, unknown ? Encoding{false, false} : encoding, {});
        }
        if (header.length > 0 && isSequence(header, encoding)) {
            if (tree_) tree_->openSequence(element);
            return push(header.length, header.vr == vrOf("UN") ? encodingOfUnknown() : encoding, {});
        }
        if (source_.inflating() && source_.position() + header.length > inflatedLimit())
            return inflatesTooFar();
        return takeValue(header, element);
    }

    bool stepIntoPixels(const Header& header, const Element& element, const Encoding& encoding) {
        PixelDataOutline& pixels = outline_.pixels.emplace();
        pixels.tag = header.tag;
        pixels.encapsulated = header.length == kUndefined;
        pixels.offset = source_.position();
        if (tree_) {
            tree_->add(element);
            tree_->finish();
            tree_ = nullptr;
        }
        if (pixels.encapsulated)
            return push(header.length, encoding, {.ofFragments = true, .ofPixels = true});
        pixels.claimed = header.length;
        if (source_.inflating() && source_.position() + header.length > inflatedLimit())
            return inflatesTooFar();
        const std::uint64_t left = source_.bytesLeft();
        pixels.whole = source_.skip(header.length);
        pixels.present = pixels.whole          ? pixels.claimed
                         : source_.inflating() ? source_.position() - pixels.offset
                                               : std::min(left, pixels.claimed);
        return pixels.whole;
    }

    bool isSequence(const Header& header, const Encoding& encoding) {
        if (header.vr == vrOf("SQ")) return true;
        if ((header.vr != 0 && header.vr != vrOf("UN")) || encoding.bigEndian || header.length < 8)
            return false;
        std::array<unsigned char, 4> head{};
        if (!source_.peek(head) || doubleWordAt(head.data(), false) != 0xE000FFFE) return false;
        // An element that is private, or newer than the dictionary, is a sequence when its value begins like
        // an item.
        if (header.tag.isPrivate()) return true;
        const Vr known = dictionaryVr(header.tag);
        return known == vrOf("SQ") || known == 0;
    }

    // Inside an unknown VR everything is implicit (PS3.5 6.2.2 note 2), but not for every writer.
    Encoding encodingOfUnknown() {
        const auto head = source_.ahead(14);  // the header of an item, and the beginning of its first element
        return {head.size() == 14 && isKnownVr(head[12], head[13]), false};
    }

    bool push(std::uint32_t length, const Encoding& encoding, Level level) {
        if (++depth_ > kDeepest) {
            outline_.nestedTooDeep = true;
            return false;
        }
        level.isSequence = true;
        level.end = endOf(length);
        level.encoding = encoding;
        levels_.push_back(level);
        return true;
    }

    void pop() {
        const Level& level = levels_.back();
        if (level.ofPixels) outline_.pixels->whole = true;
        if (level.isSequence) --depth_;
        if (tree_ && !level.ofFragments) {
            if (level.isSequence) {
                tree_->closeSequence();
            } else {
                tree_->closeItem();
            }
        }
        levels_.pop_back();
    }

    std::uint64_t endOf(std::uint32_t length) const {
        return length == kUndefined ? kNoEnd : source_.position() + length;
    }

    bool takeValue(const Header& header, const Element& element) {
        if (tree_) {
            const bool isOverlay = (header.tag.group & 0xFF00) == 0x6000 && header.tag.element == 0x3000;
            if (header.length > (isOverlay ? kLargestOverlayKept : kLargestValueKept)) {
                tree_->add(element);
                return source_.skip(header.length);
            }
            const auto value = tree_->addValue(element);
            if (!source_.read(value)) return false;
            noteImageSize(header, value);
            return true;
        }
        std::array<unsigned char, 12> value{};
        if (!source_.inflating() || header.tag.group != 0x0028 || header.length > value.size())
            return source_.skip(header.length);
        if (!source_.read(std::span(value).first(header.length))) return false;
        noteImageSize(header, std::span(value).first(header.length));
        return true;
    }

    // Notes the size of the image, which bounds how large an inflated file may be.
    void noteImageSize(const Header& header, std::span<const unsigned char> value) {
        if (!levels_.empty() || header.tag.group != 0x0028) return;
        if (header.tag == tag::kNumberOfFrames) {
            const std::string_view text(reinterpret_cast<const char*>(value.data()), value.size());
            const std::size_t first = std::min(text.find_first_not_of(' '), text.size());
            std::from_chars(text.data() + first, text.data() + text.size(), frames_);
        } else if (value.size() == 2) {
            const std::uint64_t number = wordAt(value.data(), encoding_.bigEndian);
            if (header.tag == tag::kRows) rows_ = number;
            if (header.tag == tag::kColumns) columns_ = number;
            if (header.tag == tag::kSamplesPerPixel) samples_ = number;
            if (header.tag == tag::kBitsAllocated) bits_ = number;
        }
    }

    std::uint64_t inflatedLimit() const {
        const double image = static_cast<double>(rows_ * columns_) * static_cast<double>(samples_ * bits_) /
                             8.0 * static_cast<double>(frames_);
        return static_cast<std::uint64_t>(
            std::min(4.0 * image + static_cast<double>(kInflatedSpare), static_cast<double>(kMostInflated)));
    }

    bool inflatesTooFar() {
        outline_.inflatesTooFar = true;
        return false;
    }

    ByteSource& source_;
    ElementTree* tree_;  // null if not requested, and after the pixel data
    Outline outline_;
    Encoding encoding_;
    std::optional<std::uint64_t> groupEnd_;
    std::vector<Level> levels_;
    std::size_t depth_ = 0;
    bool endedWell_ = false;         // the walk ended at the end of the file, or past the pixel data
    std::uint64_t wellUntil_ = 0;    // where the last element of the top level ends
    bool beforeOffsetTable_ = true;  // the next item of the image is its offset table
    std::uint64_t rows_ = 0, columns_ = 0, samples_ = 1, bits_ = 16, frames_ = 1;
};

}  // namespace

Outline outlineOf(ByteSource& source, bool hasPreamble, ElementTree* tree) {
    return Walk(source, tree).run(hasPreamble);
}

Outline outlineOf(const std::filesystem::path& file, bool hasPreamble) {
    ByteSource source(file);
    return outlineOf(source, hasPreamble, nullptr);
}

}  // namespace macula::dicom
