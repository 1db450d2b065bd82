// The parts that need no archive: elements, commands, identifiers, contexts, and what errors say.
#include <gtest/gtest.h>

#include <fstream>

#include "dicom/support.h"
#include "net/archive/file_meta.h"
#include "net/dimse/command.h"
#include "net/dimse/contexts.h"
#include "net/dimse/elements.h"
#include "net/dimse/failures.h"
#include "net/dimse/identifier.h"
#include "net/hostile_peer.h"
#include "net/servers.h"

namespace macula::net::test {

namespace {

TEST(DimseCommand, ComesBackAsItWas) {
    const Command command{.field = CommandField::moveResponse,
                          .messageId = std::uint16_t{1},
                          .respondsTo = std::uint16_t{65535},
                          .sopClassUid = "1.2.3",
                          .sopInstanceUid = "1.2.3.4",
                          .moveDestination = "SOMEONE",
                          .priority = std::uint16_t{0},
                          .status = std::uint16_t{0xff00},
                          .remaining = std::uint16_t{4},
                          .completed = std::uint16_t{3},
                          .failed = std::uint16_t{2},
                          .withWarning = std::uint16_t{1},
                          .hasDataset = true};
    const auto bytes = bytesOf(command);
    EXPECT_EQ(bytes.size() % 2, 0u);
    const auto back = commandOf(bytes);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->field, command.field);
    EXPECT_EQ(back->messageId, command.messageId);
    EXPECT_EQ(back->respondsTo, command.respondsTo);
    EXPECT_EQ(back->sopClassUid, command.sopClassUid);
    EXPECT_EQ(back->sopInstanceUid, command.sopInstanceUid);
    EXPECT_EQ(back->moveDestination, command.moveDestination);
    EXPECT_EQ(back->status, command.status);
    EXPECT_EQ(back->remaining, command.remaining);
    EXPECT_EQ(back->completed, command.completed);
    EXPECT_EQ(back->failed, command.failed);
    EXPECT_EQ(back->withWarning, command.withWarning);
    EXPECT_TRUE(back->hasDataset);
}

TEST(DimseCommand, EveryBeginningOfOneIsHarmless) {
    const auto bytes = bytesOf({.field = CommandField::storeRequest,
                                .messageId = std::uint16_t{1},
                                .sopClassUid = "1.2.840.10008.5.1.4.1.1.2",
                                .sopInstanceUid = "1.2.3"});
    for (std::size_t count = 0; count < bytes.size(); ++count) {
        const auto begun = commandOf(std::span(bytes).first(count));
        if (begun) {
            EXPECT_EQ(begun->field, CommandField::storeRequest);
        }
    }
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        auto changed = bytes;
        changed[at] = 0xff;
        static_cast<void>(commandOf(changed));
    }
}

std::vector<std::uint32_t> tagsOf(const Bytes& bytes, Encoding encoding, bool* isWhole = nullptr) {
    std::vector<std::uint32_t> tags;
    const bool whole = forEachElement(bytes, encoding, [&](const Element& element) {
        tags.push_back(element.tag);
        return true;
    });
    if (isWhole != nullptr) *isWhole = whole;
    return tags;
}

TEST(DimseElements, SequencesAreSkipped) {
    const Bytes inner = explicitElement(0x0020000d, "UI", "1.2.3");
    const Bytes begin{0x08, 0x00, 0x40, 0x11, 'S',  'Q',  0,    0,    0xff, 0xff,
                      0xff, 0xff, 0xfe, 0xff, 0x00, 0xe0, 0xff, 0xff, 0xff, 0xff};
    const Bytes end{0xfe, 0xff, 0x0d, 0xe0, 0, 0, 0, 0, 0xfe, 0xff, 0xdd, 0xe0, 0, 0, 0, 0};
    const Bytes outer = explicitElement(0x0020000e, "UI", "1.2.4");
    bool isWhole = false;
    EXPECT_EQ(tagsOf(joined({begin, inner, end, outer}), Encoding::explicitLittle, &isWhole),
              std::vector<std::uint32_t>{0x0020000e});
    EXPECT_TRUE(isWhole);
    const Bytes item = joined({Bytes{0xfe, 0xff, 0x00, 0xe0, 14, 0, 0, 0}, inner});
    const Bytes ofKnownLength = explicitElement(0x00081140, "SQ", std::string(item.begin(), item.end()));
    EXPECT_EQ(tagsOf(joined({ofKnownLength, outer}), Encoding::explicitLittle, &isWhole),
              (std::vector<std::uint32_t>{0x00081140, 0x0020000e}));
    EXPECT_TRUE(isWhole);
    tagsOf(joined({begin, inner}), Encoding::explicitLittle, &isWhole);
    EXPECT_FALSE(isWhole) << "a sequence without an end";
    tagsOf(end, Encoding::explicitLittle, &isWhole);
    EXPECT_FALSE(isWhole) << "an end without a sequence";
}

TEST(DimseElements, BigEndianIsRead) {
    const Bytes bytes{0x00, 0x20, 0x00, 0x0d, 'U', 'I', 0x00, 0x04, '1', '.', '2', 0};
    std::string value;
    EXPECT_TRUE(forEachElement(bytes, Encoding::explicitBig, [&](const Element& element) {
        EXPECT_EQ(element.tag, 0x0020000du);
        value = textOf(element);
        return true;
    }));
    EXPECT_EQ(value, "1.2");
}

TEST(DimseIdentifier, ComesBackAsItWas) {
    const Keys keys{{Key::level, "STUDY"},
                    {Key::patientName, "Müller^Jürgen"},
                    {Key::studyDescription, "Schädel"},
                    {Key::studyInstanceUid, "1.2.3"},
                    {Key::studyDate, ""}};
    for (const std::string_view syntax : {kExplicitLittleEndian, kImplicitLittleEndian}) {
        for (const std::string characterSet : {"ISO_IR 192", "ISO_IR 100", "ISO_IR 101"}) {
            const auto bytes = identifierBytes(keys, syntax, characterSet);
            ASSERT_TRUE(bytes);
            auto back = identifierOf(*bytes, syntax);
            ASSERT_TRUE(back);
            back->erase(Key::specificCharacterSet);
            EXPECT_EQ(*back, keys) << characterSet;
        }
    }
    EXPECT_FALSE(identifierBytes(keys, kExplicitLittleEndian, "ISO_IR 144"));  // Cyrillic
    EXPECT_FALSE(identifierBytes(keys, kExplicitLittleEndian, "NO SUCH SET"));
    EXPECT_FALSE(identifierBytes({{Key::patientName, "\xff"}}, kExplicitLittleEndian, "ISO_IR 192"));
}

TEST(DimseIdentifier, JapaneseWithCodeExtensions) {
    // PS3.5 H.3.1: Yamada^Tarou in three groups of letters.
    const std::string name =
        "Yamada^Tarou=\x1b$B;3ED\x1b(B^\x1b$BB@O:\x1b(B=\x1b$B$d$^$@\x1b(B^\x1b$B$?$m$&\x1b(B";
    const Bytes bytes = joined(
        {explicitElement(0x00080005, "CS", "\\ISO 2022 IR 87"), explicitElement(0x00100010, "PN", name)});
    const auto keys = identifierOf(bytes, kExplicitLittleEndian);
    ASSERT_TRUE(keys);
    EXPECT_EQ(firstValue(*keys, Key::patientName), "Yamada^Tarou=山田^太郎=やまだ^たろう");
}

TEST(DimseIdentifier, ValuesAreNotTrusted) {
    const Keys keys{{Key::studyInstanceUid, "1.2\\1.3"},
                    {Key::sopInstanceUid, "../1.2"},
                    {Key::seriesInstanceUid, std::string(65, '1')},
                    {Key::modalitiesInStudy, "CT \\ MR\\\\PT"},
                    {Key::seriesNumber, "12abc"},
                    {Key::instanceNumber, "+7"},
                    {Key::instancesOfStudy, "99999999999999999999"}};
    EXPECT_EQ(uidValue(keys, Key::studyInstanceUid), "");
    EXPECT_EQ(uidValue(keys, Key::sopInstanceUid), "");
    EXPECT_EQ(uidValue(keys, Key::seriesInstanceUid), "");
    EXPECT_EQ(allValues(keys, Key::modalitiesInStudy), (std::vector<std::string>{"CT", "MR", "", "PT"}));
    EXPECT_FALSE(numberValue(keys, Key::seriesNumber));
    EXPECT_EQ(numberValue(keys, Key::instanceNumber), 7);
    EXPECT_FALSE(numberValue(keys, Key::instancesOfStudy));
    EXPECT_FALSE(numberValue(keys, Key::seriesOfStudy));
}

TEST(DimseContexts, NeverMoreThanAnAssociationCarries) {
    for (const std::size_t count : {0u, 1u, 3u, 9u, 40u, 127u, 200u}) {
        std::set<std::string> classes{"no UID"};
        for (std::size_t i = 0; i < count; ++i) classes.insert("1.2.3." + std::to_string(i));
        const auto contexts = contextsToReceive(classes, 126);
        EXPECT_LE(contexts.size(), 126u);
        std::map<std::string, std::set<std::string>> syntaxes;
        for (const ProposedContext& each : contexts) {
            EXPECT_TRUE(each.asProvider);
            EXPECT_FALSE(each.transferSyntaxes.empty());
            syntaxes[each.abstractSyntax].insert(each.transferSyntaxes.begin(), each.transferSyntaxes.end());
        }
        EXPECT_EQ(syntaxes.size(), std::min<std::size_t>(count, 126));
        for (const auto& [uid, offered] : syntaxes) EXPECT_EQ(offered.size(), 32u) << uid;
    }
    EXPECT_LE(contextsToReceive(usualClasses({}), 126).size(), 126u);
    EXPECT_TRUE(usualClasses({"CT"}).contains("1.2.840.10008.5.1.4.1.1.2"));
    EXPECT_FALSE(usualClasses({"CT"}).contains("1.2.840.10008.5.1.4.1.1.4"));
}

TEST(DimseFailures, EveryStatusSaysWhatToDo) {
    std::set<std::string> said;
    for (const Service service :
         {Service::echo, Service::find, Service::get, Service::move, Service::store}) {
        for (unsigned status = 1; status < 0x10000; ++status) {
            const auto code = static_cast<std::uint16_t>(status);
            if (isPending(code) || isWarning(code)) continue;
            const Error error = errorOfStatus(service, code);
            ASSERT_EQ(error.code, ErrorCode::archiveNotUsable);
            ASSERT_FALSE(error.message.empty());
            ASSERT_FALSE(error.hint.empty());
            said.insert(error.message.format());
        }
        EXPECT_FALSE(serviceNotOffered(service).hint.empty());
    }
    EXPECT_GT(said.size(), 10u);
    EXPECT_TRUE(isWarning(0xb000));
    EXPECT_TRUE(isWarning(0xb007));
    EXPECT_FALSE(isWarning(0xa700));
}

TEST(FileMetaBytes, ComesBackAsItWas) {
    const dicom::test::TemporaryFolder folder;
    const FileMeta meta{.sopClassUid = "1.2.3", .sopInstanceUid = "1.2.3.4", .transferSyntaxUid = "1.2.5"};
    const std::string bytes = fileMetaBytes(meta);
    const auto file = folder / "a.dcm";
    std::ofstream(file, std::ios::binary) << bytes << "dataset";
    const auto back = readFileMeta(file);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->sopClassUid, meta.sopClassUid);
    EXPECT_EQ(back->sopInstanceUid, meta.sopInstanceUid);
    EXPECT_EQ(back->transferSyntaxUid, meta.transferSyntaxUid);
    EXPECT_EQ(back->datasetOffset, bytes.size());
    EXPECT_EQ(datasetBytes(file), "dataset");
    for (std::size_t count = 0; count < bytes.size(); ++count) {
        std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes.substr(0, count);
        const auto cut = readFileMeta(file);
        EXPECT_FALSE(cut && cut->datasetOffset > count) << count;
    }
    EXPECT_FALSE(readFileMeta(folder / "missing.dcm"));
}

}  // namespace

}  // namespace macula::net::test
