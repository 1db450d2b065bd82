// The library of all presets, built-in and own.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "live/store/preset_shelf.h"
#include "live/store/study_keeper.h"
#include "presets/imported_preset.h"
#include "scene/choice/preset_kinds.h"
#include "viewer/editor/study_editor.h"
#include "viewer/jobs/background_job.h"

namespace macula::viewer {

// A preset that can be chosen.
struct LibraryPreset {
    live::PresetRef ref;
    std::shared_ptr<const TransferFunction> function;  // never null
    std::shared_ptr<const live::OwnPreset> own;        // null: built in, and never changed
};

QString shownTitle(const LibraryPreset& preset);  // in the language of the window

// The keeper's thread reads own presets from the store once and writes them after each change; the UI does
// not wait. Without a store they live as long as this object. Lives on the UI thread.
class PresetLibrary : public QObject {
    Q_OBJECT

  public:
    // The session outlives this; its catalogue gets the presets. `keeper` null: nothing is kept.
    PresetLibrary(StudyEditor& session, const std::shared_ptr<live::StudyKeeper>& keeper,
                  QObject* parent = nullptr);
    ~PresetLibrary() override;

    const live::PresetShelf& shelf() const { return shelf_; }
    std::vector<LibraryPreset> builtIn() const;
    std::vector<LibraryPreset> own() const;
    std::optional<LibraryPreset> find(const live::PresetRef& ref) const;
    // Whether the preset suits the open images; true without a study.
    bool fits(const TransferFunction& function) const;
    // The preset that equals `function`; empty for an edited one.
    live::PresetRef refOf(const TransferFunction& function) const;
    // A note about problems with storing presets; empty without problems.
    QString note() const;

    // `state` is the session's state with the camera.
    Result<live::PresetRef> saveCurve(const QString& title, const scene::StudyState& state);
    Result<live::PresetRef> saveSeen(const QString& title, const scene::StudyState& state);
    Result<live::PresetRef> saveCopy(const QString& title, const live::PresetRef& ref);
    Result<void> rename(const live::PresetRef& own, const QString& title);
    // Empty if the name is allowed; `own`: the preset to rename, whose present name is allowed.
    QString whyNameIsRefused(const QString& title, const live::PresetRef& own = {}) const;
    QString freeTitle(const QString& title) const;
    // False unless it is an own preset.
    bool remove(const live::PresetRef& own);
    QString removedTitle() const;  // the last removed preset's title; empty: none
    void putBackRemoved();
    void setFavourite(const live::PresetRef& ref, bool isFavourite);
    void noteUsed(const live::PresetRef& ref);

    // Adds all presets of a file in any known format to the own ones; ends with imported or failed.
    void importFile(const std::string& path);
    bool isImporting() const { return import_.running(); }
    // Writes a file that --preset reads: the curve, without the saved view.
    Result<void> exportTo(const std::string& path, const live::PresetRef& ref) const;

  Q_SIGNALS:
    void changed();
    void imported(const QStringList& titles, const QStringList& notes);
    void failed(const macula::Error& error);

  private:
    // Lets another thread reach the library while it lives.
    struct Mailbox {
        std::mutex mutex;
        PresetLibrary* library = nullptr;
    };

    std::shared_ptr<const TransferFunction> functionOf(const scene::StudyState& state) const;
    void readStored();
    void onStored(const Result<live::StoredPresets>& stored);
    void write();
    void tellChange();
    // If `before` is shown, shows the preset `now` instead, as one undo step.
    void showAs(const QString& what, const std::shared_ptr<const TransferFunction>& before,
                const live::PresetRef& now);
    void onImported(const Result<presets::ImportedPresets>& read);

    StudyEditor& session_;
    live::PresetShelf shelf_;
    std::weak_ptr<live::StudyKeeper> keeper_;
    bool isKept_ = false;
    QString storeNote_;  // errors of reading and writing
    std::shared_ptr<const live::OwnPreset> removed_;
    std::shared_ptr<Mailbox> mailbox_ = std::make_shared<Mailbox>();
    BackgroundJob<presets::ImportedPresets> import_;
    std::optional<scene::FitsVolume> fitsVolume_;  // for the session's volume
};

}  // namespace macula::viewer
