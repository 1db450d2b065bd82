// Datasets of storage commitment, byte by byte.
#include "net/dimse/commitment_dataset.h"

#include <gtest/gtest.h>

#include "net/dimse/elements.h"
#include "net/hostile_peer.h"

namespace macula::net::test {

namespace {

constexpr const char* kExplicit = "1.2.840.10008.1.2.1";
constexpr const char* kImplicit = "1.2.840.10008.1.2";

Bytes littleBytes(std::size_t value, int count) {
    Bytes bytes;
    for (int i = 0; i < count; ++i) bytes.push_back(static_cast<unsigned char>(value >> (8 * i)));
    return bytes;
}

// An item, or a sequence, of a known or an undefined length.
Bytes itemOf(const Bytes& content, bool hasLength) {
    const Bytes end{0xfe, 0xff, 0x0d, 0xe0, 0, 0, 0, 0};
    return joined({{0xfe, 0xff, 0x00, 0xe0},
                   littleBytes(hasLength ? content.size() : 0xffffffffu, 4),
                   content,
                   hasLength ? Bytes{} : end});
}
Bytes sequenceOf(unsigned char element, const std::vector<Bytes>& items, bool hasLength) {
    const Bytes content = joined(items);
    const Bytes end{0xfe, 0xff, 0xdd, 0xe0, 0, 0, 0, 0};
    return joined({{0x08, 0x00, element, 0x11, 'S', 'Q', 0, 0},
                   littleBytes(hasLength ? content.size() : 0xffffffffu, 4),
                   content,
                   hasLength ? Bytes{} : end});
}
Bytes instance(const std::string& uid, std::optional<unsigned char> reason = {}) {
    Bytes content =
        joined({explicitElement(0x00081150, "UI", "1.2.3"), explicitElement(0x00081155, "UI", uid)});
    if (reason) content = joined({content, explicitElement(0x00081197, "US", std::string{char(*reason), 1})});
    return content;
}
Bytes report(bool hasLength) {
    return joined(
        {explicitElement(0x00081195, "UI", "2.25.7"),
         sequenceOf(0x98, {itemOf(instance("2.25.3", 0x12), hasLength)}, hasLength),
         sequenceOf(0x99, {itemOf(instance("2.25.1"), hasLength), itemOf(instance("2.25.2"), hasLength)},
                    hasLength)});
}

TEST(CommitmentDataset, AReportIsReadWithAndWithoutLengths) {
    for (const bool hasLength : {true, false}) {
        const auto read = commitmentReportOf(report(hasLength), kExplicit);
        ASSERT_TRUE(read) << hasLength;
        EXPECT_EQ(read->transactionUid, "2.25.7");
        EXPECT_EQ(read->committed, (std::set<std::string>{"2.25.1", "2.25.2"}));
        EXPECT_EQ(read->refused, (std::map<std::string, std::uint16_t>{{"2.25.3", 0x0112}}));
    }
}

TEST(CommitmentDataset, ARequestHoldsEachInstance) {
    const std::vector<ReferencedInstance> instances{{"1.2.3", "2.25.1"}, {"1.2.3", "2.25.22"}};
    for (const char* syntax : {kExplicit, kImplicit}) {
        const auto bytes = commitmentRequestBytes("2.25.7", instances, syntax);
        EXPECT_EQ(bytes.size() % 2, 0u);
        const auto read = commitmentReportOf(bytes, syntax);  // its sequence is that of a report
        ASSERT_TRUE(read) << syntax;
        EXPECT_EQ(read->transactionUid, "2.25.7");
        EXPECT_EQ(read->committed, (std::set<std::string>{"2.25.1", "2.25.22"}));
    }
    EXPECT_EQ(commitmentRequestBytes("2.25.7", {}, kExplicit),
              joined({explicitElement(0x00081195, "UI", "2.25.7"), sequenceOf(0x99, {}, true)}));
}

TEST(CommitmentDataset, EveryBeginningOfAReportIsHarmless) {
    for (const bool hasLength : {true, false}) {
        const Bytes whole = report(hasLength);
        for (std::size_t count = 0; count < whole.size(); ++count) {
            const auto read = commitmentReportOf(std::span(whole).first(count), kExplicit);
            EXPECT_TRUE(!read || read->committed.size() + read->refused.size() < 3) << count;
        }
    }
}

TEST(CommitmentDataset, WhatContradictsItselfIsNotCommitted) {
    const Bytes both = joined({explicitElement(0x00081195, "UI", "2.25.7"),
                               sequenceOf(0x98, {itemOf(instance("2.25.1", 0x10), true)}, true),
                               sequenceOf(0x99, {itemOf(instance("2.25.1"), true)}, true)});
    const auto read = commitmentReportOf(both, kExplicit);
    ASSERT_TRUE(read);
    EXPECT_TRUE(read->committed.empty());
    EXPECT_TRUE(read->refused.contains("2.25.1"));
}

TEST(CommitmentDataset, LengthsAndDepthsAreNotTrusted) {
    const Bytes transaction = explicitElement(0x00081195, "UI", "2.25.7");
    // An item that reaches beyond its sequence, an end without a beginning, an item outside of a sequence.
    Bytes beyond = sequenceOf(0x99, {itemOf(instance("2.25.1"), true)}, true);
    beyond[8] = static_cast<unsigned char>(beyond[8] - 2);
    EXPECT_FALSE(commitmentReportOf(joined({transaction, beyond}), kExplicit));
    EXPECT_FALSE(commitmentReportOf(joined({transaction, {0xfe, 0xff, 0xdd, 0xe0, 0, 0, 0, 0}}), kExplicit));
    EXPECT_FALSE(commitmentReportOf(joined({transaction, itemOf({}, true)}), kExplicit));
    std::vector<Bytes> levels(10000, Bytes{0x08, 0,    0x99, 0x11, 'S',  'Q',  0,    0,    0xff, 0xff,
                                           0xff, 0xff, 0xfe, 0xff, 0x00, 0xe0, 0xff, 0xff, 0xff, 0xff});
    levels.insert(levels.begin(), transaction);
    EXPECT_FALSE(commitmentReportOf(joined(levels), kExplicit));
    EXPECT_FALSE(commitmentReportOf(sequenceOf(0x99, {}, true), kExplicit)) << "of no transaction";
    EXPECT_FALSE(commitmentReportOf(report(true), "1.2.840.10008.1.2.1.99")) << "deflated";
}

}  // namespace

}  // namespace macula::net::test
