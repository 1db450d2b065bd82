// Presentation states in the window: written and read beside it, and whose they are to be.

#include "base/sha256.h"
#include "scene/choice/catalogue.h"
#include "scene/transfer/same_transfer.h"
#include "support.h"
#include "viewer/offscreen.h"
#include "viewer/output/presentations_controller.h"

namespace macula::viewer {
namespace {

class Presentations : public test::OffscreenTest {
  protected:
    void SetUp() override {
        OffscreenTest::SetUp();
        dicom::test::write(dicom::test::smallVolume(), folder_ / "study");
        scan_ = dicom::test::scan(folder_ / "study");
        ASSERT_TRUE(scan_);
        const dicom::Series& series = scan_->studies.at(0).series.at(0);
        digest_ = sha256Hex(series.seriesInstanceUid);
        request_.volume = dicom::test::load(series);
        request_.images = *scene::presentedImages(series, series.stacks.at(0));
        request_.state.preset = scene::builtInCatalogue()->presets.front();
        request_.state.camera = frameBox(request_.volume->worldBox(), ViewDirection::left, 30.0, 1.0);
        files_.emplace();
        QObject::connect(&*files_, &PresentationFiles::saved, &*files_,
                         [this](const QString& path, const QStringList&) { saved_ = path; });
        QObject::connect(&*files_, &PresentationFiles::opened, &*files_,
                         [this](const scene::StudyState& state, const QStringList&) { opened_ = state; });
        QObject::connect(&*files_, &PresentationFiles::failed, &*files_,
                         [this](const Error& error) { error_ = error; });
    }
    void TearDown() override {
        files_.reset();
        OffscreenTest::TearDown();
    }

    const dicom::test::TemporaryFolder folder_;
    const std::filesystem::path path_ = folder_ / "a.dcm";
    std::optional<dicom::Scan> scan_;
    std::string digest_;
    scene::PresentationRequest request_;
    std::optional<PresentationFiles> files_;
    QString saved_;
    std::optional<scene::StudyState> opened_;
    std::optional<Error> error_;
};

TEST_F(Presentations, AreSavedAndOpenedBesideTheWindow) {
    files_->save(path_, request_);
    ASSERT_TRUE(waitUntil([&] { return !saved_.isEmpty() || error_; }));
    ASSERT_FALSE(error_) << error_->message;
    EXPECT_EQ(saved_.toStdString(), path_.string());
    files_->open(path_, request_.volume, digest_, {}, {});
    ASSERT_TRUE(waitUntil([&] { return opened_ || error_; }));
    ASSERT_FALSE(error_) << error_->message;
    EXPECT_EQ(opened_->camera, request_.state.camera);
    EXPECT_EQ(opened_->seriesDigest, digest_);
    ASSERT_TRUE(opened_->preset);
    EXPECT_TRUE(scene::isSame(*opened_->preset, *request_.state.preset));
}

TEST_F(Presentations, ThatCannotBeAreErrors) {
    files_->open(path_, request_.volume, digest_, {}, {});
    ASSERT_TRUE(waitUntil([&] { return error_.has_value(); }));
    EXPECT_EQ(error_->code, ErrorCode::inputNotUsable);
    error_.reset();
    files_->save(folder_ / "gone" / "a.dcm", request_);
    ASSERT_TRUE(waitUntil([&] { return error_.has_value(); }));
    EXPECT_EQ(error_->code, ErrorCode::outputNotWritable);
    error_.reset();
    request_.state.preset.reset();
    files_->save(path_, request_);
    ASSERT_TRUE(waitUntil([&] { return error_.has_value(); }));
    EXPECT_FALSE(std::filesystem::exists(path_));
    EXPECT_FALSE(opened_);
}

TEST_F(Presentations, BelongToThePatientUnlessSomebodySaysNot) {
    PresentationDialog dialog;
    EXPECT_FALSE(dialog.isDeidentified());
    auto* box = dialog.findChild<QCheckBox*>(QStringLiteral("without-patient"));
    ASSERT_NE(box, nullptr);
    EXPECT_FALSE(box->accessibleName().isEmpty());
    EXPECT_FALSE(box->toolTip().isEmpty());
    box->click();
    EXPECT_TRUE(dialog.isDeidentified());
}

}  // namespace
}  // namespace macula::viewer
