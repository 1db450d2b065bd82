// All presets that somebody can choose, and what becomes of those of their own.
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

// One that can be chosen.
struct LibraryPreset {
    app::PresetRef ref;
    std::shared_ptr<const TransferFunction> function;  // never null
    std::shared_ptr<const app::OwnPreset> own;         // null: built in, and never changed
};

// Presets of one's own are read from the store once and written to it after each change, on the keeper's
// thread; what is on screen waits for neither. Where nothing is kept they live as long as this. Lives on the
// UI thread.
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
    // Whether it is made for images such as those that are open; without a study all are.
    bool fits(const TransferFunction& function) const;
    // Which of them this is; empty: none, as it was edited.
    app::PresetRef refOf(const TransferFunction& function) const;
    // What has to be known about how presets are kept; empty where all is well.
    QString note() const;

    // Of the session's state, which `state` is with its camera.
    Result<app::PresetRef> saveCurve(const QString& title, const app::StudyState& state);
    Result<app::PresetRef> saveSeen(const QString& title, const app::StudyState& state);
    Result<app::PresetRef> saveCopy(const QString& title, const app::PresetRef& ref);
    Result<void> rename(const app::PresetRef& own, const QString& title);
    // Nothing where the name can be given; `own`: the preset that has it now.
    QString whyNameIsRefused(const QString& title, const app::PresetRef& own = {}) const;
    QString freeTitle(const QString& title) const;
    // False where it is none of one's own.
    bool remove(const app::PresetRef& own);
    QString removedTitle() const;  // of the one that was removed last; empty: there is nothing to put back
    void putBackRemoved();
    void setFavourite(const app::PresetRef& ref, bool isFavourite);
    void noteUsed(const app::PresetRef& ref);

    // All of a file, in any format that is known, become one's own; ends with imported or failed.
    void importFile(const std::string& path);
    bool isImporting() const { return import_.running(); }
    // As --preset reads it: the curve, and nothing else that was seen.
    Result<void> exportTo(const std::string& path, const app::PresetRef& ref) const;

  signals:
    void changed();
    void imported(const QStringList& titles, const QStringList& notes);
    void failed(const macula::Error& error);

  private:
    // Reached from another thread as long as the library lives.
    struct Mailbox {
        std::mutex mutex;
        PresetLibrary* library = nullptr;
    };

    std::shared_ptr<const TransferFunction> functionOf(const app::StudyState& state) const;
    void readStored();
    void onStored(const Result<app::StoredPresets>& stored);
    void write();
    void tellChange();
    // What is shown of it goes on under the name that it has now; one step of the session.
    void showAs(const QString& what, const std::shared_ptr<const TransferFunction>& before,
                const app::PresetRef& now);
    void onImported(const Result<presets::ImportedPresets>& read);

    ViewerSession& session_;
    app::PresetShelf shelf_;
    std::weak_ptr<app::ModelKeeper> keeper_;
    bool isKept_ = false;
    QString storeNote_;  // what went wrong with reading and writing
    std::shared_ptr<const app::OwnPreset> removed_;
    std::shared_ptr<Mailbox> mailbox_ = std::make_shared<Mailbox>();
    BackgroundJob<presets::ImportedPresets> import_;
    std::optional<app::FitsVolume> fitsVolume_;  // that of the session
};

}  // namespace macula::viewer
