#include "dicom/read/dataset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>

#include "base/check.h"
#include "base/log.h"
#include "base/printable.h"
#include "base/utf8.h"
#include "dicom/read/element_tree.h"
#include "dicom/read/outline.h"
#include "dicom/read/values.h"
#include "toolkit/character_set.h"
#include "toolkit/quiet_toolkit.h"

namespace macula::dicom {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kPreambleBytes = 128;

enum class Sniff { part10, bareDataset, notDicom };

// A file without preamble counts as DICOM only if its first element is one that a dataset can begin with:
// group 2 or 8, a small element number, and a plausible VR (explicit) or length (implicit). PS3.5 7.1.
Sniff sniff(ByteSource& source) {
    const auto head = source.ahead(kPreambleBytes + 4);
    constexpr std::array<unsigned char, 4> kMagic{'D', 'I', 'C', 'M'};
    if (head.size() == kPreambleBytes + 4 &&
        std::equal(kMagic.begin(), kMagic.end(), head.begin() + kPreambleBytes))
        return Sniff::part10;
    if (head.size() < 16) return Sniff::notDicom;

    const auto isUpper = [&](std::size_t i) { return head[i] >= 'A' && head[i] <= 'Z'; };
    const bool explicitVr = isUpper(4) && isUpper(5);
    const unsigned group = head[0] | head[1] << 8;
    const unsigned element = head[2] | head[3] << 8;
    if ((group == 0x0002 || group == 0x0008) && element < 0x0100) {
        const unsigned length = head[4] | head[5] << 8 | head[6] << 16 | unsigned{head[7]} << 24;
        if (explicitVr || length < 4096) return Sniff::bareDataset;
    }
    const bool bigEndian = head[0] == 0 && (head[1] == 2 || head[1] == 8) && head[2] == 0;
    return bigEndian && explicitVr ? Sniff::bareDataset : Sniff::notDicom;
}

}  // namespace

struct Dataset::File {
    using ItemNumber = ElementTree::ItemNumber;

    ElementTree tree;
    std::string transferSyntaxUid;
    std::vector<ItemNumber> ofAllFrames;  // searched for elements that a frame does not have itself
    const Element* perFrame = nullptr;

    void prepareFrames() {
        const Element* shared = tree.find(tree.root(), tag::kSharedFunctionalGroups);
        if (shared != nullptr && shared->isSequence && shared->length > 0)
            addWithMacros(shared->first, ofAllFrames);
        ofAllFrames.push_back(tree.root());
        perFrame = tree.find(tree.root(), tag::kPerFrameFunctionalGroups);
        if (perFrame != nullptr && !perFrame->isSequence) perFrame = nullptr;
    }

    void addWithMacros(ItemNumber item, std::vector<ItemNumber>& chain) const {
        constexpr std::size_t kMostMacros = 64;  // PS3.3 knows a third as many
        std::size_t macros = 0;
        for (const Element& macro : tree.elements(item)) {
            // The owner of a private sequence defines its content (PS3.5 7.8), which says nothing about the
            // frame (PS3.3 C.7.6.16). Those of Philips (2005,140F) and Siemens (group 0021) hold standard
            // attributes of their own, positions and rescale too, that need not be those of the frame.
            if (!macro.isSequence || macro.length == 0 || macro.tag.isPrivate()) continue;
            if (++macros > kMostMacros) break;
            chain.push_back(macro.first);
        }
        chain.push_back(item);
    }

    // Items may have a character set of their own, PS3.5 7.5.3.
    std::string_view characterSet(ItemNumber item) const {
        for (; item != ElementTree::kNone; item = tree.parent(item)) {
            const Element* element = tree.find(item, tag::kSpecificCharacterSet);
            if (element == nullptr) continue;
            if (const auto value = trimmed(tree.value(*element)); !value.empty()) return value;
        }
        return {};
    }

    Vr vrOf(const Element& element, ItemNumber item) const {
        Vr vr = element.vr;
        if (vr == 0 || vr == dicom::vrOf("UN")) {
            std::string_view creator;
            if (element.tag.isPrivate() && element.tag.element >= 0x1000) {
                const Tag block{element.tag.group, static_cast<std::uint16_t>(element.tag.element >> 8)};
                if (const Element* name = tree.find(item, block)) creator = trimmed(tree.value(*name));
            }
            vr = dictionaryVr(element.tag, creator);
        }
        if (vr != kVrUnsignedOrSigned) return vr;
        const Element* sign = tree.find(tree.root(), tag::kPixelRepresentation);
        const auto words = sign == nullptr
                               ? std::vector<std::uint16_t>()
                               : binaryWords(dicom::vrOf("US"), tree.value(*sign), sign->bigEndian);
        return words == std::vector<std::uint16_t>{1} ? dicom::vrOf("SS") : dicom::vrOf("US");
    }

    bool isEmpty(const Element& element, ItemNumber item) const {
        if (element.length == 0) return true;
        if (!element.hasValue) return false;
        constexpr std::string_view kPadding{" \0", 2};
        if (tree.value(element).find_first_not_of(kPadding) != std::string_view::npos) return false;
        return isTextVr(vrOf(element, item));
    }
};

namespace {

Delimiters delimitersOf(Vr vr) {
    if (vr == vrOf("PN")) return Delimiters::ofPersonNames;
    const bool oneValue = vr == vrOf("LT") || vr == vrOf("ST") || vr == vrOf("UT");
    return oneValue ? Delimiters::none : Delimiters::betweenValues;
}

}  // namespace

struct Dataset::Hit {
    const Element* element = nullptr;
    std::uint32_t item = 0;
    std::string_view bytes;
    Vr vr = 0;

    explicit operator bool() const { return element != nullptr; }
    bool isText() const {
        const auto isControl = [](char c) {
            return c >= 0 && c < ' ' && c != '\r' && c != '\n' && c != '\t';
        };
        // An unknown private element is text when its value looks like text.
        if (vr == 0) {
            const auto text = trimmed(bytes);
            return std::none_of(text.begin(), text.end(), isControl);
        }
        return isTextVr(vr);
    }
};

Dataset::Dataset(std::shared_ptr<const File> file, std::vector<std::uint32_t> items)
    : file_(std::move(file)), items_(std::move(items)) {}

Dataset::Hit Dataset::find(Tag tag) const {
    for (const std::uint32_t item : items_) {
        const Element* element = file_->tree.find(item, tag);
        if (element == nullptr || file_->isEmpty(*element, item)) continue;
        return {element, item, file_->tree.value(*element), file_->vrOf(*element, item)};
    }
    return {};
}

const std::string& Dataset::transferSyntaxUid() const {
    return file_->transferSyntaxUid;
}

bool Dataset::has(Tag tag) const {
    return static_cast<bool>(find(tag));
}

std::optional<std::string> Dataset::text(Tag tag) const {
    const Hit hit = find(tag);
    if (!hit || hit.bytes.empty()) return {};
    const std::string whole =
        hit.isText()
            ? decodeText(trimmed(hit.bytes), file_->characterSet(hit.item), delimitersOf(hit.vr)).utf8
            : textOfBinary(hit.vr, hit.bytes, hit.element->bigEndian);
    const std::string_view value = trimmed(whole);
    if (value.empty()) return {};
    return unmixed(value);
}

std::vector<std::string> Dataset::texts(Tag tag) const {
    const auto whole = text(tag);
    if (!whole) return {};
    const auto parts = splitAtBackslash(*whole);
    return {parts.begin(), parts.end()};
}

bool Dataset::charsetFallback() const {
    constexpr auto isOther = [](char c) { return static_cast<unsigned char>(c) >= 0x80 || c == '\x1B'; };
    for (const std::uint32_t item : items_) {
        for (const Element& element : file_->tree.elements(item)) {
            const std::string_view bytes = trimmed(file_->tree.value(element));
            if (std::none_of(bytes.begin(), bytes.end(), isOther)) continue;
            const Vr vr = file_->vrOf(element, item);
            if (isTextVr(vr) && decodeText(bytes, file_->characterSet(item), delimitersOf(vr)).fallback)
                return true;
        }
    }
    return false;
}

std::vector<double> Dataset::allNumbers(Tag tag) const {
    const Hit hit = find(tag);
    if (!hit || hit.bytes.empty()) return {};
    std::vector<double> values;
    if (hit.isText()) {
        for (const std::string_view part : splitAtBackslash(trimmed(hit.bytes))) {
            const auto value = finiteNumber(part);
            if (!value) return {};
            values.push_back(*value);
        }
        return values;
    }
    values = binaryNumbers(hit.vr, hit.bytes, hit.element->bigEndian);
    if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); })) return {};
    return values;
}

std::optional<std::vector<double>> Dataset::numbers(Tag tag, std::size_t count) const {
    constexpr std::size_t kMostOfANumber = 64;  // bytes; DS needs 17, with the backslash
    if (find(tag).bytes.size() > (count + 1) * kMostOfANumber) return {};
    auto values = allNumbers(tag);
    if (values.size() != count) return {};
    return values;
}

constexpr std::size_t kShortBytes = 64;
constexpr std::size_t kLongestShortValue = 4096;

std::string Dataset::shortText(Tag tag) const {
    if (find(tag).bytes.size() > kLongestShortValue) return {};
    std::string value = text(tag).value_or("");
    if (value.size() > kShortBytes)
        value = std::string(startOf(value, kShortBytes));  // a copy, which holds no more memory
    return value;
}

std::vector<std::string> Dataset::shortTexts(Tag tag) const {
    if (find(tag).bytes.size() > kLongestShortValue) return {};
    constexpr std::size_t kMostValues = 16;
    std::vector<std::string> values = texts(tag);
    if (values.size() > kMostValues) values.resize(kMostValues);
    for (std::string& value : values) value = std::string(startOf(value, kShortBytes));
    return {values.begin(), values.end()};
}

std::vector<double> Dataset::shortNumbers(Tag tag) const {
    if (find(tag).bytes.size() > kLongestShortValue) return {};
    return allNumbers(tag);
}

std::optional<double> Dataset::number(Tag tag) const {
    const auto values = numbers(tag, 1);
    if (!values) return {};
    return values->front();
}

std::optional<int> Dataset::integer(Tag tag) const {
    const auto value = number(tag);
    if (!value || *value != std::round(*value) || std::abs(*value) > 2147483647.0) return {};
    return static_cast<int>(*value);
}

std::vector<std::uint16_t> Dataset::words(Tag tag) const {
    const Hit hit = find(tag);
    if (!hit) return {};
    return binaryWords(hit.vr, hit.bytes, hit.element->bigEndian);
}

std::optional<std::uint16_t> Dataset::word(Tag tag) const {
    const auto all = words(tag);
    if (!all.empty()) return all.front();
    const auto other = integer(tag);  // the number in another VR, or as text
    if (!other || *other < std::numeric_limits<std::int16_t>::min() ||
        *other > std::numeric_limits<std::uint16_t>::max())
        return {};
    return static_cast<std::uint16_t>(*other);
}

std::uint32_t Dataset::offset() const {
    return file_->tree.offset(items_.front());
}

std::vector<Dataset> Dataset::items(Tag sequence) const {
    const Hit hit = find(sequence);
    if (!hit || !hit.element->isSequence) return {};
    std::vector<Dataset> all;
    all.reserve(hit.element->length);
    for (std::uint32_t i = 0; i < hit.element->length; ++i) all.push_back({file_, {hit.element->first + i}});
    return all;
}

std::size_t Dataset::itemCount(Tag sequence) const {
    const Hit hit = find(sequence);
    return hit && hit.element->isSequence ? hit.element->length : 0;
}

std::vector<Tag> Dataset::contradicted(std::span<const Tag> tags) const {
    std::vector<Tag> found;
    const auto isSame = [&](const Element& a, const Element& b, std::uint32_t item) {
        if (a.isSequence || b.isSequence) return false;
        const std::string_view one = file_->tree.value(a);
        const std::string_view other = file_->tree.value(b);
        if (trimmed(one) == trimmed(other) && a.hasValue == b.hasValue) return a.hasValue || a.length == 0;
        const auto number = [&](const Element& element, std::string_view value) {
            const Vr vr = file_->vrOf(element, item);
            return isTextVr(vr) ? finiteNumber(value) : std::optional<double>();
        };
        const auto ofOne = number(a, one);
        return ofOne && ofOne == number(b, other);
    };
    for (const std::uint32_t item : items_) {
        for (const Element* again : file_->tree.repeated(item)) {
            const Tag tag = again->tag;
            if (std::ranges::find(tags, tag) == tags.end() || std::ranges::find(found, tag) != found.end())
                continue;
            if (!isSame(*file_->tree.find(item, tag), *again, item)) found.push_back(tag);
        }
    }
    return found;
}

int Dataset::frameCount() const {
    return std::max(1, integer(tag::kNumberOfFrames).value_or(1));
}

Dataset Dataset::frame(int i) const {
    std::vector<std::uint32_t> chain;
    const Element* perFrame = file_->perFrame;
    if (i >= 0 && perFrame != nullptr && static_cast<std::uint32_t>(i) < perFrame->length)
        file_->addWithMacros(perFrame->first + static_cast<std::uint32_t>(i), chain);
    chain.insert(chain.end(), file_->ofAllFrames.begin(), file_->ofAllFrames.end());
    return {file_, std::move(chain)};
}

bool hasPreamble(ByteSource& source) {
    return sniff(source) == Sniff::part10;
}

FileState stateOfFailure(int error) {
    switch (error) {
        case ENODATA:  // the content is in no cache
        case EREMOTEIO:
        case ENXIO:
        case ESTALE:
        case ETIMEDOUT:
        case EHOSTDOWN:
            return FileState::offline;
        case EIO:
            return FileState::mediumError;
        case ENAMETOOLONG:
            return FileState::pathTooLong;
        default:
            return FileState::unreadable;
    }
}

HeaderFile readHeader(const fs::path& file, const CancelToken& cancel) try {
    const QuietToolkit quiet;  // the data dictionary is the toolkit's
    ByteSource source(file, cancel);
    const Sniff kind = sniff(source);
    if (source.error() == ENOMEM) throw std::bad_alloc();
    if (source.error() != 0) return {stateOfFailure(source.error()), {}};
    if (kind == Sniff::notDicom) return {FileState::notDicom, {}};

    auto content = std::make_shared<Dataset::File>();
    Outline outline = outlineOf(source, kind == Sniff::part10, &content->tree);
    if (source.error() == ENOMEM) throw std::bad_alloc();
    if (source.error() != 0) return {stateOfFailure(source.error()), {}};
    if (!outline.isPlausible()) return {FileState::damaged, {}};
    if (!outline.headerWhole) return {kind == Sniff::part10 ? FileState::damaged : FileState::notDicom, {}};
    content->transferSyntaxUid = std::move(outline.transferSyntaxUid);
    content->prepareFrames();
    const ElementTree::ItemNumber root = content->tree.root();
    const Dataset dataset(std::move(content), {root});
    // A file that only happens to begin like a dataset, with or without the magic, has none of these
    // elements.
    const bool saysWhatItIs =
        dataset.has(tag::kSopClassUid) || dataset.has(tag::kModality) || dataset.has(tag::kStudyInstanceUid);
    if (kind == Sniff::bareDataset && !saysWhatItIs) return {FileState::notDicom, {}};
    if (!saysWhatItIs && !outline.pixels && !dataset.has(tag::kDirectoryRecords))
        return {FileState::damaged, {}};
    HeaderFile read{.state = FileState::complete, .header = dataset, .strayBytes = outline.strayBytes};
    read.contradictedSyntaxUid = std::move(outline.contradictedSyntaxUid);
    if (outline.pixels) {
        const PixelDataOutline& pixels = *outline.pixels;
        if (!pixels.whole) read.state = FileState::truncated;
        read.pixels = PixelDataExtent{.tag = pixels.tag,
                                      .encapsulated = pixels.encapsulated,
                                      .offset = pixels.offset,
                                      .bytesClaimed = pixels.claimed,
                                      .bytesPresent = pixels.present,
                                      .fragments = pixels.fragments,
                                      .streams = pixels.streams,
                                      .whole = pixels.whole,
                                      .repeated = pixels.repeated};
    }
    return read;
} catch (const std::bad_alloc&) {
    throw;  // a healthy file must not pass for a damaged one
} catch (const CheckFailure&) {
    throw;  // a bug in Macula, not a fault of the file
} catch (...) {
    log::warning("reading the header of {} threw", log::Sensitive{file.native()});
    return {FileState::damaged, {}};
}

}  // namespace macula::dicom
