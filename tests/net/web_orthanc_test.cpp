// Archives of the web against Orthanc with its DICOMweb.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcdeftag.h>
#include <gtest/gtest.h>

#include <fstream>

#include "dicom/synthetic.h"
#include "net/connect.h"
#include "net/servers.h"
#include "net/tls_front.h"
#include "net/web_receiver.h"

namespace macula::net::test {
namespace {

using dicom::test::SyntheticSeries;
using dicom::test::TemporaryFolder;
using Files = std::vector<std::filesystem::path>;

Source sourceOf(const Orthanc& orthanc) {
    WebPeer peer;
    peer.url = orthanc.webUrl();
    Source source;
    source.name = "Orthanc";
    source.peer = peer;
    return source;
}

std::unique_ptr<Archive> opened(const Source& source, const Secrets& secrets = {}) {
    auto archive = archiveOf(source, secrets);
    EXPECT_TRUE(archive.ok()) << (archive.ok() ? "" : archive.error().message.english());
    return archive.ok() ? *std::move(archive) : nullptr;
}

template <class T>
std::string wordsOf(const Result<T>& result) {
    return result.ok() ? "no error" : result.error().message.english();
}

SyntheticSeries seriesOf(const std::string& study, const std::string& series, int slices) {
    SyntheticSeries made;
    made.studyUid = study;
    made.seriesUid = series;
    made.size = {6, 5, slices};
    return made;
}

// Two series, of 5 and 3 images.
Files studyIn(const TemporaryFolder& folder) {
    Files files = dicom::test::writeFiles(folder / "a", seriesOf("2.25.77", "2.25.771", 5));
    SyntheticSeries other = seriesOf("2.25.77", "2.25.772", 3);
    other.number = 2;
    const Files more = dicom::test::writeFiles(folder / "b", other);
    files.insert(files.end(), more.begin(), more.end());
    return files;
}

std::map<std::string, std::string> datasetsByUid(const Files& files) {
    std::map<std::string, std::string> datasets;
    for (const auto& file : files) datasets[readFileMeta(file).value().sopInstanceUid] = datasetBytes(file);
    return datasets;
}

void expectSame(const Files& sent, const WebReceiver& receiver) {
    const auto datasets = datasetsByUid(sent);
    EXPECT_EQ(receiver.kept.size(), datasets.size());
    for (const auto& [uid, file] : receiver.kept) {
        ASSERT_TRUE(datasets.contains(uid));
        EXPECT_EQ(datasetBytes(file), datasets.at(uid)) << "the bytes behind the meta information";
    }
}

class WebOrthanc : public testing::Test {
  protected:
    void SetUp() override { SKIP_WITHOUT_PROGRAM("Orthanc"); }

    TemporaryFolder folder_;
    Progress progress_;
};

TEST_F(WebOrthanc, WhatIsSentIsFoundAndFetched) {
    const Orthanc orthanc;
    const auto archive = opened(sourceOf(orthanc));
    ASSERT_TRUE(archive);
    const Files files = studyIn(folder_);
    const auto sent = archive->send(files, progress_);
    ASSERT_TRUE(sent.ok()) << wordsOf(sent);
    EXPECT_EQ(sent->stored, files.size());
    EXPECT_TRUE(sent->notSent.empty());

    const auto studies = archive->findStudies({.patientName = "SYNTH*"}, progress_);
    ASSERT_TRUE(studies.ok()) << wordsOf(studies);
    ASSERT_EQ(studies->studies.size(), 1u);
    const FoundStudy& study = studies->studies.front();
    EXPECT_EQ(study.studyInstanceUid, "2.25.77");
    EXPECT_EQ(study.patientName, "SYNTHETIC^ONE");
    EXPECT_EQ(study.patientId, "SYN1");
    EXPECT_EQ(study.modalities, std::vector<std::string>{"CT"});
    EXPECT_EQ(study.seriesCount, 2u);
    EXPECT_EQ(study.instanceCount, 8u);
    EXPECT_FALSE(studies->isCutShort);

    const auto series = archive->findSeries("2.25.77", progress_);
    ASSERT_TRUE(series.ok()) << wordsOf(series);
    ASSERT_EQ(series->size(), 2u);
    for (const FoundSeries& one : *series) {
        EXPECT_EQ(one.modality, "CT");
        EXPECT_EQ(one.instanceCount, one.seriesInstanceUid == "2.25.771" ? 5u : 3u);
    }
    const auto all = archive->findInstances("2.25.77", {}, progress_);
    ASSERT_TRUE(all.ok()) << wordsOf(all);
    EXPECT_EQ(all->size(), 8u);
    const auto some = archive->findInstances("2.25.77", "2.25.772", progress_);
    ASSERT_TRUE(some.ok()) << wordsOf(some);
    EXPECT_EQ(some->size(), 3u);
    for (const FoundInstance& one : *some) {
        EXPECT_EQ(one.seriesInstanceUid, "2.25.772");
        EXPECT_EQ(one.sopClassUid, "1.2.840.10008.5.1.4.1.1.2");
    }

    WebReceiver receiver(folder_ / "fetched");
    const auto fetched = archive->fetch({.studyInstanceUid = "2.25.77"}, receiver, progress_);
    ASSERT_TRUE(fetched.ok()) << wordsOf(fetched);
    EXPECT_EQ(fetched->promised, 8u);
    EXPECT_EQ(fetched->kept, 8u);
    EXPECT_EQ(fetched->hadAlready, 0u);
    EXPECT_EQ(fetched->refused, 0u);
    EXPECT_TRUE(fetched->never.empty());
    EXPECT_EQ(receiver.dropped, 0);
    expectSame(files, receiver);
}

TEST_F(WebOrthanc, OnlyWhatIsMissingComes) {
    const Orthanc orthanc;
    const auto archive = opened(sourceOf(orthanc));
    ASSERT_TRUE(archive);
    const Files files = studyIn(folder_);
    ASSERT_TRUE(archive->send(files, progress_).ok());
    Wanted wanted{.studyInstanceUid = "2.25.77", .seriesInstanceUids = {"2.25.771"}};
    for (int i = 0; i < 3; ++i)
        wanted.sopInstancesHad.insert(
            readFileMeta(files[static_cast<std::size_t>(i)]).value().sopInstanceUid);
    WebReceiver receiver(folder_ / "fetched");
    const auto fetched = archive->fetch(wanted, receiver, progress_);
    ASSERT_TRUE(fetched.ok()) << wordsOf(fetched);
    EXPECT_EQ(fetched->promised, 5u);
    EXPECT_EQ(fetched->hadAlready, 3u);
    EXPECT_EQ(fetched->kept, 2u);
    EXPECT_EQ(receiver.placed, 2);
    for (const auto& [uid, file] : receiver.kept) EXPECT_FALSE(wanted.sopInstancesHad.contains(uid));
    EXPECT_EQ(receiver.lastPromised.seriesInstanceUid, "2.25.771");
    EXPECT_FALSE(receiver.lastPromised.sopInstanceUid.empty());
}

TEST_F(WebOrthanc, EncodingsComeUnchanged) {
    const Orthanc orthanc;
    const auto archive = opened(sourceOf(orthanc));
    ASSERT_TRUE(archive);
    int number = 0;
    for (const auto syntax : {dicom::WriteSyntax::implicitLittleEndian, dicom::WriteSyntax::explicitBigEndian,
                              dicom::WriteSyntax::deflated, dicom::WriteSyntax::rle,
                              dicom::WriteSyntax::jpegLossless, dicom::WriteSyntax::jpegLs}) {
        // Their identifiers are the same: each replaces those before it.
        const TemporaryFolder folder;
        const auto files = dicom::test::write(dicom::test::smallVolume(), folder.path(), {.syntax = syntax});
        const auto sent = archive->send(files, progress_);
        ASSERT_TRUE(sent.ok()) << wordsOf(sent);
        EXPECT_EQ(sent->stored, files.size());
        const auto studies = archive->findStudies({}, progress_);
        ASSERT_TRUE(studies.ok()) << wordsOf(studies);
        ASSERT_EQ(studies->studies.size(), 1u);
        WebReceiver receiver(folder_ / std::to_string(++number));
        const auto fetched = archive->fetch({.studyInstanceUid = studies->studies.front().studyInstanceUid},
                                            receiver, progress_);
        ASSERT_TRUE(fetched.ok()) << wordsOf(fetched);
        expectSame(files, receiver);
        const auto before = readFileMeta(files.front());
        const auto after = readFileMeta(receiver.kept.at(before->sopInstanceUid));
        EXPECT_EQ(after->transferSyntaxUid, before->transferSyntaxUid);
    }
}

TEST_F(WebOrthanc, ARealStudyComesUnchanged) {
    SKIP_WITHOUT_SHARED_DATA();
    Files files;
    for (const auto& entry :
         std::filesystem::directory_iterator(dicom::test::sharedData() / "ct_chest_ricord"))
        if (readFileMeta(entry.path()).ok()) files.push_back(entry.path());
    ASSERT_GT(files.size(), 50u);
    const Orthanc orthanc;
    const auto archive = opened(sourceOf(orthanc));
    ASSERT_TRUE(archive);
    const auto sent = archive->send(files, progress_);
    ASSERT_TRUE(sent.ok()) << wordsOf(sent);
    EXPECT_EQ(sent->stored, files.size());
    const auto studies = archive->findStudies({}, progress_);
    ASSERT_TRUE(studies.ok()) << wordsOf(studies);
    ASSERT_EQ(studies->studies.size(), 1u);
    WebReceiver receiver(folder_ / "fetched");
    const auto fetched =
        archive->fetch({.studyInstanceUid = studies->studies.front().studyInstanceUid}, receiver, progress_);
    ASSERT_TRUE(fetched.ok()) << wordsOf(fetched);
    EXPECT_EQ(fetched->kept, files.size());
    expectSame(files, receiver);
}

TEST_F(WebOrthanc, SearchesAreNarrowed) {
    const Orthanc orthanc;
    const auto archive = opened(sourceOf(orthanc));
    ASSERT_TRUE(archive);
    Files files;
    for (int i = 0; i < 7; ++i) {
        SyntheticSeries series = seriesOf("2.25.9" + std::to_string(i), "2.25.19" + std::to_string(i), 1);
        series.patientId = "A&B=" + std::to_string(i);
        series.patientName = i == 3 ? "M\xc3\xbcller^J\xc3\xb6rg" : "DOE^J" + std::to_string(i);
        const std::string date = "2020010" + std::to_string(i + 1);
        series.edits.push_back([=](DcmItem& item) {
            dicom::test::put(item, DCM_StudyDate, date);
            dicom::test::put(item, DCM_SpecificCharacterSet, "ISO_IR 192");
        });
        for (auto& slice : dicom::test::slicesOf(series)) {
            slice.sopInstanceUid = "2.25.29" + std::to_string(i);
            const auto one = dicom::test::writeFiles(folder_ / std::to_string(i), series, {slice});
            files.insert(files.end(), one.begin(), one.end());
        }
    }
    const auto sent = archive->send(files, progress_);
    ASSERT_TRUE(sent.ok()) << wordsOf(sent);
    ASSERT_EQ(sent->stored, 7u);
    const auto count = [&](const StudyQuery& query) {
        const auto found = archive->findStudies(query, progress_);
        EXPECT_TRUE(found.ok()) << wordsOf(found);
        return found.ok() ? static_cast<int>(found->studies.size()) : -1;
    };
    EXPECT_EQ(count({}), 7);
    EXPECT_EQ(count({.patientName = "DOE*"}), 6);
    EXPECT_EQ(count({.patientName = "DOE^J2"}), 1);
    EXPECT_EQ(count({.patientName = "doe^j?"}), 6);
    EXPECT_EQ(count({.patientName = "DOE^K*"}), 0);
    EXPECT_EQ(count({.patientId = "A&B=2"}), 1);
    EXPECT_EQ(count({.patientId = "A&B=?"}), 7);
    EXPECT_EQ(count({.patientId = "A+B=2"}), 0);
    EXPECT_EQ(count({.dateFrom = "20200103", .dateTo = "20200105"}), 3);
    EXPECT_EQ(count({.dateFrom = "20200103"}), 5);
    EXPECT_EQ(count({.dateTo = "20200102"}), 2);
    EXPECT_EQ(count({.modality = "MR"}), 0);
    EXPECT_EQ(count({.studyInstanceUid = "2.25.94"}), 1);
    const auto found = archive->findStudies({.patientName = "M\xc3\xbc*"}, progress_);
    ASSERT_TRUE(found.ok()) << wordsOf(found);
    ASSERT_EQ(found->studies.size(), 1u);
    EXPECT_EQ(found->studies.front().patientName, "M\xc3\xbcller^J\xc3\xb6rg");
    EXPECT_EQ(found->studies.front().date, "20200104");
    const auto few = archive->findStudies({.mostAnswers = 4}, progress_);
    ASSERT_TRUE(few.ok()) << wordsOf(few);
    EXPECT_EQ(few->studies.size(), 4u);
    EXPECT_TRUE(few->isCutShort);
    const auto exact = archive->findStudies({.mostAnswers = 7}, progress_);
    ASSERT_TRUE(exact.ok()) << wordsOf(exact);
    EXPECT_EQ(exact->studies.size(), 7u);
    EXPECT_FALSE(exact->isCutShort);
}

TEST_F(WebOrthanc, WhatIsNoDicomIsNotSent) {
    const Orthanc orthanc;
    const auto archive = opened(sourceOf(orthanc));
    ASSERT_TRUE(archive);
    Files files = studyIn(folder_);
    files.insert(files.begin(), folder_ / "text");
    std::ofstream(files.front()) << "no DICOM";
    files.push_back(folder_ / "missing");
    const auto sent = archive->send(files, progress_);
    ASSERT_TRUE(sent.ok()) << wordsOf(sent);
    EXPECT_EQ(sent->stored, files.size() - 2);
    ASSERT_EQ(sent->notSent.size(), 2u);
    EXPECT_EQ(sent->notSent[0].file, files.front());
    EXPECT_EQ(sent->notSent[1].file, files.back());
    for (const NotSent& one : sent->notSent) {
        EXPECT_FALSE(one.why.empty());
        EXPECT_FALSE(one.advice.empty());
    }
}

TEST_F(WebOrthanc, EncryptedWithAPassword) {
    std::filesystem::create_directory(folder_ / "tls");
    std::filesystem::create_directory(folder_ / "other");
    const Authority authority(folder_ / "tls");
    OrthancOptions options;
    options.user = "reader";
    options.password = "right: \xc3\xa4 %2F";
    const Orthanc orthanc(options);
    Source source = sourceOf(orthanc);
    WebPeer& peer = std::get<WebPeer>(source.peer);
    const TlsFront front(authority.sign("server"), orthanc.httpPort());
    peer.url = "https://127.0.0.1:" + std::to_string(front.port()) + "/dicom-web";
    peer.tls.authorities = authority.file();
    peer.signIn = SignIn::basic;
    peer.user = options.user;
    const Files files = studyIn(folder_);
    {
        const auto archive = opened(source, {.password = options.password});
        ASSERT_TRUE(archive);
        const auto sent = archive->send(files, progress_);
        ASSERT_TRUE(sent.ok()) << wordsOf(sent);
        WebReceiver receiver(folder_ / "fetched");
        const auto fetched = archive->fetch({.studyInstanceUid = "2.25.77"}, receiver, progress_);
        ASSERT_TRUE(fetched.ok()) << wordsOf(fetched);
        expectSame(files, receiver);
        const auto steps = archive->test(progress_);
        ASSERT_EQ(steps.size(), 7u);
        for (const TestStep& step : steps) EXPECT_TRUE(step.passed) << step.name << ": " << step.detail;
    }
    {
        const auto archive = opened(source, {.password = "wrong"});
        const auto found = archive->findStudies({}, progress_);
        ASSERT_FALSE(found.ok());
        EXPECT_EQ(found.error().code, ErrorCode::archiveNotUsable);
        EXPECT_EQ(wordsOf(found), "The archive does not accept the sign-in (401).");
        const auto steps = archive->test(progress_);
        ASSERT_EQ(steps.size(), 5u);
        EXPECT_EQ(steps.back().name, "Sign-in");
        EXPECT_FALSE(steps.back().passed);
        EXPECT_FALSE(steps.back().advice.empty());
    }
    {
        peer.tls.authorities = Authority(folder_ / "other").file();
        const auto archive = opened(source, {.password = options.password});
        EXPECT_EQ(wordsOf(archive->findStudies({}, progress_)),
                  "The archive's certificate is signed by nobody whom this machine trusts.");
        const auto steps = archive->test(progress_);
        EXPECT_EQ(steps.back().name, "Encryption");
    }
}

TEST_F(WebOrthanc, AnArchiveThatComesBackGoesOn) {
    Orthanc orthanc;
    const auto archive = opened(sourceOf(orthanc));
    ASSERT_TRUE(archive);
    const Files files = studyIn(folder_);
    ASSERT_TRUE(archive->send(files, progress_).ok());
    WebReceiver receiver(folder_ / "fetched");
    receiver.onTake = [&] {
        if (receiver.taken != 2) return;
        orthanc.stop();
        orthanc.start();
    };
    const auto fetched = archive->fetch({.studyInstanceUid = "2.25.77"}, receiver, progress_);
    ASSERT_TRUE(fetched.ok()) << wordsOf(fetched);
    expectSame(files, receiver);
    EXPECT_TRUE(fetched->never.empty());
    orthanc.stop();
    const auto found = archive->findStudies({}, progress_);
    EXPECT_EQ(wordsOf(found), "The archive's host does not accept connections at this port.");
    const auto steps = archive->test(progress_);
    EXPECT_EQ(steps.back().name, "Connection");
    EXPECT_FALSE(steps.back().passed);
}

}  // namespace
}  // namespace macula::net::test
