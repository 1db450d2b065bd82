#include "viewer/presets/preset_library.h"

#include <algorithm>
#include <new>
#include <utility>

#include "base/atomic_file.h"
#include "live/store/stored_presets.h"
#include "pipeline/volume/transfer_function_json.h"
#include "presets/preset_file.h"
#include "scene/choice/catalogue.h"
#include "scene/transfer/same_transfer.h"
#include "viewer/jobs/post.h"
#include "viewer/language/window_language.h"
#include "viewer/status/status_texts.h"

namespace macula::viewer {

namespace {

// Normalised, because Unicode may encode the same letter in two ways.
std::string typed(const QString& title) {
    return title.normalized(QString::NormalizationForm_C).toStdString();
}

}  // namespace

QString shownTitle(const LibraryPreset& preset) {
    return titleOr(preset.function->title, preset.function->name);
}

PresetLibrary::PresetLibrary(StudyEditor& session, const std::shared_ptr<live::StudyKeeper>& keeper,
                             QObject* parent)
    : QObject(parent),
      session_(session),
      shelf_({session.builtInPresets().begin(), session.builtInPresets().end()}),
      keeper_(keeper),
      isKept_(keeper != nullptr),
      import_(this, {.ended = [this](const Result<presets::ImportedPresets>& read) { onImported(read); }}) {
    mailbox_->library = this;
    // Connected before all that show presets, which ask what fits the new study.
    connect(&session_, &StudyEditor::studyShown, this, [this] {
        fitsVolume_.reset();
        if (session_.hasStudy()) fitsVolume_.emplace(*session_.study().volume);
    });
    if (session_.hasStudy()) fitsVolume_.emplace(*session_.study().volume);
    readStored();
}

PresetLibrary::~PresetLibrary() {
    const std::lock_guard lock(mailbox_->mutex);
    mailbox_->library = nullptr;
}

void PresetLibrary::readStored() {
    const auto keeper = keeper_.lock();
    if (!keeper) return;
    keeper->withStore([mailbox = mailbox_](session::Store* store) {
        std::optional<Result<live::StoredPresets>> stored;
        if (store != nullptr) stored = live::readStoredPresets(*store);
        const std::lock_guard lock(mailbox->mutex);
        PresetLibrary* library = mailbox->library;
        if (library == nullptr) return;
        post(library, [library, stored = std::move(stored)] {
            if (stored) return library->onStored(*stored);
            library->isKept_ = false;
            Q_EMIT library->changed();
        });
    });
}

void PresetLibrary::onStored(const Result<live::StoredPresets>& stored) {
    if (!stored) {
        storeNote_ = tr("Your presets could not be read: %1").arg(inWindowsLanguage(stored.error()));
        Q_EMIT changed();
        return;
    }
    shelf_.join(*stored);
    QStringList notes;
    if (stored->damaged > 0)
        notes << tr("Presets of yours that are damaged and were left out: %1.").arg(stored->damaged);
    if (stored->unreadable > 0)
        notes << tr("Presets of yours that this version of Macula cannot read, and leaves as they are: %1.")
                     .arg(stored->unreadable);
    storeNote_ = notes.join(QLatin1Char(' '));
    tellChange();
}

// The change is on screen already. If it cannot be written, it lasts as long as the window.
void PresetLibrary::write() {
    std::vector<live::PresetDocument> changes = shelf_.takeChanges();
    const auto keeper = keeper_.lock();
    if (!keeper || changes.empty()) return;
    keeper->withStore([mailbox = mailbox_, changes = std::move(changes)](session::Store* store) {
        if (store == nullptr) return;  // the error of reading was reported
        std::optional<Error> error;
        for (const live::PresetDocument& change : changes) {
            const auto written = live::writePresetDocument(*store, change);
            if (!written) error = written.error();
        }
        const std::lock_guard lock(mailbox->mutex);
        PresetLibrary* library = mailbox->library;
        if (library == nullptr || !error) return;
        post(library, [library, error = *error] {
            library->storeNote_ =
                tr("The last change of your presets is not stored and lasts until this window closes: %1")
                    .arg(inWindowsLanguage(error));
            Q_EMIT library->changed();
        });
    });
}

void PresetLibrary::tellChange() {
    write();
    std::vector<std::shared_ptr<const TransferFunction>> functions;
    for (const auto& preset : shelf_.own()) functions.push_back(preset->function);
    session_.setOwnPresets(functions);
    Q_EMIT changed();
}

QString PresetLibrary::note() const {
    if (isKept_) return storeNote_;
    return tr(
        "Nothing is kept between runs: presets of your own live until this window closes. Export those "
        "that you need.");
}

std::vector<LibraryPreset> PresetLibrary::builtIn() const {
    std::vector<LibraryPreset> all;
    for (const auto& function : session_.builtInPresets()) all.push_back({function->name, function, nullptr});
    return all;
}

std::vector<LibraryPreset> PresetLibrary::own() const {
    std::vector<LibraryPreset> all;
    for (const auto& preset : shelf_.own()) all.push_back({preset->id, preset->function, preset});
    return all;
}

std::optional<LibraryPreset> PresetLibrary::find(const live::PresetRef& ref) const {
    if (const auto own = shelf_.find(ref)) return LibraryPreset{own->id, own->function, own};
    for (const auto& function : session_.builtInPresets())
        if (function->name == ref) return LibraryPreset{ref, function, nullptr};
    return std::nullopt;
}

bool PresetLibrary::fits(const TransferFunction& function) const {
    return !fitsVolume_ || (*fitsVolume_)(function);
}

live::PresetRef PresetLibrary::refOf(const TransferFunction& function) const {
    for (const auto& preset : shelf_.own())
        if (scene::isSame(*preset->function, function)) return preset->id;
    for (const auto& preset : session_.builtInPresets())
        if (scene::isSame(*preset, function)) return preset->name;
    return {};
}

std::shared_ptr<const TransferFunction> PresetLibrary::functionOf(const scene::StudyState& state) const {
    if (state.preset) return state.preset;
    return scene::presetFor(session_.catalogue(), *session_.study().volume);
}

Result<live::PresetRef> PresetLibrary::saveCurve(const QString& title, const scene::StudyState& state) {
    if (!session_.hasStudy())
        return Error{
            ErrorCode::usage, Text("There is no preset to save yet."), {}, Text("Open a study first.")};
    MACULA_TRY(const live::PresetRef ref, shelf_.add(typed(title), *functionOf(state)));
    tellChange();
    showAs(tr("Keep preset"), state.preset, ref);
    return ref;
}

Result<live::PresetRef> PresetLibrary::saveSeen(const QString& title, const scene::StudyState& state) {
    if (!session_.hasStudy())
        return Error{
            ErrorCode::usage, Text("There is nothing to be seen yet."), {}, Text("Open a study first.")};
    MACULA_TRY(const live::PresetRef ref,
               shelf_.add(typed(title), *functionOf(state), live::seenOf(state, *session_.study().volume)));
    tellChange();
    showAs(tr("Keep preset"), state.preset, ref);
    return ref;
}

Result<live::PresetRef> PresetLibrary::saveCopy(const QString& title, const live::PresetRef& ref) {
    const auto preset = find(ref);
    if (!preset) return Error{ErrorCode::usage, Text("The preset is gone."), {}, Text("Choose another one.")};
    MACULA_TRY(const live::PresetRef copy,
               shelf_.add(typed(title), *preset->function, preset->own ? preset->own->seen : std::nullopt));
    tellChange();
    return copy;
}

Result<void> PresetLibrary::rename(const live::PresetRef& own, const QString& title) {
    const auto before = shelf_.find(own);
    MACULA_TRY_VOID(shelf_.rename(own, typed(title)));
    tellChange();
    showAs(tr("Rename preset"), before->function, own);
    return {};
}

void PresetLibrary::showAs(const QString& what, const std::shared_ptr<const TransferFunction>& before,
                           const live::PresetRef& now) {
    const auto& shown = session_.state().preset;
    const auto own = shelf_.find(now);
    if (!before || !shown || !own || !scene::isSame(*shown, *before)) return;
    session_.change(what, [&](scene::StudyState& next) { next.preset = own->function; });
}

QString PresetLibrary::whyNameIsRefused(const QString& title, const live::PresetRef& own) const {
    const auto free = shelf_.freeName(typed(title), own);
    return free ? QString() : inWindowsLanguage(free.error());
}

QString PresetLibrary::freeTitle(const QString& title) const {
    return QString::fromStdString(shelf_.nearestFreeName(typed(title)));
}

bool PresetLibrary::remove(const live::PresetRef& own) {
    auto removed = shelf_.remove(own);
    if (!removed) return false;
    removed_ = std::move(removed);
    tellChange();
    return true;
}

QString PresetLibrary::removedTitle() const {
    return removed_ ? QString::fromStdString(removed_->title()) : QString();
}

void PresetLibrary::putBackRemoved() {
    if (!removed_) return;
    shelf_.putBack(*std::exchange(removed_, nullptr));
    tellChange();
}

void PresetLibrary::setFavourite(const live::PresetRef& ref, bool isFavourite) {
    shelf_.setFavourite(ref, isFavourite);
    write();
    Q_EMIT changed();
}

void PresetLibrary::noteUsed(const live::PresetRef& ref) {
    if (ref.empty()) return;
    shelf_.noteUsed(ref, session_.hasStudy() ? session_.study().volume->modality() : std::string());
    write();
    Q_EMIT changed();
}

void PresetLibrary::importFile(const std::string& path) {
    import_.start([path](Progress&) -> Result<presets::ImportedPresets> {
        try {
            return presets::readPresetFile(path);
        } catch (const std::bad_alloc&) {
            return Error{ErrorCode::outOfMemory, Text("There is not enough memory to read the presets."),
                         path, Text("Close other programs.")};
        }
    });
}

void PresetLibrary::onImported(const Result<presets::ImportedPresets>& read) {
    if (!read) {
        Q_EMIT failed(read.error());
        return;
    }
    QStringList titles;
    QStringList notes;
    std::optional<Error> error;
    for (const presets::ImportedPreset& preset : *read) {
        const TransferFunction& function = preset.function;
        const std::string title =
            shelf_.nearestFreeName(function.title.empty() ? function.name : function.title);
        const auto added = shelf_.add(title, function);
        if (!added) {
            if (!error) error = added.error();
            continue;
        }
        titles << QString::fromStdString(title);
        notes += inWindowsLanguage(preset.notes);
    }
    notes.removeDuplicates();
    if (!titles.isEmpty()) {
        tellChange();
        if (error)
            notes << tr("Presets of the file that could not be kept: %1. %2")
                         .arg(qsizetype(read->size()) - titles.size())
                         .arg(inWindowsLanguage(*error));
        Q_EMIT imported(titles, notes);
    } else if (error) {
        Q_EMIT failed(*error);
    }
}

Result<void> PresetLibrary::exportTo(const std::string& path, const live::PresetRef& ref) const {
    const auto preset = find(ref);
    if (!preset) return Error{ErrorCode::usage, Text("The preset is gone."), {}, Text("Choose another one.")};
    return writeTextAtomically(path, toJson(*preset->function));
}

}  // namespace macula::viewer
