// The state of the open study with its camera: applies, stores and restores it.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <string>

#include "scene/slices/opening_planes.h"
#include "scene/state/study_state.h"
#include "study/open/opened_study.h"
#include "viewer/context/window_context.h"

class QMenu;

namespace macula::live {
class StudyKeeper;
}

namespace macula::viewer {

// How much of a study's state is restored, and kept for the next time.
enum class Restores {
    all,
    work,  // measurements and slice display; options decide the rest
    nothing,
};

struct StateOptions {
    std::shared_ptr<const TransferFunction> preset = {};  // null: by the volume's modality
    std::shared_ptr<const trace::LightRig> lights = {};   // null: the default lights of each look
    Restores restores = Restores::all;
    bool keepsLayout = false;  // every study takes the window's layout
    // Of a study that is shown as new; nothing: that of the study before.
    std::function<std::optional<scene::Layout>(const Volume&)> usualLayout = {};
};

// The state in which a study is shown first.
struct OpeningState {
    scene::StudyState state = {};
    // The state as a person left it; nothing for a study that is shown as new.
    std::optional<scene::StudyState> left = {};
    bool keepsCamera = false;  // another volume on the same grid was on screen
    QStringList notes = {};    // on the preset
};

// Lives on the UI thread.
class StateController : public QObject {
    Q_OBJECT

  public:
    // `keeper` lives until the window's destructor; null: nothing is kept.
    StateController(const WindowContext& context, StateOptions options, live::StudyKeeper* keeper);

    // The state with the current camera; setState takes one of the same study. usage without a study,
    // inputNotUsable for a state of another series.
    scene::StudyState state() const;
    Result<void> setState(const scene::StudyState& state);

    // Also notes in the window that a study is restored.
    OpeningState openingState(const study::OpenedStudy& study, const scene::OpeningPlanes& planes);

    void begin();  // begins to store the state of another study
    void keep();   // stores the state if it has changed
    // Stores choices and measurements before the program ends. Returns true once stored, false after some
    // seconds without success.
    bool keepNow();

    void addActions(QMenu& view);

  private:
    std::shared_ptr<const TransferFunction> usualPreset(const Volume& volume) const;
    scene::Layout layoutOf(const Volume& volume) const;  // of one that is shown as new
    std::optional<scene::StudyState> stateAsLeft(const study::OpenedStudy& study);
    scene::StudyState stateToKeep() const;
    void showAfresh();
    const study::OpenedStudy& study() const;

    WindowContext context_;
    StateOptions options_;
    live::StudyKeeper* keeper_;
    // The last state given to the keeper, or the state at opening: an unchanged state is not stored, so it
    // never replaces a stored state that came too late or cannot be read.
    std::optional<scene::StudyState> kept_;
    // The JSON text of kept_, or the text as read: the base of this window's changes. See
    // StudyKeeper::keepState.
    std::shared_ptr<std::string> keptText_;
    QTimer keeps_;
    QTimer keepsChange_;  // stores a change soon after it
};

}  // namespace macula::viewer
