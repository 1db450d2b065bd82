// Key images in the window: marked in the list of studies, and gone to one after the other.
#pragma once

#include <QObject>
#include <cstddef>
#include <memory>
#include <optional>

#include "study/documents/key_images.h"
#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"

class QAction;
class QMenu;

namespace macula::viewer {

class DocumentsController;
class StudyBrowser;

// Reads the selections of key images of the folder that is listed, in the background. Lives on the UI thread.
class KeyImagesController : public QObject {
    Q_OBJECT

  public:
    struct Uses {  // both outlive the controller
        DocumentsController& documents;
        StudyBrowser& browser;
    };
    KeyImagesController(const WindowContext& context, const Uses& uses);

    void addActions(QMenu& view);
    bool isFinding() const { return finding_.running(); }

  private:
    using Found = std::shared_ptr<const study::KeyImages>;
    void onListed();
    void take(const Result<Found>& keys);
    void step(int by);

    WindowContext context_;
    Uses uses_;
    std::shared_ptr<const study::FoundVolumes> found_;  // that `keys_` are of
    Found keys_;
    std::optional<std::size_t> shown_;  // a place in KeyImages::inOrder(); nothing: none yet
    QAction* next_ = nullptr;
    QAction* previous_ = nullptr;
    BackgroundJob<Found> finding_;
};

}  // namespace macula::viewer
