#include "dicom/outline.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctag.h>
#include <dcmtk/dcmdata/dcxfer.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <string>
#include <vector>

#include "dicom/byte_source.h"
#include "dicom/dataset.h"

namespace macula::dicom {

namespace {

constexpr std::uint32_t kUndefined = 0xFFFFFFFF;
constexpr std::uint64_t kNoEnd = std::numeric_limits<std::uint64_t>::max();
constexpr std::size_t kDeepest = 64;
constexpr std::size_t kMostItemsInDoubt = 1000;  // as levels, a tenth of what DCMTK's stack bears
constexpr std::uint64_t kInflatedSpare = std::uint64_t{64} << 20;
constexpr std::uint64_t kMostInflated = std::uint64_t{2} << 30;

struct Encoding {
    bool explicitVr = true;
    bool bigEndian = false;
};

struct Header {
    std::uint16_t group = 0;
    std::uint16_t element = 0;
    std::string vr;  // empty when implicit
    std::uint32_t length = 0;

    bool is(Tag tag) const { return group == tag.group && element == tag.element; }
    bool isItem() const { return is({0xFFFE, 0xE000}); }
    bool isItemEnd() const { return is({0xFFFE, 0xE00D}); }
    bool isSequenceEnd() const { return is({0xFFFE, 0xE0DD}); }
    bool isPixelData() const { return is(tag::kPixelData); }
};

// What the walk is inside of: a sequence, or one of its items.
struct Level {
    bool isSequence = false;
    bool ofFragments = false;  // items are bytes, not datasets
    std::uint64_t end = kNoEnd;
    Encoding encoding;
};

bool isUpper(unsigned char c) {
    return c >= 'A' && c <= 'Z';
}

// VRs with a length of 16 bits (PS3.5 7.1.2). Unknown ones of two capitals have 32 bits, anything else 16: as
// DCMTK reads them.
bool hasShortLength(const std::string& vr) {
    static constexpr std::string_view kShort =
        "AE AS AT CS DA DS DT FL FD IS LO LT PN SH SL SS ST TM UI UL US ";
    const bool capitals =
        isUpper(static_cast<unsigned char>(vr[0])) && isUpper(static_cast<unsigned char>(vr[1]));
    return !capitals || kShort.find(vr + ' ') != std::string_view::npos;
}

class Walk {
  public:
    explicit Walk(const std::filesystem::path& file) : source_(file) {}

    Outline run(bool hasPreamble) {
        if (hasPreamble && !source_.skip(132)) return outline_;
        if (readMetaInformation() && beginDataset()) {
            while (step()) {
            }
        }
        if (doubtful_) countItems();
        return outline_;
    }

  private:
    std::uint16_t word(const unsigned char* b, bool bigEndian) const {
        return static_cast<std::uint16_t>(bigEndian ? b[0] << 8 | b[1] : b[1] << 8 | b[0]);
    }
    std::uint32_t doubleWord(const unsigned char* b, bool bigEndian) const {
        const std::uint32_t first = word(b, bigEndian);
        const std::uint32_t second = word(b + 2, bigEndian);
        return bigEndian ? first << 16 | second : second << 16 | first;
    }

    bool readHeader(const Encoding& encoding, Header& header) {
        std::array<unsigned char, 8> b{};
        if (!source_.read(b)) return false;
        header.group = word(b.data(), encoding.bigEndian);
        header.element = word(b.data() + 2, encoding.bigEndian);
        header.vr.clear();
        if (!encoding.explicitVr || header.group == 0xFFFE) {
            header.length = doubleWord(b.data() + 4, encoding.bigEndian);
            return true;
        }
        header.vr = {static_cast<char>(b[4]), static_cast<char>(b[5])};
        if (hasShortLength(header.vr)) {
            header.length = word(b.data() + 6, encoding.bigEndian);
            return true;
        }
        std::array<unsigned char, 4> length{};
        if (!source_.read(length)) return false;
        header.length = doubleWord(length.data(), encoding.bigEndian);
        return true;
    }

    bool doubt() {
        doubtful_ = true;
        return false;
    }

    // Group 2 is Explicit VR Little Endian, always (PS3.10 7.1).
    bool readMetaInformation() {
        std::uint64_t end = kNoEnd;
        std::array<unsigned char, 2> group{};
        while (source_.position() < end && source_.peek(group)) {
            if (end == kNoEnd && word(group.data(), false) != 2) break;
            Header header;
            if (!readHeader({}, header)) return false;
            if (header.group != 2 || header.vr == "SQ" || header.length == kUndefined) return doubt();
            if (header.is({0x0002, 0x0000}) && header.length == 4) {
                std::array<unsigned char, 4> length{};
                if (!source_.read(length)) return false;
                // Only believed when nothing else can tell where the group ends: in front of deflated data.
                groupEnd_ = source_.position() + doubleWord(length.data(), false);
            } else if (header.is({0x0002, 0x0010}) && header.length <= 64) {
                std::string uid(header.length, '\0');
                if (!readText(uid)) return false;
                transferSyntaxUid_ = uid.c_str();
                while (transferSyntaxUid_.ends_with(' ')) transferSyntaxUid_.pop_back();
                if (groupEnd_ && DcmXfer(transferSyntaxUid_.c_str()).getStreamCompression() == ESC_zlib)
                    end = *groupEnd_;
            } else if (!source_.skip(header.length)) {
                return false;
            }
        }
        return true;
    }

    bool readText(std::string& text) {
        return source_.read({reinterpret_cast<unsigned char*>(text.data()), text.size()});
    }

    bool beginDataset() {
        const DcmXfer syntax(transferSyntaxUid_.c_str());
        if (transferSyntaxUid_.empty() || syntax.getXfer() == EXS_Unknown) {
            std::array<unsigned char, 6> head{};
            if (!source_.peek(head)) return false;
            encoding_ = {isUpper(head[4]) && isUpper(head[5]), head[0] == 0};
            return true;
        }
        if (syntax.getStreamCompression() == ESC_zlib) source_.beginInflating();
        encoding_ = {static_cast<bool>(syntax.isExplicitVR()), static_cast<bool>(syntax.isBigEndian())};
        return true;
    }

    // One header, and what it says to do with the value. False at the end of the walk.
    bool step() {
        while (!levels_.empty() && source_.position() >= levels_.back().end) {
            if (source_.position() > levels_.back().end) return doubt();  // reaches out of what it is in
            pop();
        }
        if (levels_.empty() && pixelsJustEnded_) notePixelEnd();
        const Encoding encoding = levels_.empty() ? encoding_ : levels_.back().encoding;
        Header header;
        if (!readHeader(encoding, header)) return false;
        if (source_.inflating() && source_.position() > inflatedLimit()) return inflatesTooFar();
        if (!levels_.empty() && levels_.back().isSequence) return stepInSequence(header);
        if (header.isItemEnd() && !levels_.empty()) {
            pop();
            return true;
        }
        if (header.group == 0xFFFE) return doubt();
        if (levels_.empty() && (header.group > 0x7FE0 || (header.group == 0x7FE0 && header.element > 0x0010)))
            return false;
        return stepIntoElement(header, encoding);
    }

    bool stepInSequence(const Header& header) {
        if (header.isSequenceEnd()) {
            pop();
            return true;
        }
        if (!header.isItem()) return doubt();
        if (levels_.back().ofFragments) return header.length != kUndefined && source_.skip(header.length);
        levels_.push_back({.end = endOf(header.length), .encoding = levels_.back().encoding});
        return true;
    }

    bool stepIntoElement(const Header& header, const Encoding& encoding) {
        const bool undefined = header.length == kUndefined;
        if (header.isPixelData() && levels_.empty()) {
            pixelsJustEnded_ = true;
            if (!undefined) outline_.nativePixelBytes = header.length;
        }
        if (header.isPixelData() && undefined) return push(kUndefined, encoding, true);
        if (undefined) {
            const bool unknown = header.vr == "UN";  // then implicit inside: PS3.5 6.2.2 note 2
            if (!header.vr.empty() && !unknown && header.vr != "SQ" && header.vr != "OB" && header.vr != "OW")
                return doubt();
            return push(kUndefined, unknown ? Encoding{false, false} : encoding, false);
        }
        if (header.length > 0 && isSequence(header)) return push(header.length, encoding, false);
        if (source_.inflating() && source_.position() + header.length > inflatedLimit())
            return inflatesTooFar();
        return levels_.empty() ? readOrSkip(header) : source_.skip(header.length);
    }

    bool isSequence(const Header& header) {
        if (!header.vr.empty()) return header.vr == "SQ";
        if (header.group % 2 == 0) return DcmTag(header.group, header.element).getEVR() == EVR_SQ;
        // Private, which DCMTK may know by its creator: whatever begins like an item.
        std::array<unsigned char, 4> head{};
        return header.length >= 8 && source_.peek(head) && word(head.data(), false) == 0xFFFE &&
               word(head.data() + 2, false) == 0xE000;
    }

    bool push(std::uint32_t length, const Encoding& encoding, bool ofFragments) {
        if (++depth_ > kDeepest) {
            outline_.nestedTooDeep = true;
            return false;
        }
        levels_.push_back(
            {.isSequence = true, .ofFragments = ofFragments, .end = endOf(length), .encoding = encoding});
        return true;
    }

    void pop() {
        if (levels_.back().isSequence) --depth_;
        levels_.pop_back();
    }

    std::uint64_t endOf(std::uint32_t length) const {
        return length == kUndefined ? kNoEnd : source_.position() + length;
    }

    // What tells how large an inflated file may be.
    bool readOrSkip(const Header& header) {
        if (!source_.inflating() || header.group != 0x0028 || header.length == 0 || header.length > 12)
            return source_.skip(header.length);
        std::string value(header.length, '\0');
        if (!readText(value)) return false;
        const auto* bytes = reinterpret_cast<const unsigned char*>(value.data());
        if (header.is(tag::kNumberOfFrames)) {
            const std::size_t first = std::min(value.find_first_not_of(' '), value.size());
            std::from_chars(value.data() + first, value.data() + value.size(), frames_);
        } else if (header.length == 2) {
            const std::uint64_t number = word(bytes, encoding_.bigEndian);
            if (header.is(tag::kRows)) rows_ = number;
            if (header.is(tag::kColumns)) columns_ = number;
            if (header.is(tag::kSamplesPerPixel)) samples_ = number;
            if (header.is(tag::kBitsAllocated)) bits_ = number;
        }
        return true;
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

    void notePixelEnd() {
        pixelsJustEnded_ = false;
        if (source_.inflating() || source_.position() > source_.fileBytes()) return;
        const std::uint64_t tail = source_.fileBytes() - source_.position();
        outline_.strayBytesAfterPixels = tail > 0 && tail < 8;
    }

    // Where this walk and DCMTK might disagree about what comes next, depth is bounded by the number of items
    // that can be there at all.
    void countItems() {
        std::size_t items = 0;
        std::uint32_t last = 0;
        std::array<unsigned char, 1> byte{};
        while (source_.read(byte)) {
            last = last << 8 | byte[0];
            if (last == 0xFEFF00E0 || last == 0xFFFEE000) ++items;
            if (items > kMostItemsInDoubt || (source_.inflating() && source_.position() > kMostInflated)) {
                outline_.nestedTooDeep = true;
                return;
            }
        }
    }

    ByteSource source_;
    Outline outline_;
    Encoding encoding_;
    std::string transferSyntaxUid_;
    std::optional<std::uint64_t> groupEnd_;
    std::vector<Level> levels_;
    std::size_t depth_ = 0;
    bool doubtful_ = false;
    bool pixelsJustEnded_ = false;
    std::uint64_t rows_ = 0, columns_ = 0, samples_ = 1, bits_ = 16, frames_ = 1;
};

}  // namespace

Outline outlineOf(const std::filesystem::path& file, bool hasPreamble) {
    return Walk(file).run(hasPreamble);
}

}  // namespace macula::dicom
