// Pictures that archives of the web draw: Orthanc's, and answers that no archive should give.
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <mutex>
#include <thread>

#include "dicom/synthetic.h"
#include "net/connect.h"
#include "net/scripted_server.h"
#include "net/servers.h"

namespace macula::net::test {
namespace {

using Request = ScriptedServer::Request;
using Peer = ScriptedServer::Peer;

constexpr const char* kJson = "application/dicom+json";
const std::string kJpeg = "\xff\xd8\xff\xe0 a picture";
const std::string kPng = "\x89PNG\r\n\x1a\n a picture";

std::unique_ptr<PictureSource> picturesAt(const std::string& url) {
    Source source;
    WebPeer peer;
    peer.url = url;
    source.peer = peer;
    source.answerTimeout = std::chrono::seconds(20);
    auto pictures = picturesOf(source, {});
    EXPECT_TRUE(pictures.ok());
    return *std::move(pictures);
}

FoundSeries seriesOf(const std::string& uid, std::size_t instances = 9) {
    return {.seriesInstanceUid = uid, .modality = "CT", .instanceCount = instances};
}

bool isThumbnail(const Request& request) {
    return request.target.find("/thumbnail") != std::string::npos;
}
bool isRendered(const Request& request) {
    return request.target.find("/rendered") != std::string::npos;
}

// Answers searches for instances, and leaves pictures to the test.
class PictureServer {
  public:
    explicit PictureServer(std::function<void(const Request&, Peer&)> draws)
        : server_([draws = std::move(draws)](const Request& request, Peer& peer) {
              if (isThumbnail(request) || isRendered(request)) return draws(request, peer);
              peer.answer(200, kJson, R"([{"00080018":{"vr":"UI","Value":["1.4"]}}])");
          }),
          pictures_(picturesAt(server_.url())) {}

    Result<std::optional<EncodedPicture>> ask(const FoundSeries& series = seriesOf("1.3")) {
        Progress progress;
        return pictures_->pictureOf("1.2", series, 72, progress);
    }
    bool isOffered() const { return pictures_->isOffered(); }
    std::size_t requests() const { return server_.requests().size(); }
    std::vector<std::string> targets() const {
        std::vector<std::string> targets;
        for (const Request& each : server_.requests()) targets.push_back(each.target);
        return targets;
    }
    PictureSource& pictures() { return *pictures_; }

  private:
    ScriptedServer server_;
    std::unique_ptr<PictureSource> pictures_;
};

TEST(RenderedPictures, OrthancDrawsAnImageInTheMiddle) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    const dicom::test::TemporaryFolder folder;
    dicom::test::SyntheticSeries series;
    series.studyUid = "2.25.77";
    series.seriesUid = "2.25.771";
    series.size = {40, 30, 5};
    dicom::test::writeFiles(folder / "a", series);
    const Orthanc archive;
    sendFolder(folder / "a", archive.dicomPort(), archive.title());
    const auto pictures = picturesAt(archive.webUrl());
    Progress progress;
    for (int i = 0; i < 2; ++i) {
        const auto picture = pictures->pictureOf("2.25.77", seriesOf("2.25.771", 5), 72, progress);
        ASSERT_TRUE(picture) << picture.error().message;
        ASSERT_TRUE(*picture);
        EXPECT_EQ((*picture)->kind, EncodedPicture::Kind::jpeg);
        EXPECT_GT((*picture)->bytes.size(), 100u);
    }
    EXPECT_TRUE(pictures->isOffered());
    const auto none = pictures->pictureOf("2.25.77", seriesOf("2.25.9", 5), 72, progress);
    ASSERT_TRUE(none) << none.error().message;
    EXPECT_FALSE(*none) << "a series that is not there";
    EXPECT_TRUE(pictures->isOffered()) << "others have pictures";
}

TEST(RenderedPictures, ArchivesOfDimseHaveNone) {
    Source source;
    source.peer = DimsePeer{.host = "127.0.0.1", .port = 104, .calledAe = "ARCHIVE"};
    const auto pictures = picturesOf(source, {});
    ASSERT_TRUE(pictures);
    EXPECT_EQ(*pictures, nullptr);
}

TEST(RenderedPictures, AThumbnailOfTheSeriesIsTakenWhereThereIsOne) {
    PictureServer server([](const Request&, Peer& peer) { peer.answer(200, "image/png", kPng); });
    const auto picture = server.ask();
    ASSERT_TRUE(picture);
    ASSERT_TRUE(*picture);
    EXPECT_EQ((*picture)->kind, EncodedPicture::Kind::png);
    EXPECT_EQ((*picture)->bytes, kPng);
    ASSERT_EQ(server.targets().size(), 1u);
    EXPECT_TRUE(server.targets()[0].ends_with("/studies/1.2/series/1.3/thumbnail?viewport=72,72"));
}

TEST(RenderedPictures, WithoutThumbnailsAnInstanceIsRenderedAndTheyAreNotAskedForAgain) {
    PictureServer server([](const Request& request, Peer& peer) {
        if (isThumbnail(request)) return peer.answer(404, kJson, "{}");
        peer.answer(200, "image/jpeg", kJpeg);
    });
    for (int i = 0; i < 2; ++i) {
        const auto picture = server.ask();
        ASSERT_TRUE(picture);
        ASSERT_TRUE(*picture);
        EXPECT_EQ((*picture)->bytes, kJpeg);
    }
    const auto targets = server.targets();
    ASSERT_EQ(targets.size(), 5u);
    EXPECT_NE(targets[1].find("limit=1&offset=4"), std::string::npos) << "the middle of 9: " << targets[1];
    EXPECT_TRUE(targets[2].ends_with("/series/1.3/instances/1.4/rendered?viewport=72,72")) << targets[2];
    EXPECT_TRUE(targets[4].ends_with("/rendered?viewport=72,72")) << targets[4];
}

TEST(RenderedPictures, AnArchiveWithoutPicturesIsNotAskedAgain) {
    for (const int status : {404, 405, 406, 410, 501}) {
        PictureServer server([status](const Request&, Peer& peer) { peer.answer(status, kJson, "{}"); });
        const auto picture = server.ask();
        ASSERT_TRUE(picture) << status << " " << picture.error().message;
        EXPECT_FALSE(*picture) << status;
        EXPECT_FALSE(server.isOffered()) << status;
        const std::size_t asked = server.requests();
        EXPECT_FALSE(*server.ask()) << status;
        EXPECT_EQ(server.requests(), asked) << status;
    }
}

TEST(RenderedPictures, OtherRefusalsAreOfOneSeriesUntilThereAreMany) {
    PictureServer server([](const Request& request, Peer& peer) {
        peer.answer(isThumbnail(request) ? 404 : 400, kJson, "{}");
    });
    for (int i = 0; i < 2; ++i) {
        const auto picture = server.ask();
        ASSERT_TRUE(picture) << picture.error().message;
        EXPECT_FALSE(*picture);
        EXPECT_TRUE(server.isOffered());
    }
    EXPECT_FALSE(*server.ask());
    EXPECT_FALSE(server.isOffered());
}

TEST(RenderedPictures, WhatIsNoPictureIsNotTaken) {
    const std::vector<std::pair<std::string, std::string>> answers{
        {"text/html", "<html>"}, {"image/jpeg", kPng},       {"image/png", kJpeg},
        {"image/jpeg", ""},      {"image/svg+xml", "<svg>"}, {"application/dicom", kJpeg}};
    for (const auto& [type, body] : answers) {
        const std::string answeredType = type;
        const std::string answeredBody = body;
        PictureServer server(
            [=](const Request&, Peer& peer) { peer.answer(200, answeredType, answeredBody); });
        const auto picture = server.ask();
        ASSERT_TRUE(picture) << type << " " << picture.error().message;
        EXPECT_FALSE(*picture) << type;
    }
}

TEST(RenderedPictures, APictureWithoutEndIsCut) {
    std::mutex mutex;
    std::size_t sent = 0;
    PictureServer server([&](const Request&, Peer& peer) {
        const std::string piece(1 << 16, 'x');
        std::size_t written = 0;
        if (!peer.send("HTTP/1.1 200 OK\r\nContent-Type: image/jpeg\r\n\r\n" + kJpeg)) return;
        while (written < (std::size_t{64} << 20) && peer.send(piece)) written += piece.size();
        const std::lock_guard lock(mutex);
        sent = std::max(sent, written);
    });
    const auto picture = server.ask();
    ASSERT_TRUE(picture) << picture.error().message;
    EXPECT_FALSE(*picture);
    const std::lock_guard lock(mutex);
    EXPECT_LT(sent, std::size_t{32} << 20) << "it was read no further";
}

TEST(RenderedPictures, ASilentArchiveIsLeftWhenItIsCancelled) {
    PictureServer server([](const Request&, Peer& peer) { peer.waitUntilGone(); });
    const CancelToken cancel;
    std::thread later([&] {
        comes([&] { return server.requests() > 0; });
        cancel.cancel();
    });
    Progress progress({}, cancel);
    const auto picture = server.pictures().pictureOf("1.2", seriesOf("1.3"), 72, progress);
    later.join();
    ASSERT_FALSE(picture);
    EXPECT_EQ(picture.error().code, ErrorCode::cancelled);
    EXPECT_TRUE(server.isOffered());
}

TEST(RenderedPictures, AnIdentifierThatIsNoneIsNeverSent) {
    PictureServer server([](const Request&, Peer& peer) { peer.answer(200, "image/jpeg", kJpeg); });
    const auto picture = server.ask(seriesOf("../../secret"));
    ASSERT_TRUE(picture);
    EXPECT_FALSE(*picture);
    EXPECT_EQ(server.requests(), 0u);
}

}  // namespace
}  // namespace macula::net::test
