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

#include "live/store/model_keeper.h"
#include "live/store/preset_shelf.h"
#include "presets/imported_preset.h"
#include "scene/choice/preset_kinds.h"
#include "viewer/jobs/background_job.h"
#include "viewer/session/viewer_session.h"

namespace macula::viewer {

// A preset that can be chosen.
struct LibraryPreset {
    app::PresetRef ref;
    std::shared_ptr<const TransferFunction> function;  // never null
    std::shared_ptr<const app::OwnPreset> own;         // null: built in, and never changed
};

// The keeper's thread reads own presets from the store once and writes them after each change; the UI does
// not wait. Without a store they live as long as this object. Lives on the UI thread.
class PresetLibrary : public QObject {
    Q_OBJECT

  public:
    // The session outlives this; its catalogue gets the presets. `keeper` null: nothing is kept.
    PresetLibrary(ViewerSession& session, const std::shared_ptr<app::ModelKeeper>& keeper,
                  QObject* parent = nullptr);
    ~PresetLibrary() override;

    const app::PresetShelf& shelf() const { return shelf_; }
    std::vector<LibraryPreset> builtIn() const;
    std::vector<LibraryPreset> own() const;
    std::optional<LibraryPreset> find(const app::PresetRef& ref) const;
    // Whether the preset suits the open images; true without a study.
    bool fits(const TransferFunction& function) const;
    // The preset that equals `function`; empty for an edited one.
    app::PresetRef refOf(const TransferFunction& function) const;
    // A note about problems with storing presets; empty without problems.
    QString note() const;

    // `state` is the session's state with the camera.
    Result<app::PresetRef> saveCurve(const QString& title, const app::StudyState& state);
    Result<app::PresetRef> saveSeen(const QString& title, const app::StudyState& state);
    Result<app::PresetRef> saveCopy(const QString& title, const app::PresetRef& ref);
    Result<void> rename(const app::PresetRef& own, const QString& title);
    // Empty if the name is allowed; `own`: the preset to rename, whose present name is allowed.
    QString whyNameIsRefused(const QString& title, const app::PresetRef& own = {}) const;
    QString freeTitle(const QString& title) const;
    // False unless it is an own preset.
    bool remove(const app::PresetRef& own);
    QString removedTitle() const;  // of the last one removed; empty: nothing to put back
    void putBackRemoved();
    void setFavourite(const app::PresetRef& ref, bool isFavourite);
    void noteUsed(const app::PresetRef& ref);

    // Adds all presets of a file in any known format to the own ones; ends with imported or failed.
    void importFile(const std::string& path);
    bool isImporting() const { return import_.running(); }
    // Writes a file that --preset reads: the curve, without the saved view.
    Result<void> exportTo(const std::string& path, const app::PresetRef& ref) const;

  signals:
    void changed();
    void imported(const QStringList& titles, const QStringList& notes);
    void failed(const macula::Error& error);

  private:
    // Lets another thread reach the library while it lives.
    struct Mailbox {
        std::mutex mutex;
        PresetLibrary* library = nullptr;
    };

    std::shared_ptr<const TransferFunction> functionOf(const app::StudyState& state) const;
    void readStored();
    void onStored(const Result<app::StoredPresets>& stored);
    void write();
    void tellChange();
    // If `before` is shown, shows the preset `now` instead, as one undo step.
    void showAs(const QString& what, const std::shared_ptr<const TransferFunction>& before,
                const app::PresetRef& now);
    void onImported(const Result<presets::ImportedPresets>& read);

    ViewerSession& session_;
    app::PresetShelf shelf_;
    std::weak_ptr<app::ModelKeeper> keeper_;
    bool isKept_ = false;
    QString storeNote_;  // errors of reading and writing
    std::shared_ptr<const app::OwnPreset> removed_;
    std::shared_ptr<Mailbox> mailbox_ = std::make_shared<Mailbox>();
    BackgroundJob<presets::ImportedPresets> import_;
    std::optional<app::FitsVolume> fitsVolume_;  // for the session's volume
};

}  // namespace macula::viewer
