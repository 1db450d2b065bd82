// The series of the selected study and how they look, from an archive whose answers a test writes.
#include "viewer/archive/series_pictures.h"

#include <gtest/gtest.h>

#include <QBuffer>
#include <QListWidget>
#include <QScrollBar>
#include <algorithm>
#include <atomic>
#include <mutex>
#include <optional>
#include <set>
#include <string>

#include "dicom/support.h"
#include "net/scripted_server.h"
#include "viewer/archive/series_strip.h"
#include "viewer/offscreen.h"

namespace macula::viewer {
namespace {

using net::test::ScriptedServer;
using Request = ScriptedServer::Request;
using Peer = ScriptedServer::Peer;

constexpr const char* kJson = "application/dicom+json";

std::string jpeg() {
    QImage image(40, 20, QImage::Format_RGB32);
    image.fill(Qt::gray);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "jpeg");
    return bytes.toStdString();
}

std::string seriesJson(const std::string& uid, const std::string& modality) {
    return R"({"0020000E":{"vr":"UI","Value":[")" + uid + R"("]},"00080060":{"vr":"CS","Value":[")" +
           modality + R"("]},"0008103E":{"vr":"LO","Value":["Thorax of Meier"]},)" +
           R"("00201209":{"vr":"IS","Value":[7]}})";
}

study::ListedStudy listed(const std::string& uid) {
    study::ListedStudy study;
    study.study.studyInstanceUid = uid;
    study.archive = "Hospital";
    return study;
}

// An archive with many series of each study, the last of which is a report.
class SeriesPicturesTest : public test::OffscreenTest {
  protected:
    static constexpr int kSeries = 40;

    void SetUp() override {
        OffscreenTest::SetUp();
        picture_ = jpeg();
        server_.emplace([this](const Request& request, Peer& peer) { answer(request, peer); });
        auto sources =
            net::SourceList::read({folder_ / "none", folder_ / "own.json", folder_ / "secrets.json"});
        ASSERT_TRUE(sources);
        sources_.emplace(*std::move(sources));
        net::Source source;
        source.name = "Hospital";
        net::WebPeer peer;
        peer.url = server_->url();
        source.peer = peer;
        ASSERT_TRUE(sources_->put(source));
        strip_.emplace();
        pictures_.emplace(*strip_, nullptr);
        window_.emplace();
        strip_->setParent(&*window_);
        window_->resize(360, 160);
        strip_->resize(360, 160);
        window_->show();
    }
    void TearDown() override {
        pictures_.reset();
        strip_->setParent(nullptr);
        strip_.reset();
        window_.reset();
        server_.reset();
        OffscreenTest::TearDown();
    }

    void answer(const Request& request, Peer& peer) {
        const bool isPicture = request.target.find("/thumbnail") != std::string::npos ||
                               request.target.find("/rendered") != std::string::npos;
        if (isPicture) {
            const std::size_t now = ++atOnce_;
            mostAtOnce_ = std::max(mostAtOnce_.load(), now);
            note(request.target);
            if (isSilent_)
                peer.waitUntilGone();
            else
                peer.answer(status_, status_ == 200 ? "image/jpeg" : kJson, status_ == 200 ? picture_ : "{}");
            --atOnce_;
            return;
        }
        if (request.target.find("/instances?") != std::string::npos)
            return peer.answer(200, kJson, R"([{"00080018":{"vr":"UI","Value":["1.4"]}}])");
        std::string all;
        for (int i = 1; i <= kSeries; ++i)
            all += seriesJson("1.3." + std::to_string(i), i == kSeries ? "SR" : "CT") +
                   (i == kSeries ? "" : ",");
        const bool isFirst = request.target.find("offset=0") != std::string::npos;
        peer.answer(200, kJson, isFirst ? "[" + all + "]" : "[]");
    }
    void note(const std::string& target) {
        const std::lock_guard lock(mutex_);
        asked_.push_back(target);
    }
    std::vector<std::string> asked() {
        const std::lock_guard lock(mutex_);
        return asked_;
    }
    QListWidget& list() { return *strip_->findChild<QListWidget*>(QStringLiteral("archive-series")); }
    std::size_t withPictures() {
        std::size_t count = 0;
        for (int i = 0; i < list().count(); ++i) count += list().item(i)->icon().isNull() ? 0 : 1;
        return count;
    }

    dicom::test::TemporaryFolder folder_;
    std::string picture_;
    std::atomic<int> status_{200};
    std::atomic<bool> isSilent_{false};
    std::atomic<std::size_t> atOnce_{0};
    std::atomic<std::size_t> mostAtOnce_{0};
    std::mutex mutex_;
    std::vector<std::string> asked_;
    std::optional<ScriptedServer> server_;
    std::optional<net::SourceList> sources_;
    std::optional<QWidget> window_;
    std::optional<SeriesStrip> strip_;
    std::optional<SeriesPictures> pictures_;
};

TEST_F(SeriesPicturesTest, ThoseInViewAreAskedForOnceAndFewAtATime) {
    EXPECT_TRUE(strip_->isHidden());
    pictures_->select(listed("1.2"), *sources_);
    ASSERT_TRUE(
        waitUntil([&] { return !strip_->inView().empty() && withPictures() >= strip_->inView().size(); }));
    EXPECT_EQ(list().count(), kSeries - 1) << "a report has no picture";
    const std::size_t inView = strip_->inView().size();
    EXPECT_LT(inView, 8u);
    EXPECT_EQ(asked().size(), inView);
    EXPECT_LE(mostAtOnce_, 2u);
    EXPECT_TRUE(list().item(0)->text().contains(QStringLiteral("Meier")));
    EXPECT_TRUE(list().item(0)->text().contains(QStringLiteral("7 images")));
    strip_->showNames(false);
    EXPECT_FALSE(list().item(0)->text().contains(QStringLiteral("Meier")));

    list().horizontalScrollBar()->setValue(list().horizontalScrollBar()->maximum());
    const auto areAllInViewDrawn = [&] {
        return std::ranges::none_of(strip_->inView(),
                                    [&](std::size_t i) { return list().item(int(i))->icon().isNull(); });
    };
    ASSERT_TRUE(waitUntil([&] {
        return !list().item(kSeries - 2)->icon().isNull() && areAllInViewDrawn() &&
               withPictures() == asked().size();
    }));
    EXPECT_LT(asked().size(), 16u);

    const std::size_t before = asked().size();
    pictures_->select({}, *sources_);
    EXPECT_TRUE(strip_->isHidden());
    pictures_->select(listed("1.2"), *sources_);
    ASSERT_TRUE(waitUntil([&] { return withPictures() > 0; }));
    EXPECT_EQ(asked().size(), before) << "they are still known";
    const auto all = asked();
    EXPECT_EQ(std::set<std::string>(all.begin(), all.end()).size(), all.size());
}

TEST_F(SeriesPicturesTest, AnotherSelectionCancelsWhatWasAsked) {
    isSilent_ = true;
    pictures_->select(listed("1.2"), *sources_);
    ASSERT_TRUE(waitUntil([&] { return atOnce_ == 2; }));
    pictures_->select({}, *sources_);
    ASSERT_TRUE(waitUntil([&] { return atOnce_ == 0; })) << "the connections were closed";
    isSilent_ = false;
    pictures_->select(listed("1.5"), *sources_);
    ASSERT_TRUE(waitUntil([&] { return withPictures() > 0; }));
    EXPECT_NE(asked().back().find("/studies/1.5/"), std::string::npos) << asked().back();
}

TEST_F(SeriesPicturesTest, AnArchiveWithoutPicturesIsAskedOnceInASession) {
    status_ = 404;
    pictures_->select(listed("1.2"), *sources_);
    ASSERT_TRUE(waitUntil([&] { return !asked().empty() && strip_->isHidden(); }));
    pictures_->select(listed("1.5"), *sources_);
    for (int i = 0; i < 60; ++i) {
        QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
        QThread::msleep(10);
    }
    EXPECT_TRUE(strip_->isHidden());
    for (const Request& each : server_->requests())
        EXPECT_EQ(each.target.find("/studies/1.5"), std::string::npos) << each.target;
}

TEST_F(SeriesPicturesTest, ABrokenPictureLeavesTheWordsAlone) {
    picture_ = "\xff\xd8\xff broken";
    pictures_->select(listed("1.2"), *sources_);
    ASSERT_TRUE(waitUntil([&] { return !asked().empty() && asked().size() >= strip_->inView().size(); }));
    ASSERT_TRUE(waitUntil([&] { return atOnce_ == 0; }));
    settle();
    EXPECT_FALSE(strip_->isHidden());
    EXPECT_EQ(withPictures(), 0u);
    EXPECT_FALSE(list().item(0)->text().isEmpty());
}

}  // namespace
}  // namespace macula::viewer
