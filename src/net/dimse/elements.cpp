#include "net/dimse/elements.h"

#include <optional>
#include <vector>

namespace macula::net {

namespace {

constexpr std::uint32_t kUndefined = 0xffffffffu;
constexpr std::uint32_t kItem = 0xfffee000u;
constexpr std::uint32_t kItemEnd = 0xfffee00du;
constexpr std::uint32_t kSequenceEnd = 0xfffee0ddu;
constexpr std::size_t kDeepest = 64;

class ElementReader {
  public:
    explicit ElementReader(std::span<const unsigned char> bytes) : bytes_(bytes) {}

    bool isAtEnd() const { return at_ == bytes_.size(); }
    bool has(std::size_t count) const { return bytes_.size() - at_ >= count; }
    std::uint32_t number(std::size_t count, bool isBig) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < count; ++i)
            value |= std::uint32_t{bytes_[at_ + i]} << (8 * (isBig ? count - 1 - i : i));
        at_ += count;
        return value;
    }
    std::string_view representation() {
        at_ += 2;
        return {reinterpret_cast<const char*>(bytes_.data()) + at_ - 2, 2};
    }
    std::span<const unsigned char> value(std::size_t count) {
        at_ += count;
        return bytes_.subspan(at_ - count, count);
    }

  private:
    std::span<const unsigned char> bytes_;
    std::size_t at_ = 0;
};

struct ElementHead {
    std::uint32_t tag = 0;
    std::uint32_t length = 0;
    bool isUnknown = false;  // UN: what is in it is implicit
};

bool hasLongLength(std::string_view representation) {
    for (const char* each : {"OB", "OD", "OF", "OL", "OV", "OW", "SQ", "SV", "UC", "UN", "UR", "UT", "UV"})
        if (representation == each) return true;
    return false;
}

std::optional<ElementHead> headAt(ElementReader& reader, Encoding encoding) {
    const bool isBig = encoding == Encoding::explicitBig;
    if (!reader.has(8)) return {};
    ElementHead head;
    const std::uint32_t group = reader.number(2, isBig);
    head.tag = group << 16 | reader.number(2, isBig);
    if (encoding == Encoding::implicitLittle || group == 0xfffe) {
        head.length = reader.number(4, isBig);
        return head;
    }
    const std::string_view representation = reader.representation();
    head.isUnknown = representation == "UN";
    if (!hasLongLength(representation)) {
        head.length = reader.number(2, isBig);
        return head;
    }
    reader.number(2, isBig);
    if (!reader.has(4)) return {};
    head.length = reader.number(4, isBig);
    return head;
}

}  // namespace

bool encodingOf(std::string_view transferSyntax, Encoding& encoding) {
    if (transferSyntax == "1.2.840.10008.1.2.1.99") return false;
    encoding = Encoding::explicitLittle;
    if (transferSyntax == "1.2.840.10008.1.2") encoding = Encoding::implicitLittle;
    if (transferSyntax == "1.2.840.10008.1.2.2") encoding = Encoding::explicitBig;
    return true;
}

bool forEachElement(std::span<const unsigned char> bytes, Encoding encoding,
                    const std::function<bool(const Element&)>& take) {
    ElementReader reader(bytes);
    // How what is in a sequence or item of undefined length is written; those of a known length are skipped.
    std::vector<Encoding> open;
    while (!reader.isAtEnd()) {
        const Encoding here = open.empty() ? encoding : open.back();
        const std::optional<ElementHead> head = headAt(reader, here);
        if (!head) return false;
        if (head->tag == kItemEnd || head->tag == kSequenceEnd) {
            if (open.empty()) return false;
            open.pop_back();
            continue;
        }
        if (head->length == kUndefined) {
            if (open.size() == kDeepest) return false;
            open.push_back(head->isUnknown ? Encoding::implicitLittle : here);
            continue;
        }
        if (!reader.has(head->length)) return false;
        const Element element{head->tag, reader.value(head->length)};
        if (open.empty() && head->tag != kItem && !take(element)) return true;
    }
    return open.empty();
}

std::string textOf(const Element& element) {
    std::string text(element.value.begin(), element.value.end());
    while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.pop_back();
    text.erase(0, text.find_first_not_of(' '));
    return text;
}

}  // namespace macula::net
