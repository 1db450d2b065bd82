#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/documents/documents_controller.h"

#include <QDesktopServices>
#include <QMainWindow>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QUrl>
#include <algorithm>
#include <utility>

#include "base/atomic_file.h"
#include "base/frames.h"
#include "dicom/documents/document_text.h"
#include "dicom/documents/read_document.h"
#include "scene/slices/measurements_of_report.h"
#include "study/open/slice_images.h"
#include "unpack/archive_name.h"
#include "viewer/browser/study_browser.h"
#include "viewer/documents/document_dialog.h"
#include "viewer/editor/study_editor.h"
#include "viewer/language/harmless_text.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/planar/planar_controller.h"
#include "viewer/settings/file_dialogs.h"
#include "viewer/status/notifications.h"
#include "viewer/volume/opening_controller.h"

namespace macula::viewer {

namespace {

constexpr std::size_t kMostReferences = 10'000;

// What the file of a document is called when a person saves it; names of files name no patient.
std::pair<QString, QString> suffixAndFilter(const dicom::StudyDocument& document) {
    const std::string mime = document.contents ? document.contents->mimeType : std::string();
    if (mime == "application/pdf")
        return {QStringLiteral("pdf"), DocumentsController::tr("PDF files (*.pdf)")};
    if (mime == "text/xml" || mime == "application/xml")
        return {QStringLiteral("xml"), DocumentsController::tr("XML files (*.xml)")};
    if (mime == "model/stl") return {QStringLiteral("stl"), DocumentsController::tr("STL files (*.stl)")};
    return {QStringLiteral("bin"), DocumentsController::tr("All files (*)")};
}

}  // namespace

DocumentsController::DocumentsController(const WindowContext& context, const Uses& uses)
    : QObject(&context.window),
      context_(context),
      uses_(uses),
      dialog_(new DocumentDialog(&context.window)),
      reading_(this, {.ended = [this](const Result<Read>& read) { show(read); }}) {
    connect(&uses_.browser, &StudyBrowser::documentChosen, this,
            [this](const study::StudyRow::Document& chosen) { open(uses_.browser.found(), chosen); });
    const StudyLoader& loader = uses_.opening.loader();
    connect(&loader, &StudyLoader::began, this, [this] { awaiting_.reset(); });
    connect(&loader, &StudyLoader::cancelled, this, [this] { awaiting_.reset(); });
    connect(&loader, &StudyLoader::failed, this, [this] { awaiting_.reset(); });
    connectDialog();
}

void DocumentsController::connectDialog() {
    connect(dialog_, &DocumentDialog::imageAsked, this, &DocumentsController::goToReference);
    connect(dialog_, &DocumentDialog::fileOpenAsked, this, &DocumentsController::askToOpenFile);
    connect(dialog_, &DocumentDialog::fileSaveAsked, this, &DocumentsController::saveFile);
    connect(dialog_, &DocumentDialog::textSaveAsked, this, &DocumentsController::saveText);
    connect(dialog_, &DocumentDialog::measurementsAsked, this, &DocumentsController::takeMeasurements);
}

void DocumentsController::addAction(QMenu& file) {
    QAction* open = file.addAction(tr("Open Doc&ument…"), this, &DocumentsController::askForOne);
    describe(*open, "open-document",
             tr("Read a report, a radiotherapy plan, a selection of key images or a PDF in DICOM"));
}

void DocumentsController::askForOne() {
    auto* dialog = context_.files.toOpen(FolderKind::studies, tr("Open a document"));
    context_.files.ask(dialog, FolderKind::studies, [this](const QString& path) {
        open(nullptr, {path.toStdString(), 0});
    });
}

void DocumentsController::open(std::shared_ptr<const study::FoundVolumes> found,
                               const study::StudyRow::Document& document) {
    if (!namesShown_)
        return context_.notifications.refuse(
            tr("Patients' names are hidden, and a document may name the patient anywhere."),
            tr("Show the names first: View, Patient and study over the picture."));
    context_.viewport.window().endDrag();
    reading_.start([file = document.file, found = std::move(found),
                    patient = document.patient](Progress&) -> Result<Read> {
        Result<dicom::StudyDocument> made = dicom::readDocument(file);
        if (!made) return made.error();
        return Read{*std::move(made), found, patient};
    });
}

bool DocumentsController::openInstead(const std::shared_ptr<const study::FoundVolumes>& found,
                                      const std::filesystem::path& source) {
    std::vector<study::StudyRow::Document> documents;
    std::error_code error;
    for (const dicom::Study& study : found->scan().studies) {
        for (const dicom::Series& series : study.series) {
            for (const dicom::OtherObject& object : series.objects) {
                if (!dicom::isDocument(object.sopClassUid)) continue;
                documents.push_back({object.file, study.patient});
                if (std::filesystem::equivalent(object.file, source, error)) {
                    open(found, documents.back());
                    return true;
                }
            }
        }
    }
    const bool isOnlyOne = documents.size() == 1 && found->scan().imageCount() == 0 &&
                           (std::filesystem::is_directory(source, error) || unpack::isArchive(source));
    if (isOnlyOne) open(found, documents.front());
    return isOnlyOne;
}

void DocumentsController::show(const Result<Read>& read) {
    if (!read) return context_.notifications.failUnlessCancelled(read.error());
    const dicom::StudyDocument* document = &read->document;
    found_ = read->found;
    patient_ = read->patient;
    awaiting_.reset();
    places_.clear();
    QStringList images;
    if (found_) {
        const study::ImagePlaces places(*found_, patient_);
        for (const dicom::DocumentReference& each : document->references()) {
            places_.push_back(places_.size() < kMostReferences ? places.of(each) : std::nullopt);
            images += places_.back() ? inWindowsLanguage(nameOf(*places_.back())) : QString();
        }
    }
    dialog_->setDocument(*document, images);
    dialog_->show();
    dialog_->raise();
    dialog_->activateWindow();
    Q_EMIT shown();
}

void DocumentsController::showNames(bool shown) {
    namesShown_ = shown;
    if (shown) return;
    reading_.cancel();
    dialog_->close();
    dialog_->setDocument({}, {});
}

void DocumentsController::goToReference(int place) {
    const auto at = std::size_t(place);
    if (at >= places_.size() || !places_[at])
        return context_.notifications.refuse(tr("That image is not in the open folder."),
                                             tr("Open the folder that it is in."));
    dialog_->setImage(place);
    goTo(found_, *places_[at]);
}

void DocumentsController::goTo(const std::shared_ptr<const study::FoundVolumes>& found,
                               const study::ImagePlace& to) {
    if (!to.volume) {
        if (uses_.images.stack() != to.stack) uses_.images.show(found, to.stack);
        return uses_.images.setPlace(to.frame);
    }
    const study::OpenedStudy& open = context_.session.study();
    if (open.found == found && open.volumeIndex == *to.volume && !uses_.opening.loader().loading())
        return goToSlice(to);
    uses_.opening.openFound(found, *to.volume);
    awaiting_ = to;
    awaitedIn_ = found;
}

void DocumentsController::onStudyShown() {
    const auto awaited = std::exchange(awaiting_, {});
    const auto found = std::exchange(awaitedIn_, nullptr);
    if (!awaited) return;
    const study::OpenedStudy& open = context_.session.study();
    if (open.found == found && awaited->volume && open.volumeIndex == *awaited->volume) goToSlice(*awaited);
}

// The cross-hair stays where it is in the plane of the image.
void DocumentsController::goToSlice(const study::ImagePlace& place) {
    const study::OpenedStudy& open = context_.session.study();
    const Volume& volume = *open.volume;
    const std::vector<study::SliceImage> slices = study::imagesOfSlices(volume, *place.stack);
    const dicom::Frame* wanted = &place.stack->frames[place.frame];
    const auto found = std::ranges::find(slices, wanted, &study::SliceImage::frame);
    if (found == slices.end())
        return context_.notifications.refuse(tr("That image is not in the open volume."),
                                             tr("It could not be read, or was left out."));
    uses_.images.close();
    const glm::dvec3 middle = 0.5 * (glm::dvec3(volume.size()) - 1.0);
    const auto& set = context_.session.state().slices.crosshairMm;
    glm::dvec3 voxel = set ? transformPoint(glm::inverse(volume.worldFromVoxel()), *set) : middle;
    voxel.z = double(found - slices.begin());
    const glm::dvec3 to = transformPoint(volume.worldFromVoxel(), voxel);
    context_.session.change(tr("Cross-hair"), [&](scene::StudyState& next) {
        next.slices.crosshairMm = to;
        // The image itself is to be seen, and not a plane through it.
        next.slices.turn.reset();
        next.slices.asAcquired = true;
        next.slices.slab = {};
        next.layout = scene::Layout::fourPanes;
    });
}

void DocumentsController::askToOpenFile() {
    const dicom::StudyDocument& document = dialog_->document();
    if (confirmed_.contains(document.file)) return openFile(document.file);
    auto* box =
        new QMessageBox(QMessageBox::Question, tr("Open the PDF?"),
                        tr("Show this PDF in another program of this computer?") + QStringLiteral("\n\n") +
                            harmless(inWindowsLanguage(patientLineOf(document))),
                        QMessageBox::Cancel, dialog_);
    box->setObjectName(QStringLiteral("open-file-question"));
    box->setTextFormat(Qt::PlainText);
    box->setInformativeText(
        tr("Macula puts it into a private file, which it removes when it ends. The other program may keep a "
           "copy, or its name in a list."));
    box->setAttribute(Qt::WA_DeleteOnClose);
    QPushButton* yes = box->addButton(tr("&Open"), QMessageBox::AcceptRole);
    // The file that was asked about, even if another document is on screen by then.
    connect(yes, &QPushButton::clicked, this, [this, file = document.file] {
        confirmed_.insert(file);
        openFile(file);
    });
    box->open();
}

void DocumentsController::openFile(const std::filesystem::path& file) {
    const Result<std::string> bytes = dicom::readEncapsulatedFile(file);
    if (!bytes) return context_.notifications.fail(bytes.error());
    // A program that is called for a PDF gets nothing else.
    if (!dicom::beginsAsPdf(*bytes))
        return context_.notifications.refuse(tr("The file of this document is no PDF, and is not opened."),
                                             tr("Save it, and look at it with care."));
    const Result<QString> path = files_.write(*bytes, QStringLiteral("pdf"));
    if (!path) return context_.notifications.fail(path.error());
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(*path)))
        context_.notifications.refuse(tr("This computer has no program that shows PDF files."),
                                      tr("Save the PDF, and open it on another computer."));
}

void DocumentsController::saveFile() {
    const auto [suffix, filter] = suffixAndFilter(dialog_->document());
    auto* dialog = context_.files.toSave(FolderKind::studies, tr("Save the file of the document"), filter,
                                         suffix, QStringLiteral("document.") + suffix);
    context_.files.ask(dialog, FolderKind::studies,
                       [this, file = dialog_->document().file](const QString& path) {
                           const Result<std::string> bytes = dicom::readEncapsulatedFile(file);
                           if (!bytes) return context_.notifications.fail(bytes.error());
                           context_.notifications.showOutcome(writeTextAtomically(path.toStdString(), *bytes),
                                                              tr("The file is written to %1.").arg(path));
                       });
}

void DocumentsController::saveText() {
    auto* dialog = context_.files.toSave(FolderKind::studies, tr("Save the text of the document"),
                                         tr("Text files (*.txt)"), QStringLiteral("txt"),
                                         QStringLiteral("document.txt"));
    context_.files.ask(dialog, FolderKind::studies, [this, text = dialog_->text()](const QString& path) {
        context_.notifications.showOutcome(writeTextAtomically(path.toStdString(), text.toStdString()),
                                           tr("The text is written to %1.").arg(path));
    });
}

void DocumentsController::takeMeasurements() {
    const study::OpenedStudy& open = context_.session.study();
    if (!open.volume || !open.found)
        return context_.notifications.refuse(
            tr("No series of DICOM images is open to take measurements onto."),
            tr("Open the series that the report is about."));
    const study::FoundVolume& of = open.found->volumes().at(open.volumeIndex);
    const auto made = scene::measurementsOf(dialog_->document(), {*of.series, *of.stack},
                                            context_.session.state().measurements);
    if (!made) return context_.notifications.showError(made.error());
    context_.session.change(tr("Measurements of a report"), [&](scene::StudyState& next) {
        next.measurements.insert(next.measurements.end(), made->taken.begin(), made->taken.end());
    });
    context_.notifications.showDone(
        tr("%n measurements were taken over from the report.", nullptr, int(made->taken.size())),
        inWindowsLanguage(made->leftOut));
}

}  // namespace macula::viewer
