// Documents in the window: read, followed to the images that they name, and their measurements taken over.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QClipboard>
#include <QDesktopServices>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QTextBrowser>
#include <QTreeView>
#include <QUrl>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include "dicom/support.h"
#include "dicom/synthetic.h"
#include "viewer/browser/study_browser.h"
#include "viewer/documents/document_dialog.h"
#include "viewer/documents/documents_controller.h"
#include "viewer/planar/planar_controller.h"
#include "viewer/window_fixture.h"

namespace macula::viewer {
namespace {

using dicom::test::appended;
using dicom::test::nested;
using dicom::test::put;

// Catches what would be opened in another program.
class Opened : public QTextBrowser {
  public:
    Opened() { QDesktopServices::setUrlHandler(QStringLiteral("file"), this, "setSource"); }
    ~Opened() override { QDesktopServices::unsetUrlHandler(QStringLiteral("file")); }
    QList<QUrl> urls;

  protected:
    void doSetSource(const QUrl& url, QTextDocument::ResourceType) override { urls.append(url); }
};

class DocumentsWindowTest : public WindowTest {
  protected:
    DocumentsWindowTest() { layout_ = scene::Layout::fourPanes; }

    // A CT of 8 x 7 x 12 voxels with a selection of key images, a report and a PDF.
    void writeStudy() {
        series_.size = {8, 7, 12};
        slices_ = dicom::test::slicesOf(series_);
        dicom::test::writeFiles(folder_ / "study", series_, slices_);
        writeKeyImages();
        writeReport();
        dicom::test::Shell pdf{.sopClassUid = UID_EncapsulatedPDFStorage,
                               .modality = "DOC",
                               .sopInstanceUid = "2.25.3100",
                               .seriesUid = "2.25.3101"};
        pdf.edits.push_back([this](DcmItem& root) {
            own(root);
            put(root, DCM_DocumentTitle, "Letter");
            put(root, DCM_MIMETypeOfEncapsulatedDocument, "application/pdf");
            const std::string bytes = "%PDF-1.4 letter!";
            root.putAndInsertUint8Array(DCM_EncapsulatedDocument,
                                        reinterpret_cast<const Uint8*>(bytes.data()), bytes.size());
        });
        dicom::test::writeShell(folder_ / "study/pdf.dcm", pdf);
    }
    void own(DcmItem& root) const {
        put(root, DCM_PatientName, series_.patientName);
        put(root, DCM_PatientID, series_.patientId);
        put(root, DCM_StudyInstanceUID, series_.studyUid);
    }
    static void refer(DcmItem& item, const std::string& uid) {
        DcmItem& sop = nested(item, DCM_ReferencedSOPSequence);
        put(sop, DCM_ReferencedSOPClassUID, UID_CTImageStorage);
        put(sop, DCM_ReferencedSOPInstanceUID, uid);
    }
    void writeKeyImages() {
        dicom::test::Shell keys{.sopClassUid = UID_KeyObjectSelectionDocumentStorage,
                                .modality = "KO",
                                .sopInstanceUid = "2.25.3200",
                                .seriesUid = "2.25.3201"};
        keys.edits.push_back([this](DcmItem& root) {
            own(root);
            put(root, DCM_ValueType, "CONTAINER");
            put(nested(root, DCM_ConceptNameCodeSequence), DCM_CodeMeaning, "Of Interest");
            for (const std::string& uid :
                 {slices_[2].sopInstanceUid, std::string("2.25.404"), slices_[9].sopInstanceUid}) {
                DcmItem& image = appended(root, DCM_ContentSequence);
                put(image, DCM_RelationshipType, "CONTAINS");
                put(image, DCM_ValueType, "IMAGE");
                refer(image, uid);
            }
        });
        dicom::test::writeShell(folder_ / "study/keys.dcm", keys);
    }
    void writeReport() {
        dicom::test::Shell report{.sopClassUid = UID_ComprehensiveSRStorage,
                                  .modality = "SR",
                                  .sopInstanceUid = "2.25.3300",
                                  .seriesUid = "2.25.3301"};
        report.edits.push_back([this](DcmItem& root) {
            own(root);
            put(root, DCM_ValueType, "CONTAINER");
            put(root, DCM_CompletionFlag, "COMPLETE");
            put(root, DCM_VerificationFlag, "UNVERIFIED");
            put(nested(root, DCM_ConceptNameCodeSequence), DCM_CodeMeaning, "Chest <b>report</b>");
            DcmItem& text = appended(root, DCM_ContentSequence);
            put(text, DCM_ValueType, "TEXT");
            put(text, DCM_TextValue, "<img src=\"file:///etc/passwd\"> nodule");
            DcmItem& points = appended(root, DCM_ContentSequence);
            put(points, DCM_ValueType, "SCOORD");
            put(points, DCM_GraphicType, "POLYLINE");
            const std::array<Float32, 4> px{1.5F, 2.5F, 4.5F, 2.5F};
            points.putAndInsertFloat32Array(DCM_GraphicData, px.data(), px.size());
            DcmItem& image = appended(points, DCM_ContentSequence);
            put(image, DCM_RelationshipType, "SELECTED FROM");
            put(image, DCM_ValueType, "IMAGE");
            refer(image, slices_[4].sopInstanceUid);
        });
        dicom::test::writeShell(folder_ / "study/report.dcm", report);
    }
    void openStudy() {
        writeStudy();
        window_->open(folder_ / "study");
        ASSERT_TRUE(waitUntil([this] { return window_->hasStudy() && !window_->loading(); }));
    }
    // With Enter on its row of the list.
    void openRow(const QString& title) {
        auto* tree = window_->findChild<QTreeView*>(QStringLiteral("studies"));
        ASSERT_NE(tree, nullptr);
        tree->expandAll();
        for (QModelIndex index = tree->model()->index(0, 0); index.isValid();
             index = tree->indexBelow(index)) {
            const QString words = index.data(Qt::UserRole).toStringList().join(QLatin1Char(' '));
            if (!words.contains(title) || words.contains(QStringLiteral("key image"))) continue;
            tree->setCurrentIndex(index);
            QKeyEvent enter(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier);
            QApplication::sendEvent(tree, &enter);
            ASSERT_TRUE(waitUntil([this] { return dialog().isVisible(); }));
            return;
        }
        FAIL() << "there is no row of " << title.toStdString();
    }
    DocumentDialog& dialog() { return window_->documents().dialog(); }
    QString label(const char* name) { return dialog().findChild<QLabel*>(QLatin1String(name))->text(); }
    void click(const char* name) {
        auto* button = dialog().findChild<QAbstractButton*>(QLatin1String(name));
        ASSERT_NE(button, nullptr) << name;
        ASSERT_TRUE(button->isVisible()) << name;
        button->click();
    }
    int sliceOfCrosshair() {
        const auto& mm = window_->session().state().slices.crosshairMm;
        if (!mm) return -1;
        const Volume& volume = *window_->session().study().volume;
        return int(std::lround(transformPoint(glm::inverse(volume.worldFromVoxel()), *mm).z));
    }

    dicom::test::TemporaryFolder folder_;
    dicom::test::SyntheticSeries series_;
    std::vector<dicom::test::Slice> slices_;
};

TEST_F(DocumentsWindowTest, KeyImagesAreWalkedThrough) {
    openStudy();
    openRow(QStringLiteral("Of Interest"));
    EXPECT_TRUE(label("document-patient").contains(QStringLiteral("SYNTHETIC")));
    EXPECT_TRUE(label("document-title").contains(QStringLiteral("Of Interest")));
    auto* list = dialog().findChild<QListWidget*>(QStringLiteral("document-images"));
    ASSERT_EQ(list->count(), 3);
    EXPECT_EQ(list->item(1)->text(), QStringLiteral("not in this folder"));
    click("document-next");
    EXPECT_EQ(sliceOfCrosshair(), 2);
    EXPECT_EQ(list->currentRow(), 0);
    click("document-next");
    EXPECT_EQ(sliceOfCrosshair(), 9) << "the one that is not there is passed over";
    EXPECT_EQ(list->currentRow(), 2);
    click("document-next");
    EXPECT_EQ(sliceOfCrosshair(), 9);
    click("document-previous");
    EXPECT_EQ(sliceOfCrosshair(), 2);
    QKeyEvent escape(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
    QApplication::sendEvent(&dialog(), &escape);
    EXPECT_FALSE(dialog().isVisible());
}

// In the list of studies the series is marked; a key of the window goes from one to the next.
TEST_F(DocumentsWindowTest, KeyImagesAreMarkedInTheListAndSteppedThrough) {
    openStudy();
    auto* tree = window_->findChild<QTreeView*>(QStringLiteral("studies"));
    tree->expandAll();
    const auto isMarked = [&] {
        for (QModelIndex index = tree->model()->index(0, 0); index.isValid(); index = tree->indexBelow(index))
            if (index.data(Qt::UserRole)
                    .toStringList()
                    .join(QLatin1Char(' '))
                    .contains(QStringLiteral("2 key images: Of Interest")))
                return true;
        return false;
    };
    ASSERT_TRUE(waitUntil(isMarked));
    auto* next = window_->findChild<QAction*>(QStringLiteral("next-key-image"));
    auto* previous = window_->findChild<QAction*>(QStringLiteral("previous-key-image"));
    ASSERT_TRUE(next->isEnabled());
    EXPECT_EQ(next->shortcut(), QKeySequence(QStringLiteral("Ctrl+Shift+K")));
    next->trigger();
    EXPECT_EQ(sliceOfCrosshair(), 2);
    EXPECT_TRUE(window_->message().contains(QStringLiteral("Key image 1 of 2")))
        << window_->message().toStdString();
    next->trigger();
    EXPECT_EQ(sliceOfCrosshair(), 9);
    next->trigger();
    EXPECT_EQ(sliceOfCrosshair(), 2) << "and begins again";
    previous->trigger();
    EXPECT_EQ(sliceOfCrosshair(), 9);
    window_->open(std::nullopt);
    ASSERT_TRUE(waitUntil([&] { return !next->isEnabled(); })) << "the phantom has none";
}

TEST_F(DocumentsWindowTest, AReportIsReadAsPlainTextAndFollowed) {
    openStudy();
    openRow(QStringLiteral("report"));
    EXPECT_TRUE(label("document-status").contains(QStringLiteral("Not verified")));
    auto* text = dialog().findChild<QTextBrowser*>(QStringLiteral("document-text"));
    EXPECT_TRUE(text->toPlainText().contains(QStringLiteral("<img src=\"file:///etc/passwd\"> nodule")));
    Q_EMIT text->anchorClicked(QUrl(QStringLiteral("#0")));
    EXPECT_EQ(sliceOfCrosshair(), 4);
    Q_EMIT text->anchorClicked(QUrl(QStringLiteral("https://example.org/#7")));
    EXPECT_EQ(sliceOfCrosshair(), 4);
    click("document-copy");
    EXPECT_TRUE(QApplication::clipboard()->text().contains(QStringLiteral("SYNTHETIC")));
    // Measurements: one step back takes them away.
    click("document-measurements");
    ASSERT_EQ(window_->session().state().measurements.size(), 1u);
    const auto& distance = std::get<slices::Distance>(window_->session().state().measurements.front().shape);
    EXPECT_NEAR(slices::lengthMm(distance), 3.0 * slices_[4].columnSpacingMm, 1e-3);
    EXPECT_TRUE(window_->message().contains(QStringLiteral("taken over")))
        << window_->message().toStdString();
    click("document-measurements");
    EXPECT_EQ(window_->session().state().measurements.size(), 1u);
    window_->session().undo();
    EXPECT_TRUE(window_->session().state().measurements.empty());
}

TEST_F(DocumentsWindowTest, APdfGoesToAnotherProgramAfterAQuestion) {
    openStudy();
    Opened opened;
    openRow(QStringLiteral("Letter"));
    click("document-open-file");
    EXPECT_TRUE(opened.urls.isEmpty());
    auto* question = dialog().findChild<QMessageBox*>(QStringLiteral("open-file-question"));
    ASSERT_NE(question, nullptr);
    EXPECT_TRUE(question->text().contains(QStringLiteral("SYNTHETIC"))) << "whose it is";
    for (QAbstractButton* button : question->buttons())
        if (question->buttonRole(button) == QMessageBox::AcceptRole) button->click();
    ASSERT_EQ(opened.urls.size(), 1);
    QFile file(opened.urls.front().toLocalFile());
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_EQ(file.readAll(), QByteArray("%PDF-1.4 letter!"));
    EXPECT_FALSE(file.permissions() & (QFile::ReadGroup | QFile::ReadOther));
    EXPECT_FALSE(opened.urls.front().toString().contains(QStringLiteral("SYNTHETIC")));
    click("document-open-file");
    EXPECT_EQ(opened.urls.size(), 2) << "asked once";
    window_.reset();
    EXPECT_FALSE(QFile::exists(file.fileName())) << "removed at the end";
}

TEST_F(DocumentsWindowTest, WithoutNamesNoDocumentIsShown) {
    openStudy();
    openRow(QStringLiteral("report"));
    window_->findChild<QAction*>(QStringLiteral("names"))->trigger();
    EXPECT_FALSE(dialog().isVisible());
    EXPECT_FALSE(label("document-patient").contains(QStringLiteral("SYNTHETIC")));
    window_->documents().open(nullptr, {folder_ / "study/report.dcm", 0});
    EXPECT_TRUE(window_->message().contains(QStringLiteral("hidden")));
    EXPECT_FALSE(dialog().isVisible());
}

TEST_F(DocumentsWindowTest, AFolderOfOneReportShowsIt) {
    series_.size = {8, 7, 12};
    slices_ = dicom::test::slicesOf(series_);
    std::filesystem::create_directories(folder_ / "study");
    writeReport();
    window_->open(folder_ / "study");
    ASSERT_TRUE(waitUntil([this] { return dialog().isVisible(); }));
    EXPECT_TRUE(label("document-title").contains(QStringLiteral("Chest")));
}

}  // namespace
}  // namespace macula::viewer
