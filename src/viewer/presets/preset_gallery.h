// A gallery of all presets as pictures of the open volume, to use and to manage them.
#pragma once

#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "pictures/preset_thumbnail.h"
#include "scene/state/study_state.h"
#include "viewer/editor/study_editor.h"
#include "viewer/jobs/background_job.h"
#include "viewer/presets/preset_library.h"
#include "viewer/presets/preset_list_model.h"

class QMenu;
class QVBoxLayout;

namespace macula::viewer {

// A grid in groups with a filter above it. One click selects, a double click or Enter uses. The host draws
// the pictures in the background, one at a time, for visible rows only, and none while the gallery is hidden.
// Session and library outlive it.
class PresetGallery : public QWidget {
    Q_OBJECT

  public:
    // Returns the current state with its camera.
    using StateNow = std::function<scene::StudyState()>;

    PresetGallery(StudyEditor& session, PresetLibrary& library, StateNow stateNow, QWidget* parent = nullptr);

    PresetListModel& model() const { return *model_; }
    bool isDrawing() const { return drawing_ != nullptr; }
    void focusFilter();

    void askToSaveCurve();
    void askToSaveSeen();

  signals:
    void useAsked(const macula::viewer::LibraryPreset& preset);
    void compareAsked(const macula::viewer::LibraryPreset& preset);  // with the current preset
    void exportAsked(const macula::viewer::LibraryPreset& preset);
    void importAsked();
    void failed(const macula::Error& error);  // while the gallery is hidden

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    struct Drawn {
        std::shared_ptr<const pictures::CoarseVolume> coarse;  // for the next pictures
        QImage picture;
    };

    void makeBar(QVBoxLayout& column);
    void makeList();
    void onStudyShown();
    void showRows();
    void showShown();
    void showNotes();
    std::vector<PresetRow> makeRows(const std::set<PresetGroup>& expanded) const;
    std::vector<LibraryPreset> presetsOf(PresetGroup group) const;
    bool isFound(const LibraryPreset& preset) const;
    std::set<PresetGroup> expandedNow() const;
    void selectAgain(const std::optional<PresetRow>& before);
    std::optional<PresetRow> currentRow() const;
    bool onListKey(int key);
    void activate(const QModelIndex& index);
    void toggle(PresetGroup group);
    void showMenu(const QPoint& at);
    void fillMenu(QMenu& menu, const LibraryPreset& preset);
    void askForName(const QString& title, const QString& what, const QString& proposed,
                    const live::PresetRef& own, std::function<Result<void>(const QString&)> then);
    void askToCopy(const LibraryPreset& preset);
    void askToRename(const LibraryPreset& preset);
    void remove(const LibraryPreset& preset);
    void tell(const Error& error);
    void drawNext();
    void takePicture(const Result<Drawn>& drawn);

    StudyEditor& session_;
    PresetLibrary& library_;
    StateNow stateNow_;
    QLineEdit* filter_;
    QListView* list_;
    PresetListModel* model_;
    QLabel* nothing_;
    QLabel* note_;
    QPushButton* undo_;
    QString trouble_;  // the last error
    QString removed_;  // the title of the preset that Undo restores

    std::vector<std::string> words_;  // of the filter
    std::set<PresetGroup> folded_{PresetGroup::others};

    QTimer picturesAreDue_;
    std::shared_ptr<const pictures::CoarseVolume> coarse_;
    bool hasNoPictures_ = false;  // of this volume
    std::shared_ptr<const TransferFunction> drawing_;
    BackgroundJob<Drawn> pictures_;
};

}  // namespace macula::viewer
