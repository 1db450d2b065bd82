// Opens the studies that a person asks for or drops, and shows progress and errors.
#pragma once

#include <QObject>
#include <cstddef>
#include <functional>
#include <memory>

#include "viewer/context/window_context.h"
#include "viewer/viewport/dropped.h"
#include "viewer/volume/study_loader.h"

class QMenu;

namespace macula::viewer {

class StateController;
class WorkBar;

// The study on screen stays until another one is loaded. Lives on the UI thread.
class OpeningController : public QObject {
    Q_OBJECT

  public:
    // `states` lives until the window's destructor. `keeper` null: nothing is kept.
    OpeningController(const WindowContext& context, StateController& states,
                      std::shared_ptr<live::StudyKeeper> keeper);

    // Call it after others have connected to the loader: they must learn first how an opening ended.
    void connectOutcomes();

    void open(study::StudySource source);
    void openFound(std::shared_ptr<const study::FoundVolumes> found, std::size_t index);
    void openPhase(study::PhaseSource source, std::size_t volume);
    void openDropped(const Dropped& what);

    // When another study is shown, drops the notes on the study before, and on the store unless they are new.
    void forgetNotes();
    void tellOfStore(const Error& error);

    StudyLoader& loader() { return loader_; }
    const StudyLoader& loader() const { return loader_; }
    // Called when nothing could be opened as a volume; true: something else is shown, and no error.
    void setInstead(std::function<bool()> instead) { instead_ = std::move(instead); }
    // Called with the only file that is dropped; true: somebody else opens it.
    void setDropTaken(std::function<bool(const QString&)> taken) { dropTaken_ = std::move(taken); }
    void letKeeperGo() { loader_.setKeeper(nullptr); }
    WorkBar* bar() const { return bar_; }
    void addActions(QMenu& file);
    void addPhantomAction(QMenu& file);

  Q_SIGNALS:
    void loaded(const macula::study::OpenedStudy& study);
    void cancelled();

  private:
    void askForFolder();
    void askForFile();
    void showError(const Error& error);
    Error told(Error error) const;

    WindowContext context_;
    StateController& states_;
    StudyLoader loader_;
    WorkBar* bar_;
    std::function<bool()> instead_;
    std::function<bool(const QString&)> dropTaken_;
    bool storeNoteIsNew_ = false;  // the store's note came during an opening
};

}  // namespace macula::viewer
