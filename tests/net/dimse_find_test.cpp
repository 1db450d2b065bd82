// Searches, against DCMTK's archive and Orthanc.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "net/dimse_support.h"
#include "net/servers.h"

namespace macula::net::test {

namespace {

using dicom::test::TemporaryFolder;

// Two patients, one of them with two studies.
void fillForSearches(std::uint16_t port, const std::string& title) {
    const TemporaryFolder folder;
    writeStudy(folder / "a", {});
    writeStudy(folder / "b", {.studyUid = "2.25.77002",
                              .date = "20240310",
                              .description = "CHEST",
                              .seriesCount = 1,
                              .slices = 2});
    writeStudy(
        folder / "c",
        {.studyUid = "2.25.77003",
         .patientName = "M\xfcller^J\xfcrgen",
         .patientId = "P2",
         .date = "20231231",
         .modality = "MR",
         .description = "Sch\xe4"
                        "del",
         .seriesCount = 1,
         .edits = {[](DcmItem& item) { dicom::test::put(item, DCM_SpecificCharacterSet, "ISO_IR 100"); }}});
    sendFolder(folder.path(), port, title);
}

std::vector<std::string> uidsFound(Archive& archive, const StudyQuery& query) {
    Progress progress;
    const Result<StudyAnswers> answers = archive.findStudies(query, progress);
    EXPECT_TRUE(answers) << told(answers.error());
    std::vector<std::string> uids;
    if (!answers) return uids;
    EXPECT_EQ(answers->unusable, 0u);
    for (const FoundStudy& study : answers->studies) uids.push_back(study.studyInstanceUid);
    std::sort(uids.begin(), uids.end());
    return uids;
}

using Uids = std::vector<std::string>;

void expectSearches(Archive& archive) {
    EXPECT_EQ(uidsFound(archive, {}), (Uids{"2.25.77001", "2.25.77002", "2.25.77003"}));
    EXPECT_EQ(uidsFound(archive, {.patientName = "MEIER*"}), (Uids{"2.25.77001", "2.25.77002"}));
    EXPECT_EQ(uidsFound(archive, {.patientName = "NOBODY*"}), Uids{});
    EXPECT_EQ(uidsFound(archive, {.patientId = "P?"}), (Uids{"2.25.77001", "2.25.77002", "2.25.77003"}));
    EXPECT_EQ(uidsFound(archive, {.patientId = "P2"}), Uids{"2.25.77003"});
    EXPECT_EQ(uidsFound(archive, {.accessionNumber = "AP2"}), Uids{"2.25.77003"});
    EXPECT_EQ(uidsFound(archive, {.studyInstanceUid = "2.25.77002"}), Uids{"2.25.77002"});
    EXPECT_EQ(uidsFound(archive, {.dateFrom = "20240101"}), (Uids{"2.25.77001", "2.25.77002"}));
    EXPECT_EQ(uidsFound(archive, {.dateTo = "20240229"}), (Uids{"2.25.77001", "2.25.77003"}));
    EXPECT_EQ(uidsFound(archive, {.dateFrom = "20240229", .dateTo = "20240229"}), Uids{"2.25.77001"});
    EXPECT_EQ(uidsFound(archive, {.dateFrom = "20240201", .dateTo = "20240331"}),
              (Uids{"2.25.77001", "2.25.77002"}));
    EXPECT_EQ(uidsFound(archive, {.description = "CH*"}), Uids{"2.25.77002"});
}

// DCMTK's archive knows few attributes of series and instances.
void expectLevels(Archive& archive, bool saysAll) {
    Progress progress;
    const Result<std::vector<FoundSeries>> series = archive.findSeries("2.25.77001", progress);
    ASSERT_TRUE(series) << told(series.error());
    ASSERT_EQ(series->size(), 2u);
    for (const FoundSeries& each : *series) {
        EXPECT_EQ(each.modality, "CT");
        EXPECT_EQ(each.description, saysAll ? "Series" : "");
        EXPECT_TRUE(each.number == 1 || each.number == 2);
    }
    const auto ofStudy = archive.findInstances("2.25.77001", {}, progress);
    ASSERT_TRUE(ofStudy) << told(ofStudy.error());
    EXPECT_EQ(ofStudy->size(), 6u);
    const auto ofSeries = archive.findInstances("2.25.77001", "2.25.77001.2", progress);
    ASSERT_TRUE(ofSeries) << told(ofSeries.error());
    ASSERT_EQ(ofSeries->size(), 3u);
    for (const FoundInstance& each : *ofSeries) {
        EXPECT_TRUE(each.sopInstanceUid.starts_with("2.25.77001.2.")) << each.sopInstanceUid;
        EXPECT_EQ(each.sopClassUid, saysAll ? UID_CTImageStorage : "");
        EXPECT_EQ(each.seriesInstanceUid, "2.25.77001.2");
        EXPECT_TRUE(each.number.has_value());
    }
}

std::optional<FoundStudy> onlyStudy(Archive& archive, const StudyQuery& query) {
    Progress progress;
    const Result<StudyAnswers> answers = archive.findStudies(query, progress);
    EXPECT_TRUE(answers) << told(answers.error());
    if (!answers || answers->studies.size() != 1) return {};
    return answers->studies.front();
}

TEST(DimseFind, SearchesDcmtksArchive) {
    SKIP_WITHOUT_PROGRAM("dcmqrscp");
    SKIP_WITHOUT_PROGRAM("dcmsend");
    const QrArchive server;
    fillForSearches(server.port(), server.title());
    for (const bool patientRoot : {false, true}) {
        DimsePeer peer = peerAt(server.port(), server.title());
        peer.patientRoot = patientRoot;
        const auto archive = archiveAt(peer);
        expectSearches(*archive);
        expectLevels(*archive, false);
    }
}

TEST(DimseFind, SearchesOrthanc) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    SKIP_WITHOUT_PROGRAM("dcmsend");
    Orthanc server;
    fillForSearches(server.dicomPort(), server.title());
    const auto archive = archiveAt(peerAt(server.dicomPort(), server.title()));
    expectSearches(*archive);
    expectLevels(*archive, true);
    EXPECT_EQ(uidsFound(*archive, {.modality = "MR"}), Uids{"2.25.77003"});
    EXPECT_EQ(uidsFound(*archive, {.referringPhysician = "HOUSE*"}).size(), 3u);
    const auto study = onlyStudy(*archive, {.studyInstanceUid = "2.25.77001"});
    ASSERT_TRUE(study);
    EXPECT_EQ(study->patientName, "MEIER^ANNA");
    EXPECT_EQ(study->patientId, "P1");
    EXPECT_EQ(study->patientBirthDate, "19700131");
    EXPECT_EQ(study->date, "20240229");
    EXPECT_EQ(study->time, "103000");
    EXPECT_EQ(study->description, "HEAD");
    EXPECT_EQ(study->accessionNumber, "AP1");
    EXPECT_EQ(study->studyId, "SP1");
    EXPECT_EQ(study->referringPhysician, "HOUSE^GREGORY");
    EXPECT_EQ(study->modalities, std::vector<std::string>{"CT"});
    EXPECT_EQ(study->seriesCount, 2u);
    EXPECT_EQ(study->instanceCount, 6u);
}

TEST(DimseFind, TextIsUtf8WhateverTheArchiveWrites) {
    SKIP_WITHOUT_PROGRAM("dcmqrscp");
    SKIP_WITHOUT_PROGRAM("Orthanc");
    SKIP_WITHOUT_PROGRAM("dcmsend");
    const QrArchive dcmtk;
    fillForSearches(dcmtk.port(), dcmtk.title());
    Orthanc orthanc;  // which answers in Latin 1
    fillForSearches(orthanc.dicomPort(), orthanc.title());
    for (const std::string characterSet : {"ISO_IR 192", "ISO_IR 100"}) {
        DimsePeer peer = peerAt(dcmtk.port(), dcmtk.title());
        peer.characterSet = characterSet;
        const auto study = onlyStudy(*archiveAt(peer), {.patientId = "P2"});
        ASSERT_TRUE(study) << characterSet;
        EXPECT_EQ(study->patientName, "Müller^Jürgen") << characterSet;
        EXPECT_EQ(study->description, "Schädel") << characterSet;
    }
    for (const std::string characterSet : {"ISO_IR 192", "ISO_IR 100"}) {
        DimsePeer peer = peerAt(orthanc.dicomPort(), orthanc.title());
        peer.characterSet = characterSet;
        const auto archive = archiveAt(peer);
        const auto study = onlyStudy(*archive, {.patientName = "Müller*"});
        ASSERT_TRUE(study) << characterSet;
        EXPECT_EQ(study->patientName, "Müller^Jürgen") << characterSet;
        EXPECT_EQ(study->description, "Schädel") << characterSet;
    }
    DimsePeer narrow = peerAt(orthanc.dicomPort(), orthanc.title());
    narrow.characterSet = "ISO_IR 100";
    Progress progress;
    const auto answers = archiveAt(narrow)->findStudies({.patientName = "山田*"}, progress);
    ASSERT_FALSE(answers);
    EXPECT_EQ(answers.error().code, ErrorCode::usage);
}

TEST(DimseFind, EndsAtTheMostThatIsWanted) {
    SKIP_WITHOUT_PROGRAM("dcmqrscp");
    SKIP_WITHOUT_PROGRAM("dcmsend");
    const QrArchive server;
    fillForSearches(server.port(), server.title());
    const auto archive = archiveAt(peerAt(server.port(), server.title()));
    for (const std::size_t most : {1u, 2u, 3u, 4u}) {
        Progress progress;
        const auto answers = archive->findStudies({.mostAnswers = most}, progress);
        ASSERT_TRUE(answers) << told(answers.error());
        EXPECT_EQ(answers->studies.size(), std::min<std::size_t>(most, 3));
        EXPECT_EQ(answers->isCutShort, most < 3);
    }
}

// No archive is asked: many would answer as if there were no such study.
TEST(DimseFind, AMalformedQueryIsUsage) {
    const auto archive = archiveAt(peerAt(freePort(), "NOBODY"));
    Progress progress;
    for (const StudyQuery& query :
         {StudyQuery{.patientBirthDate = "1.1.1970"}, StudyQuery{.dateFrom = "20201"},
          StudyQuery{.dateTo = "yesterday"}, StudyQuery{.studyInstanceUid = "1.2.*"}})
        EXPECT_EQ(archive->findStudies(query, progress).error().code, ErrorCode::usage);
    EXPECT_EQ(archive->findSeries("../1", progress).error().code, ErrorCode::usage);
    EXPECT_EQ(archive->findInstances("1.2", "a", progress).error().code, ErrorCode::usage);
}

TEST(DimseFind, CancelledIsCancelled) {
    SKIP_WITHOUT_PROGRAM("dcmqrscp");
    const QrArchive server;
    const auto archive = archiveAt(peerAt(server.port(), server.title()));
    const CancelToken token;
    token.cancel();
    Progress progress({}, token);
    const auto answers = archive->findStudies({}, progress);
    ASSERT_FALSE(answers);
    EXPECT_EQ(answers.error().code, ErrorCode::cancelled);
}

}  // namespace

}  // namespace macula::net::test
