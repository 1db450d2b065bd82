#include "net/dimse_support.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

#include "net/servers.h"

namespace macula::net::test {

namespace fs = std::filesystem;

DimsePeer peerAt(std::uint16_t port, const std::string& title) {
    DimsePeer peer;
    peer.host = "127.0.0.1";
    peer.port = port;
    peer.calledAe = title;
    return peer;
}

std::unique_ptr<Archive> archiveAt(const DimsePeer& peer, const Secrets& secrets,
                                   std::chrono::seconds answerTimeout) {
    Source source;
    source.name = "test";
    source.peer = peer;
    source.connectTimeout = std::chrono::seconds(5);
    source.answerTimeout = answerTimeout;
    Result<std::unique_ptr<Archive>> archive = archiveOf(source, secrets);
    EXPECT_TRUE(archive) << told(archive.error());
    return archive ? std::move(*archive) : nullptr;
}

Result<fs::path> FolderReceiver::place() {
    const std::lock_guard lock(mutex_);
    if (placed_ >= fullAfter) return Error{ErrorCode::outputNotWritable, Text("The place is full."), {}, {}};
    const fs::path file = folder_ / fmt::format("{}.dcm", placed_++);
    std::ofstream(file).flush();
    return file;
}

Result<Receiver::Verdict> FolderReceiver::take(const fs::path& file, const InstanceKey& promised) {
    const std::lock_guard lock(mutex_);
    promises_.push_back(promised);
    if (cancels) cancelsAfterFirst.cancel();
    if (refuses.contains(promised.sopInstanceUid)) return Verdict::refused;
    return files_.emplace(promised.sopInstanceUid, file).second ? Verdict::kept : Verdict::hadAlready;
}

void FolderReceiver::drop(const fs::path& file) noexcept {
    const std::lock_guard lock(mutex_);
    ++drops_;
    std::error_code ignored;
    fs::remove(file, ignored);
}

std::map<std::string, fs::path> FolderReceiver::files() const {
    const std::lock_guard lock(mutex_);
    return files_;
}

std::vector<InstanceKey> FolderReceiver::promises() const {
    const std::lock_guard lock(mutex_);
    return promises_;
}

std::size_t FolderReceiver::drops() const {
    const std::lock_guard lock(mutex_);
    return drops_;
}

std::size_t FolderReceiver::filesInFolder() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()));
}

std::string seriesUidOf(const SmallStudy& study, int series) {
    return fmt::format("{}.{}", study.studyUid, series + 1);
}

std::map<std::string, fs::path> writeStudy(const fs::path& folder, const SmallStudy& study) {
    std::map<std::string, fs::path> files;
    for (int i = 0; i < study.seriesCount; ++i) {
        dicom::test::SyntheticSeries series;
        series.modality = study.modality;
        series.studyUid = study.studyUid;
        series.seriesUid = seriesUidOf(study, i);
        series.number = i + 1;
        series.patientName = study.patientName;
        series.patientId = study.patientId;
        series.size = {16, 16, study.slices};
        series.rawInstead = [](const dicom::test::Slice& slice, int x, int y) {
            return x + 16 * y + slice.place;
        };
        series.transferSyntaxUid = study.transferSyntaxUid;
        series.edits.push_back([&](DcmItem& item) {
            dicom::test::put(item, DCM_StudyDate, study.date);
            dicom::test::put(item, DCM_StudyTime, "103000");
            dicom::test::put(item, DCM_StudyDescription, study.description);
            dicom::test::put(item, DCM_AccessionNumber, "A" + study.patientId);
            dicom::test::put(item, DCM_StudyID, "S" + study.patientId);
            dicom::test::put(item, DCM_PatientBirthDate, "19700131");
            dicom::test::put(item, DCM_ReferringPhysicianName, "HOUSE^GREGORY");
            dicom::test::put(item, DCM_SeriesDescription, "Series");
        });
        series.edits.insert(series.edits.end(), study.edits.begin(), study.edits.end());
        std::vector<dicom::test::Slice> slices = dicom::test::slicesOf(series);
        for (std::size_t j = 0; j < slices.size(); ++j)
            slices[j].sopInstanceUid = fmt::format("{}.{}", series.seriesUid, j + 1);
        const fs::path own = folder / fmt::format("{}", i);
        fs::create_directories(own);
        const std::vector<fs::path> written = dicom::test::writeFiles(own, series, slices);
        for (std::size_t j = 0; j < slices.size(); ++j) files[slices[j].sopInstanceUid] = written[j];
    }
    return files;
}

void expectSameDatasets(const std::map<std::string, fs::path>& received,
                        const std::map<std::string, fs::path>& expected) {
    EXPECT_EQ(received.size(), expected.size());
    for (const auto& [uid, file] : expected) {
        const auto found = received.find(uid);
        ASSERT_NE(found, received.end()) << uid << " did not come";
        EXPECT_EQ(datasetBytes(found->second), datasetBytes(file)) << uid;
        // What was written in front of it is what DCMTK reads.
        DcmMetaInfo meta;
        ASSERT_TRUE(meta.loadFile(found->second.c_str()).good());
        OFString said;
        EXPECT_TRUE(meta.findAndGetOFString(DCM_MediaStorageSOPInstanceUID, said).good());
        EXPECT_EQ(std::string(said.c_str()), uid);
    }
}

std::string told(const Error& error) {
    return error.message.english() + " / " + error.hint.english();
}

std::string told(const std::vector<TestStep>& steps) {
    std::string all;
    for (const TestStep& step : steps)
        all += fmt::format("{} {}: {} {}\n", step.passed ? "+" : "-", step.name.english(),
                           step.detail.english(), step.advice.english());
    return all;
}

}  // namespace macula::net::test
