// The images that come first: which, over both protocols, and from archives that cannot send a part of a
// series.
#include "net/archive/first_images.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <numeric>

#include "net/dimse_support.h"
#include "net/hostile_peer.h"
#include "net/servers.h"
#include "net/web_receiver.h"

namespace macula::net::test {

namespace {

constexpr int kImages = 250;
constexpr int kFirst = 16;
const std::string kCtClass = "1.2.840.10008.5.1.4.1.1.2";

std::vector<FoundInstance> seriesOfImages(const std::string& series, int images) {
    std::vector<FoundInstance> found;
    for (int i = 0; i < images; ++i) {
        const int number = (7 * i) % images + 1;  // in no order
        found.push_back({series + "." + std::to_string(number), kCtClass, series, number});
    }
    return found;
}

std::vector<int> numbersOf(const std::vector<FoundInstance>& images) {
    std::vector<int> numbers;
    for (const FoundInstance& each : images) numbers.push_back(each.number.value_or(-1));
    return numbers;
}

TEST(FirstImages, AreNeighboursInTheMiddleOfTheLargestSeries) {
    std::vector<FoundInstance> wanted = seriesOfImages("2.25.2", 170);
    const std::vector<FoundInstance> largest = seriesOfImages("2.25.1", kImages);
    wanted.insert(wanted.end(), largest.begin(), largest.end());
    const std::vector<FoundInstance> first = firstImagesOf(wanted);
    std::vector<int> expected(kFirst);
    std::iota(expected.begin(), expected.end(), 118);
    EXPECT_EQ(numbersOf(first), expected);
    for (const FoundInstance& each : first) EXPECT_EQ(each.seriesInstanceUid, "2.25.1");
}

TEST(FirstImages, AreNoneWithoutNumbersOrInSmallSeries) {
    EXPECT_TRUE(firstImagesOf({}).empty());
    EXPECT_TRUE(firstImagesOf(seriesOfImages("2.25.1", 100)).empty());
    std::vector<FoundInstance> images = seriesOfImages("2.25.1", kImages);
    images[3].number.reset();
    EXPECT_TRUE(firstImagesOf(images).empty());
    images[3].number = images[4].number;
    EXPECT_TRUE(firstImagesOf(images).empty());
}

constexpr int kSlices = 180;
const SmallStudy kLargeStudy{.studyUid = "2.25.99", .seriesCount = 1, .slices = kSlices};

using Files = std::map<std::string, std::filesystem::path>;

std::unique_ptr<Archive> webArchiveAt(const Orthanc& server) {
    WebPeer peer;
    peer.url = server.webUrl();
    Source source;
    source.name = "Orthanc";
    source.peer = peer;
    auto archive = archiveOf(source, {});
    EXPECT_TRUE(archive);
    return archive ? *std::move(archive) : nullptr;
}

// By the web, which takes a tenth of the time of DCMTK's programs.
Files fill(const dicom::test::TemporaryFolder& folder, const Orthanc& archive) {
    Files files = writeStudy(folder.path(), kLargeStudy);
    std::vector<std::filesystem::path> paths;
    for (const auto& [uid, file] : files) paths.push_back(file);
    Progress progress;
    const auto sent = webArchiveAt(archive)->send(paths, progress);
    EXPECT_TRUE(sent && sent->stored == paths.size());
    return files;
}

// By the number of the image, in which it does not follow its UID.
void expectNeighbours(const std::vector<std::string>& uids, const Files& files) {
    std::vector<long> numbers;
    for (const std::string& uid : uids) {
        DcmFileFormat format;
        OFString number;
        ASSERT_TRUE(format.loadFile(files.at(uid).c_str()).good());
        ASSERT_TRUE(format.getDataset()->findAndGetOFString(DCM_InstanceNumber, number).good());
        numbers.push_back(std::stol(number.c_str()));
    }
    ASSERT_FALSE(numbers.empty());
    const auto [low, high] = std::ranges::minmax(numbers);
    EXPECT_LT(high - low, kFirst);
}

TEST(FirstImages, ComeFirstByDimseAndNoneComesTwice) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    Orthanc server;
    const dicom::test::TemporaryFolder folder;
    const auto files = fill(folder, server);
    FolderReceiver receiver;
    Progress progress;
    const auto fetched = archiveAt(peerAt(server.dicomPort(), server.title()))
                             ->fetch({.studyInstanceUid = kLargeStudy.studyUid}, receiver, progress);
    ASSERT_TRUE(fetched) << told(fetched.error());
    EXPECT_EQ(fetched->kept, files.size());
    expectSameDatasets(receiver.files(), files);
    const std::vector<InstanceKey> came = receiver.promises();
    ASSERT_EQ(came.size(), files.size());
    std::vector<std::string> first;
    for (std::size_t i = 0; i < kFirst; ++i) first.push_back(came[i].sopInstanceUid);
    expectNeighbours(first, files);
}

TEST(FirstImages, ComeFirstByDicomWebAndAreKeptOnce) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    Orthanc server;
    const dicom::test::TemporaryFolder folder;
    const auto files = fill(folder, server);
    const auto archive = webArchiveAt(server);
    const dicom::test::TemporaryFolder kept;
    WebReceiver receiver(kept.path());
    std::vector<std::string> first;
    // Several come at once, and their series begins beside the last of them.
    receiver.onTake = [&] {
        if (receiver.taken <= kFirst - 4) first.push_back(receiver.lastPromised.sopInstanceUid);
    };
    Progress progress;
    const auto fetched = archive->fetch({.studyInstanceUid = kLargeStudy.studyUid}, receiver, progress);
    ASSERT_TRUE(fetched) << fetched.error().message;
    EXPECT_EQ(fetched->promised, files.size());
    EXPECT_EQ(fetched->kept, files.size());
    EXPECT_EQ(fetched->hadAlready, 0u) << "nothing was there before";
    EXPECT_TRUE(fetched->never.empty());
    EXPECT_EQ(receiver.kept.size(), files.size());
    EXPECT_LE(receiver.taken, kSlices + kFirst);
    ASSERT_EQ(first.size(), std::size_t(kFirst - 4));
    expectNeighbours(first, files);
}

Bytes answer(const std::string& level, const std::vector<Bytes>& elements) {
    std::vector<Bytes> all{explicitElement(0x00080052, "CS", level)};
    all.insert(all.end(), elements.begin(), elements.end());
    return joined(all);
}

// Sends, for its first C-GET, `sent` of the images with that status, and all of them for any other.
void sendImages(HostileLine& line, const HostileLine::Received& request, int sent, std::uint16_t status) {
    const unsigned context = line.contextOf(kCtClass);
    for (int i = 0; i < sent; ++i) {
        const std::string uid = "2.25.1.1." + std::to_string(118 + i > kImages ? 118 + i - kImages : 118 + i);
        line.sendCommand(context, {.field = CommandField::storeRequest,
                                   .messageId = std::uint16_t{7},
                                   .sopClassUid = kCtClass,
                                   .sopInstanceUid = uid,
                                   .hasDataset = true});
        line.sendFragment(
            context, false, true,
            joined({explicitElement(0x00080016, "UI", kCtClass), explicitElement(0x00080018, "UI", uid),
                    explicitElement(0x0020000d, "UI", "2.25.1")}));
        if (!line.receiveCommand()) return;
    }
    line.sendCommand(
        request.context,
        {.field = CommandField::getResponse, .respondsTo = request.command.messageId, .status = status});
}

void sendList(HostileLine& line, const HostileLine::Received& request, bool isOfSeries) {
    std::vector<Bytes> answers;
    if (isOfSeries) answers.push_back(answer("SERIES", {explicitElement(0x0020000e, "UI", "2.25.1.1")}));
    for (int i = 1; !isOfSeries && i <= kImages; ++i)
        answers.push_back(answer("IMAGE", {explicitElement(0x00080016, "UI", kCtClass),
                                           explicitElement(0x00080018, "UI", "2.25.1.1." + std::to_string(i)),
                                           explicitElement(0x00200013, "IS", std::to_string(i))}));
    const Command pending{.field = CommandField::findResponse,
                          .respondsTo = request.command.messageId,
                          .status = std::uint16_t{0xff00},
                          .hasDataset = true};
    for (const Bytes& each : answers) {
        line.sendCommand(request.context, pending);
        line.sendFragment(request.context, false, true, each);
    }
    line.sendCommand(request.context, {.field = CommandField::findResponse,
                                       .respondsTo = request.command.messageId,
                                       .status = std::uint16_t{0}});
}

TEST(FirstImages, OfAnArchiveThatSendsOnlyWholeStudiesComeWithTheOthers) {
    for (const int sentFirst : {0, 1}) {
        std::atomic<int> finds{0};
        std::atomic<int> gets{0};
        HostilePeer peer([&](HostileLine& line) {
            if (!line.acceptAssociation()) return;
            while (const auto request = line.receiveCommand()) {
                if (request->command.field == CommandField::findRequest)
                    sendList(line, *request, finds++ == 0);
                if (request->command.field != CommandField::getRequest) continue;
                const bool isFirst = gets++ == 0;
                sendImages(line, *request, isFirst ? sentFirst : kImages, isFirst ? 0xa900 : 0);
            }
        });
        DimsePeer settings = peerAt(peer.port(), "HOSTILE");
        settings.retrieve = Retrieve::get;
        FolderReceiver receiver;
        Progress progress;
        const auto fetched = archiveAt(settings)->fetch({.studyInstanceUid = "2.25.1"}, receiver, progress);
        ASSERT_TRUE(fetched) << told(fetched.error());
        EXPECT_EQ(gets, 2) << "the study as a whole, no lists of its images";
        EXPECT_EQ(fetched->kept, std::size_t(kImages));
        EXPECT_TRUE(fetched->never.empty());
        EXPECT_TRUE(fetched->isListWhole);
    }
}

TEST(FirstImages, OfAnArchiveThatEndsAtThemComeWithTheOthersTheNextTime) {
    std::atomic<int> finds{0};
    std::atomic<int> gets{0};
    HostilePeer peer([&](HostileLine& line) {
        if (!line.acceptAssociation()) return;
        while (const auto request = line.receiveCommand()) {
            if (request->command.field == CommandField::findRequest) sendList(line, *request, finds++ == 0);
            if (request->command.field != CommandField::getRequest) continue;
            if (gets++ == 0) return;  // closes the connection
            sendImages(line, *request, kImages, 0);
        }
    });
    DimsePeer settings = peerAt(peer.port(), "HOSTILE");
    settings.retrieve = Retrieve::get;
    FolderReceiver receiver;
    Progress progress;
    const auto fetched = archiveAt(settings)->fetch({.studyInstanceUid = "2.25.1"}, receiver, progress);
    ASSERT_TRUE(fetched) << told(fetched.error());
    EXPECT_EQ(gets, 2);
    EXPECT_EQ(fetched->kept, std::size_t(kImages));
}

}  // namespace

}  // namespace macula::net::test
