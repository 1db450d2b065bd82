// Documents of a study: read beside the images, and followed to those that they name.
#pragma once

#include <QObject>
#include <QString>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "dicom/documents/document.h"
#include "study/documents/image_places.h"
#include "study/list/study_tree.h"
#include "study/open/found_volumes.h"
#include "viewer/context/window_context.h"
#include "viewer/documents/private_files.h"
#include "viewer/jobs/background_job.h"

class QMenu;

namespace macula::viewer {

class DocumentDialog;
class OpeningController;
class PlanarController;
class StudyBrowser;

// Lives on the UI thread.
class DocumentsController : public QObject {
    Q_OBJECT

  public:
    struct Uses {  // all of it outlives the controller
        OpeningController& opening;
        StudyBrowser& browser;
        PlanarController& images;
    };
    DocumentsController(const WindowContext& context, const Uses& uses);

    void addAction(QMenu& file);
    // `found` is the list that the document is in; null: in none, so that no image can be gone to.
    void open(std::shared_ptr<const study::FoundVolumes> found, const study::StudyRow::Document& document);
    // Where nothing could be opened as a volume: `source` if it is a document, or the only document of that
    // folder. Returns whether there is one.
    bool openInstead(const std::shared_ptr<const study::FoundVolumes>& found,
                     const std::filesystem::path& source);
    // Shows the image, on slices or by itself; opens its volume first where another one is open.
    void goTo(const std::shared_ptr<const study::FoundVolumes>& found, const study::ImagePlace& place);
    // While names are hidden no document is shown: any may name the patient.
    void showNames(bool shown);
    void onStudyShown();
    DocumentDialog& dialog() const { return *dialog_; }

  Q_SIGNALS:
    void shown();

  private:
    // A document with the list that it is in, so that no image of another list is taken for one of its own.
    struct Read {
        dicom::StudyDocument document;
        std::shared_ptr<const study::FoundVolumes> found;
        int patient = 0;
    };
    void connectDialog();
    void show(const Result<Read>& read);
    void askForOne();
    void goToReference(int place);
    void goToSlice(const study::ImagePlace& place);
    void askToOpenFile();
    void openFile(const std::filesystem::path& file);
    void saveFile();
    void saveText();
    void takeMeasurements();

    WindowContext context_;
    Uses uses_;
    DocumentDialog* dialog_;
    bool namesShown_ = true;
    std::shared_ptr<const study::FoundVolumes> found_;  // of the document; may be null
    int patient_ = 0;
    std::vector<std::optional<study::ImagePlace>> places_;  // of its references
    // An image to go to once its series is open, and the list that it is in.
    std::optional<study::ImagePlace> awaiting_;
    std::shared_ptr<const study::FoundVolumes> awaitedIn_;
    std::set<std::filesystem::path> confirmed_;  // documents whose file a person wants in another program
    PrivateFiles files_;
    BackgroundJob<Read> reading_;
};

}  // namespace macula::viewer
