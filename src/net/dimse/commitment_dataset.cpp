#include "net/dimse/commitment_dataset.h"

#include <utility>

#include "net/archive/file_meta.h"
#include "net/dimse/contexts.h"
#include "net/dimse/elements.h"

namespace macula::net {

namespace {

constexpr std::uint32_t kReferencedClass = 0x00081150;
constexpr std::uint32_t kReferencedInstance = 0x00081155;
constexpr std::uint32_t kTransaction = 0x00081195;
constexpr std::uint32_t kFailureReason = 0x00081197;
constexpr std::uint32_t kFailed = 0x00081198;
constexpr std::uint32_t kReferenced = 0x00081199;
constexpr std::uint32_t kItem = 0xfffee000;

class DatasetWriter {
  public:
    explicit DatasetWriter(bool isExplicit) : isExplicit_(isExplicit) {}

    void uid(std::uint32_t tag, std::string value) {
        if (value.size() % 2 != 0) value += '\0';
        putTag(tag);
        if (isExplicit_) {
            putText("UI");
            little(value.size(), 2);
        } else {
            little(value.size(), 4);
        }
        putText(value);
    }
    void sequence(std::uint32_t tag, const std::vector<std::vector<unsigned char>>& items) {
        std::size_t length = 0;
        for (const auto& item : items) length += 8 + item.size();
        putTag(tag);
        if (isExplicit_) {
            putText("SQ");
            little(0, 2);
        }
        little(length, 4);
        for (const auto& item : items) {
            putTag(kItem);
            little(item.size(), 4);
            bytes_.insert(bytes_.end(), item.begin(), item.end());
        }
    }
    std::vector<unsigned char> take() { return std::move(bytes_); }

  private:
    void putTag(std::uint32_t tag) {
        little(tag >> 16, 2);
        little(tag & 0xffffu, 2);
    }
    void putText(std::string_view text) { bytes_.insert(bytes_.end(), text.begin(), text.end()); }
    void little(std::size_t value, int count) {
        for (int i = 0; i < count; ++i) bytes_.push_back(static_cast<unsigned char>(value >> (8 * i)));
    }

    bool isExplicit_;
    std::vector<unsigned char> bytes_;
};

// What an item says, gathered from its elements.
struct ReportItem {
    std::string sopInstanceUid;
    std::uint16_t reason = 0;
};

}  // namespace

std::vector<unsigned char> commitmentRequestBytes(const std::string& transactionUid,
                                                  std::span<const ReferencedInstance> instances,
                                                  std::string_view transferSyntax) {
    const bool isExplicit = transferSyntax != kImplicitLittleEndian;
    std::vector<std::vector<unsigned char>> items;
    for (const ReferencedInstance& instance : instances) {
        DatasetWriter item(isExplicit);
        item.uid(kReferencedClass, instance.sopClassUid);
        item.uid(kReferencedInstance, instance.sopInstanceUid);
        items.push_back(item.take());
    }
    DatasetWriter dataset(isExplicit);
    dataset.uid(kTransaction, transactionUid);
    dataset.sequence(kReferenced, items);
    return dataset.take();
}

std::optional<CommitmentReport> commitmentReportOf(std::span<const unsigned char> bytes,
                                                   std::string_view transferSyntax) {
    Encoding encoding{};
    if (!encodingOf(transferSyntax, encoding)) return {};
    CommitmentReport report;
    forEachElement(bytes, encoding, [&](const Element& element) {
        if (element.tag == kTransaction) report.transactionUid = textOf(element);
        return element.tag < kTransaction;
    });
    if (!isUid(report.transactionUid)) return {};
    constexpr std::uint32_t kSequences[] = {kFailed, kReferenced};
    std::map<std::pair<std::uint32_t, std::size_t>, ReportItem> items;
    const bool isWhole = forEachItemElement(bytes, encoding, kSequences, [&](const ItemElement& each) {
        ReportItem& item = items[{each.sequence, each.item}];
        const std::span<const unsigned char> value = each.element.value;
        const bool isBig = encoding == Encoding::explicitBig;
        if (each.element.tag == kReferencedInstance) item.sopInstanceUid = textOf(each.element);
        if (each.element.tag == kFailureReason && value.size() == 2)
            item.reason =
                static_cast<std::uint16_t>(isBig ? value[0] << 8 | value[1] : value[1] << 8 | value[0]);
        return true;
    });
    if (!isWhole) return {};
    for (const auto& [place, item] : items) {
        if (!isUid(item.sopInstanceUid)) continue;
        if (place.first == kFailed)
            report.refused[item.sopInstanceUid] = item.reason;
        else
            report.committed.insert(item.sopInstanceUid);
    }
    // Of an instance that stands in both, the archive has not made up its mind.
    for (const auto& [uid, reason] : report.refused) report.committed.erase(uid);
    return report;
}

}  // namespace macula::net
