// A fetch whose connections break at random moments brings every image, and none twice.
// MACULA_EVERY_BREAK=1 breaks 200 times among 1000 images.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "net/cutting_front.h"
#include "net/dimse_support.h"
#include "net/servers.h"
#include "net/web_receiver.h"

namespace macula::net::test {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLeastBytes = 100;
constexpr std::size_t kMostBytes = 400'000;
constexpr int kMostFetches = 2000;
constexpr std::size_t kImagesOfPart = 60;
const std::string kStudyUid = "2.25.88";

struct Extent {
    int images;
    int breaks;
};
Extent extent() {
    const char* every = std::getenv("MACULA_EVERY_BREAK");
    return every != nullptr && *every == '1' ? Extent{1000, 200} : Extent{60, 10};
}

// Of about 9 kB each. Sent in parts: no program of others may take long in a test.
void fill(Orthanc& archive, int images) {
    dicom::test::SyntheticSeries series;
    series.studyUid = kStudyUid;
    series.seriesUid = kStudyUid + ".1";
    series.size = {64, 64, images};
    series.rawInstead = [](const dicom::test::Slice&, int i, int j) { return i + j; };
    const auto slices = dicom::test::slicesOf(series);
    for (std::size_t begin = 0; begin < slices.size(); begin += kImagesOfPart) {
        const dicom::test::TemporaryFolder folder;
        const auto first = slices.begin() + static_cast<std::ptrdiff_t>(begin);
        const std::size_t count = std::min(kImagesOfPart, slices.size() - begin);
        dicom::test::writeFiles(folder.path(), series, {first, first + static_cast<std::ptrdiff_t>(count)});
        sendFolder(folder.path(), archive.dicomPort(), archive.title());
    }
}

// `again`: images that a person sees first, which come once more with their series.
void expectAllDespiteBreaks(Archive& archive, CuttingFront& front, const Extent& extent, int again = 0) {
    const dicom::test::TemporaryFolder folder;
    WebReceiver receiver(folder.path());
    const auto images = static_cast<std::size_t>(extent.images);
    int fetches = 0;
    for (; fetches < kMostFetches; ++fetches) {
        if (front.cuts() >= extent.breaks) front.stopCutting();
        Wanted wanted{.studyInstanceUid = kStudyUid};
        for (const auto& [uid, file] : receiver.kept) wanted.sopInstancesHad.insert(uid);
        Progress progress;
        const auto fetched = archive.fetch(wanted, receiver, progress);
        if (!fetched) continue;
        EXPECT_EQ(fetched->promised, images);
        if (fetched->never.empty()) break;
    }
    EXPECT_LT(fetches, kMostFetches);
    EXPECT_EQ(receiver.kept.size(), images);
    EXPECT_LE(receiver.taken, extent.images + again) << "some came twice";
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), extent.images) << "parts stayed";
    testing::Test::RecordProperty("breaks", front.cuts());
}

TEST(FetchBreaks, LoseNoImageByDimse) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    Orthanc server;
    const Extent much = extent();
    fill(server, much.images);
    CuttingFront front(server.dicomPort(), kLeastBytes, kMostBytes, 1);
    const auto archive = archiveAt(peerAt(front.port(), server.title()));
    expectAllDespiteBreaks(*archive, front, much);
}

TEST(FetchBreaks, LoseNoImageByDicomWeb) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    Orthanc server;
    const Extent much = extent();
    fill(server, much.images);
    CuttingFront front(server.httpPort(), kLeastBytes, kMostBytes, 2);
    Source source;
    source.name = "Hospital";
    WebPeer peer;
    peer.url = "http://127.0.0.1:" + std::to_string(front.port()) + "/dicom-web";
    source.peer = peer;
    const auto archive = archiveOf(source, {});
    ASSERT_TRUE(archive);
    expectAllDespiteBreaks(**archive, front, much, 16);
}

}  // namespace

}  // namespace macula::net::test
