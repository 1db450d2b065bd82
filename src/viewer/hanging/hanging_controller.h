// Boxes of images in the window: the grid, hanging protocols, boxes that scroll together, a window of their
// own.
#pragma once

#include <QObject>
#include <QTimer>
#include <filesystem>
#include <memory>
#include <optional>

#include "study/hanging/hanging_protocol.h"
#include "viewer/context/window_context.h"
#include "viewer/hanging/kept_arrangement.h"
#include "viewer/hanging/own_protocols.h"
#include "viewer/jobs/background_job.h"

class QAction;
class QMenu;

namespace macula::viewer {

class PlanarController;

// A study whose images begin to be shown is hung as a person left it, else by the first protocol that is for
// it and shows what the person opened, unless something was arranged meanwhile. Lives on the UI thread.
class HangingController : public QObject {
    Q_OBJECT

  public:
    // `images` outlives it. `folder` keeps a person's protocols between runs; nothing: they are not kept.
    HangingController(const WindowContext& context, PlanarController& images,
                      const std::optional<std::filesystem::path>& folder);

    void keepIn(const std::shared_ptr<live::StudyKeeper>& keeper);
    void addMenu(QMenu& view);
    void onStudyShown();
    const OwnProtocols& own() const { return *own_; }
    bool isReady() const { return facts_ != nullptr; }  // it is known what can be hung
    // By its title or name; does nothing where there is none for this study.
    void hang(const QString& title);
    void save(const QString& name);  // what is on screen, as a protocol

  private:
    // Refers to `found`.
    struct Facts {
        std::shared_ptr<const study::FoundVolumes> found;
        study::HangingImages images;
    };
    void keep();
    void begin();
    void prepare(std::shared_ptr<const study::FoundVolumes> found, const dicom::Study& study);
    void take(const Result<std::shared_ptr<const Facts>>& facts);
    void hangFirst();
    BoxArrangement hung(const study::HangingProtocol& protocol) const;
    void apply(const study::HangingProtocol& protocol);
    void showAsAcquired();
    void setGrid(int rows, int columns);
    void fillMenu();
    void addGrids(QMenu& menu);
    void addProtocols(QMenu& menu);
    void askForGrid();
    void askForName();

    WindowContext context_;
    PlanarController& images_;
    OwnProtocols* own_;
    KeptArrangement* kept_;
    QMenu* menu_;
    QAction* acquired_ = nullptr;
    std::shared_ptr<const Facts> facts_;  // of the study that is looked at; null: not known yet
    std::optional<study::KeptBoxes> left_;
    bool isAnswered_ = true;    // the store has said how boxes were left
    bool isUntouched_ = false;  // nothing was arranged since the images began
    bool isHanging_ = false;
    QTimer scrollEnds_;
    BackgroundJob<std::shared_ptr<const Facts>> reading_;
};

}  // namespace macula::viewer
