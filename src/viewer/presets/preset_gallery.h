// A gallery of all presets as pictures of the open volume, to use and to manage them.
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QTimer>
#include <QWidget>
#include <optional>

#include "viewer/editor/study_editor.h"
#include "viewer/presets/preset_library.h"
#include "viewer/presets/preset_list_model.h"
#include "viewer/presets/preset_naming.h"
#include "viewer/presets/preset_pictures.h"

class QMenu;
class QVBoxLayout;

namespace macula::viewer {

// A grid in groups with a filter above it. One click selects, a double click or Enter uses. The host draws
// the pictures in the background, one at a time, for visible rows only, and none while the gallery is hidden.
// Session and library outlive it.
class PresetGallery : public QWidget {
    Q_OBJECT

  public:
    using StateNow = PresetNaming::StateNow;

    PresetGallery(StudyEditor& session, PresetLibrary& library, StateNow stateNow, QWidget* parent = nullptr);

    PresetListModel& model() const { return *model_; }
    bool isDrawing() const { return pictures_.isDrawing(); }

    void askToSaveCurve() { naming_.askToSaveCurve(); }
    void askToSaveSeen() { naming_.askToSaveSeen(); }

  Q_SIGNALS:
    void useAsked(const macula::viewer::LibraryPreset& preset);
    void compareAsked(const macula::viewer::LibraryPreset& preset);  // compare it with the current preset
    void exportAsked(const macula::viewer::LibraryPreset& preset);
    void importAsked();
    void failed(const macula::Error& error);  // while the gallery is hidden

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void makeBar(QVBoxLayout& column);
    void makeList();
    void listen();
    void onStudyShown();
    void showRows();
    void showShown();
    void showNotes();
    void selectAgain(const std::optional<PresetRow>& before);
    std::optional<PresetRow> currentRow() const;
    bool onListKey(int key);
    void activate(const QModelIndex& index);
    void toggle(PresetGroup group);
    void showMenu(const QPoint& at);
    void fillMenu(QMenu& menu, const LibraryPreset& preset);
    void remove(const LibraryPreset& preset);
    void tell(const Error& error);
    void drawNext();

    StudyEditor& session_;
    PresetLibrary& library_;
    PresetRows rows_;
    PresetNaming naming_;
    PresetPictures pictures_;
    QLineEdit* filter_;
    QListView* list_;
    PresetListModel* model_;
    QLabel* nothing_;
    QLabel* note_;
    QPushButton* undo_;
    QString trouble_;  // the last error
    QString removed_;  // the title of the preset that Undo restores
    QTimer picturesAreDue_;
};

}  // namespace macula::viewer
