#include "net/dimse/elements.h"

#include <algorithm>
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

    std::size_t at() const { return at_; }
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

namespace {

// A sequence or an item that is open.
struct OpenPart {
    bool isSequence = false;
    std::uint32_t tag = 0;
    std::size_t end = 0;  // where it is said to end; without a length, where what it is in ends
    bool hasLength = false;
    Encoding encoding{};
};

// Walks through items: a stack instead of recursion, and nothing reaches beyond what it is in.
class ItemWalk {
  public:
    ItemWalk(std::span<const unsigned char> bytes, Encoding encoding,
             std::span<const std::uint32_t> sequences, const std::function<bool(const ItemElement&)>& take)
        : reader_(bytes), size_(bytes.size()), encoding_(encoding), sequences_(sequences), take_(take) {}

    bool run() {
        while (true) {
            while (!open_.empty() && open_.back().hasLength && reader_.at() == open_.back().end)
                open_.pop_back();
            if (reader_.isAtEnd()) return open_.empty();
            const std::optional<ElementHead> head = headAt(reader_, encodingHere());
            if (!head || reader_.at() > endHere()) return false;
            if (!step(*head)) return false;
            if (isOver_) return true;
        }
    }

  private:
    Encoding encodingHere() const { return open_.empty() ? encoding_ : open_.back().encoding; }
    std::size_t endHere() const { return open_.empty() ? size_ : open_.back().end; }

    bool step(const ElementHead& head) {
        if (head.tag == kItemEnd || head.tag == kSequenceEnd) {
            const bool fits = !open_.empty() && !open_.back().hasLength &&
                              open_.back().isSequence == (head.tag == kSequenceEnd);
            if (fits) open_.pop_back();
            return fits;
        }
        const bool isInSequence = !open_.empty() && open_.back().isSequence;
        if (isInSequence != (head.tag == kItem)) return false;
        if (open_.empty())
            isOfWanted_ = std::find(sequences_.begin(), sequences_.end(), head.tag) != sequences_.end();
        const bool isWanted = open_.empty() && isOfWanted_;
        if (isInSequence || isWanted || head.length == kUndefined) return begin(head, !isInSequence);
        if (head.length > endHere() - reader_.at()) return false;
        const Element element{head.tag, reader_.value(head.length)};
        if (open_.size() == 2 && isOfWanted_) isOver_ = !take_({open_.front().tag, item_, element});
        return true;
    }

    bool begin(const ElementHead& head, bool isSequence) {
        const bool hasLength = head.length != kUndefined;
        if (open_.size() == kDeepest || (hasLength && head.length > endHere() - reader_.at())) return false;
        if (open_.empty()) items_ = 0;
        if (open_.size() == 1) item_ = items_++;
        const Encoding here = head.isUnknown ? Encoding::implicitLittle : encodingHere();
        open_.push_back(
            {isSequence, head.tag, hasLength ? reader_.at() + head.length : endHere(), hasLength, here});
        return true;
    }

    ElementReader reader_;
    const std::size_t size_;
    const Encoding encoding_;
    const std::span<const std::uint32_t> sequences_;
    const std::function<bool(const ItemElement&)>& take_;
    std::vector<OpenPart> open_;
    bool isOfWanted_ = false;  // the outermost sequence that is open
    std::size_t items_ = 0;    // of it, so far
    std::size_t item_ = 0;
    bool isOver_ = false;
};

}  // namespace

bool forEachItemElement(std::span<const unsigned char> bytes, Encoding encoding,
                        std::span<const std::uint32_t> sequences,
                        const std::function<bool(const ItemElement&)>& take) {
    return ItemWalk(bytes, encoding, sequences, take).run();
}

std::string textOf(const Element& element) {
    std::string text(element.value.begin(), element.value.end());
    while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.pop_back();
    text.erase(0, text.find_first_not_of(' '));
    return text;
}

}  // namespace macula::net
