#include "dicom/dataset.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcspchrs.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/oflog/oflog.h>
#include <iconv.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <mutex>
#include <string_view>

#include "base/log.h"
#include "dicom/outline.h"

namespace macula::dicom {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kPreambleBytes = 128;

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kPadding{" \t\r\n\0", 5};
    const std::size_t begin = text.find_first_not_of(kPadding);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(kPadding) - begin + 1);
}

std::optional<double> parseNumber(std::string_view text) {
    text = trimmed(text);
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return {};
    return value;
}

std::vector<std::string_view> split(std::string_view text) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0;;) {
        const std::size_t end = text.find('\\', begin);
        parts.push_back(trimmed(text.substr(begin, end == std::string_view::npos ? end : end - begin)));
        if (end == std::string_view::npos) return parts;
        begin = end + 1;
    }
}

std::string utf8FromLatin1(std::string_view text) {
    std::string result;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80) {
            result += c;
        } else {
            result += static_cast<char>(0xC0 | (byte >> 6));
            result += static_cast<char>(0x80 | (byte & 0x3F));
        }
    }
    return result;
}

// Japanese in JIS X 0208, which DCMTK cannot convert with the iconv of the GNU C library: it asks for the
// bare character set, and glibc has only the encoding around it. The escape sequences are the same (PS3.5
// annex H).
std::optional<std::string> utf8FromIso2022Jp(std::string_view text) {
    const iconv_t converter = iconv_open("UTF-8", "ISO-2022-JP-2");
    if (converter == reinterpret_cast<iconv_t>(-1)) return {};
    std::string input(text);
    std::string output(4 * text.size() + 16, '\0');
    char* from = input.data();
    char* to = output.data();
    std::size_t fromLeft = input.size();
    std::size_t toLeft = output.size();
    const std::size_t failed = iconv(converter, &from, &fromLeft, &to, &toLeft);
    iconv_close(converter);
    if (failed == static_cast<std::size_t>(-1)) return {};
    output.resize(output.size() - toLeft);
    return output;
}

enum class Sniff { part10, bareDataset, notDicom, unreadable };

// A file without preamble is taken for DICOM only when its first element is one that a dataset can begin
// with: group 2 or 8, a small element number, and a plausible VR (explicit) or length (implicit). PS3.5 7.1.
Sniff sniff(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return Sniff::unreadable;
    std::array<char, kPreambleBytes + 4> head{};
    stream.read(head.data(), head.size());
    const auto count = static_cast<std::size_t>(stream.gcount());
    if (stream.bad()) return Sniff::unreadable;
    if (count == head.size() && std::string_view(head.data() + kPreambleBytes, 4) == "DICM")
        return Sniff::part10;
    if (count < 16) return Sniff::notDicom;

    const auto byte = [&](std::size_t i) {
        return static_cast<unsigned>(static_cast<unsigned char>(head[i]));
    };
    const auto isUpper = [&](std::size_t i) { return head[i] >= 'A' && head[i] <= 'Z'; };
    const bool explicitVr = isUpper(4) && isUpper(5);
    const unsigned group = byte(0) | byte(1) << 8;
    const unsigned element = byte(2) | byte(3) << 8;
    if ((group == 0x0002 || group == 0x0008) && element < 0x0100) {
        const unsigned length = byte(4) | byte(5) << 8 | byte(6) << 16 | byte(7) << 24;
        if (explicitVr || length < 4096) return Sniff::bareDataset;
    }
    const bool bigEndian = byte(0) == 0 && (byte(1) == 2 || byte(1) == 8) && byte(2) == 0;
    return bigEndian && explicitVr ? Sniff::bareDataset : Sniff::notDicom;
}

// The stop tag lies after PixelData when `past`: its value is then skipped by a seek, and DCMTK notices when
// the file is too short for it.
enum class Stop { beforePixels, afterPixels };

OFCondition load(DcmFileFormat& format, const fs::path& file, Stop stop) {
    const DcmTagKey tag = stop == Stop::beforePixels ? DcmTagKey(0x7FE0, 0x0008) : DcmTagKey(0x7FE0, 0x0011);
    constexpr Uint32 kLongestValueRead = 4096;
    return format.loadFileUntilTag(file.c_str(), EXS_Unknown, EGL_noChange, kLongestValueRead, ERM_autoDetect,
                                   tag);
}

}  // namespace

struct Dataset::Impl {
    DcmFileFormat format;
    std::string transferSyntaxUid;
    std::string characterSet;

    DcmElement* find(Tag tag) const {
        DcmElement* element = nullptr;
        // DCMTK's getters are not const, though they change nothing here.
        auto& dataset = *const_cast<DcmFileFormat&>(format).getDataset();
        if (dataset.findAndGetElement(DcmTagKey(tag.group, tag.element), element).bad()) return nullptr;
        return element;
    }

    std::string utf8(const OFString& text) const {
        const std::string_view raw(text.c_str(), text.size());
        const auto needsConversion = [](char c) {
            return static_cast<unsigned char>(c) >= 0x80 || c == '\x1B';
        };
        if (std::none_of(raw.begin(), raw.end(), needsConversion)) return std::string(raw);
        if (characterSet == "ISO_IR 192") return std::string(raw);
        DcmSpecificCharacterSet converter;
        OFString converted;
        if (!characterSet.empty() && converter.selectCharacterSet(characterSet.c_str()).good() &&
            converter.convertString(text, converted, "\\^=").good()) {
            return std::string(converted.c_str(), converted.size());
        }
        if (characterSet.find("ISO 2022 IR 87") != std::string::npos) {
            if (auto japanese = utf8FromIso2022Jp(raw)) return *japanese;
        }
        // Unknown or missing character set: legible in most of the West, and valid UTF-8.
        return utf8FromLatin1(raw);
    }
};

Dataset::Dataset(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Dataset::Dataset(Dataset&&) noexcept = default;
Dataset& Dataset::operator=(Dataset&&) noexcept = default;
Dataset::~Dataset() = default;

void silenceToolkit() {
    static std::once_flag once;
    std::call_once(once, [] { OFLog::configure(OFLogger::OFF_LOG_LEVEL); });
}

bool hasPreamble(const fs::path& file) {
    return sniff(file) == Sniff::part10;
}

HeaderFile readHeader(const fs::path& file) try {
    silenceToolkit();
    const Sniff kind = sniff(file);
    if (kind == Sniff::unreadable) return {FileState::unreadable, {}};
    if (kind == Sniff::notDicom) return {FileState::notDicom, {}};

    const Outline outline = outlineOf(file, kind == Sniff::part10);
    if (!outline.isSafeToParse()) {
        return {FileState::damaged, {}};
    }
    auto impl = std::make_unique<Dataset::Impl>();
    FileState state = FileState::complete;
    if (load(impl->format, file, Stop::afterPixels).bad() &&
        !(outline.strayBytesAfterPixels && impl->find(tag::kPixelData) != nullptr)) {
        impl = std::make_unique<Dataset::Impl>();
        if (load(impl->format, file, Stop::beforePixels).bad()) {
            return {kind == Sniff::part10 ? FileState::damaged : FileState::notDicom, {}};
        }
        state = FileState::truncated;
    }
    OFString text;
    if (impl->format.getMetaInfo()->findAndGetOFString(DCM_TransferSyntaxUID, text).good() && !text.empty()) {
        impl->transferSyntaxUid = std::string(trimmed(text.c_str()));
    } else if (const char* uid = DcmXfer(impl->format.getDataset()->getOriginalXfer()).getXferID()) {
        impl->transferSyntaxUid = uid;
    }
    if (impl->format.getDataset()->findAndGetOFStringArray(DCM_SpecificCharacterSet, text).good()) {
        impl->characterSet = text.c_str();
    }
    Dataset dataset(std::move(impl));
    // A text that happens to begin like a bare dataset still has none of these.
    if (kind == Sniff::bareDataset && !dataset.has(tag::kSopClassUid) && !dataset.has(tag::kModality) &&
        !dataset.has(tag::kStudyInstanceUid)) {
        return {FileState::notDicom, {}};
    }
    return {.state = state,
            .header = std::move(dataset),
            .nativePixelBytes = outline.nativePixelBytes,
            .strayBytes = outline.strayBytesAfterPixels};
} catch (...) {
    log::warning("reading the header of {} threw", log::Sensitive{file.native()});
    return {FileState::damaged, {}};
}

const std::string& Dataset::transferSyntaxUid() const {
    return impl_->transferSyntaxUid;
}

bool Dataset::has(Tag tag) const {
    DcmElement* element = impl_->find(tag);
    return element != nullptr && !element->isEmpty();
}

std::optional<std::string> Dataset::text(Tag tag) const {
    DcmElement* element = impl_->find(tag);
    OFString raw;
    if (element == nullptr || element->getOFStringArray(raw).bad()) return {};
    const std::string converted = impl_->utf8(raw);
    const std::string_view value = trimmed(converted);
    if (value.empty()) return {};
    return std::string(value);
}

std::vector<std::string> Dataset::texts(Tag tag) const {
    const auto whole = text(tag);
    if (!whole) return {};
    const auto parts = split(*whole);
    return {parts.begin(), parts.end()};
}

std::optional<std::vector<double>> Dataset::numbers(Tag tag, std::size_t count) const {
    const auto whole = text(tag);
    if (!whole) return {};
    const auto parts = split(*whole);
    if (parts.size() != count) return {};
    std::vector<double> values;
    for (const std::string_view part : parts) {
        const auto value = parseNumber(part);
        if (!value) return {};
        values.push_back(*value);
    }
    return values;
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

std::optional<std::uint16_t> Dataset::word(Tag tag) const {
    DcmElement* element = impl_->find(tag);
    if (element == nullptr) return {};
    Uint16 bits = 0;
    if (element->getUint16(bits).good()) return bits;
    Sint16 signedBits = 0;
    if (element->getSint16(signedBits).good()) return static_cast<std::uint16_t>(signedBits);
    return {};
}

}  // namespace macula::dicom
