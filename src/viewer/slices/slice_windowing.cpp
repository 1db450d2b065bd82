#include "viewer/slices/slice_windowing.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <utility>

#include "base/log.h"
#include "live/store/machine_documents.h"
#include "scene/drawing/projection_windows.h"
#include "scene/slices/window_presets.h"

namespace macula::viewer {

namespace {

constexpr std::int64_t kVersion = 1;

session::DocumentId documentId(const char* name = "windows of slices") {
    return {.kind = session::DocumentKind::preset, .study = {}, .name = name};
}

Error noMemory() {
    return {ErrorCode::outOfMemory,
            Text("There is not enough memory to keep windows."),
            {},
            Text("Close other programs.")};
}

}  // namespace

OwnWindowList::OwnWindowList(std::optional<std::filesystem::path> folder, QObject* parent)
    : QObject(parent), folder_(std::move(folder)) {
    if (!folder_) return;
    reading_.emplace(this, BackgroundJob<std::string>::Listener{
                               .ended = [this](const Result<std::string>& json) { onRead(json); }});
    writing_.emplace(
        this, BackgroundJob<Kept>::Listener{.ended = [this](const Result<Kept>& kept) { onKept(kept); }});
    reading_->start([folder = *folder_](Progress&) -> Result<std::string> {
        try {
            MACULA_TRY(const std::optional<std::string> json, live::machineDocument(folder, documentId()));
            return json.value_or(std::string());
        } catch (const std::exception&) {
            return noMemory();
        }
    });
}

OwnWindowList::~OwnWindowList() {
    // The threads end first, so that nobody else writes then.
    reading_.reset();
    writing_.reset();
    if (!folder_ || toKeep_.empty()) return;
    try {
        // A running write may have failed; storing its edits twice changes nothing.
        keeping_.insert(keeping_.end(), toKeep_.begin(), toKeep_.end());
        if (const auto kept = keepIn(*folder_, keeping_); !kept)
            log::warning("Windows could not be kept: {}", kept.error().message.english());
    } catch (const std::exception&) {
        log::warning("There was no memory to keep windows.");
    }
}

OwnWindowList::Kept OwnWindowList::edited(std::vector<scene::OwnWindow> windows, const Edits& edits) {
    Kept kept{.windows = std::move(windows), .leftOut = {}};
    for (const Edit& edit : edits) {
        if (edit.isRemoved) {
            std::erase(kept.windows, edit.window);
        } else if (auto all = scene::withOwnWindow(kept.windows, edit.window)) {
            kept.windows = *std::move(all);
        } else {
            kept.leftOut = all.error();
        }
    }
    return kept;
}

// Runs on the thread of the job, or in the destructor.
Result<OwnWindowList::Kept> OwnWindowList::keepIn(const std::filesystem::path& folder, const Edits& edits) {
    try {
        MACULA_TRY(const std::optional<std::string> json, live::machineDocument(folder, documentId()));
        std::vector<scene::OwnWindow> stored;
        if (json) {
            if (auto read = scene::ownWindowsFromJson(*json)) {
                stored = *std::move(read);
            } else {  // keeps a copy for the version that wrote it
                MACULA_TRY_VOID(live::keepMachineDocument(
                    folder, documentId("windows of slices not understood"), kVersion, *json));
            }
        }
        Kept kept = edited(std::move(stored), edits);
        MACULA_TRY_VOID(live::keepMachineDocument(folder, documentId(), kVersion, toJson(kept.windows)));
        return kept;
    } catch (const std::exception&) {
        return noMemory();
    }
}

void OwnWindowList::onRead(const Result<std::string>& json) {
    std::vector<scene::OwnWindow> read;
    if (!json) {
        Q_EMIT failed(json.error());
    } else if (!json->empty()) {
        if (auto windows = scene::ownWindowsFromJson(*json)) {
            read = *std::move(windows);
        } else {
            Q_EMIT failed(
                {ErrorCode::inputNotUsable,
                 Text::verbatim(tr("Windows of your own that were kept cannot be read.").toStdString()),
                 {},
                 Text::verbatim(tr("The next one that you keep takes their place.").toStdString())});
        }
    }
    // Changes made before the windows arrived stay.
    windows_ = edited(std::move(read), toKeep_).windows;
    Q_EMIT changed();
    keep();
}

void OwnWindowList::onKept(const Result<Kept>& kept) {
    const Edits done = std::exchange(keeping_, {});
    if (!kept) {
        // The next write, or the destructor, tries them again.
        toKeep_.insert(toKeep_.begin(), done.begin(), done.end());
        Q_EMIT failed(kept.error());
        return;
    }
    std::vector<scene::OwnWindow> now = edited(kept->windows, toKeep_).windows;
    const bool isOther = now != windows_;  // another program window has stored some
    windows_ = std::move(now);
    if (isOther) Q_EMIT changed();
    if (kept->leftOut) Q_EMIT failed(*kept->leftOut);
    keep();
}

Result<void> OwnWindowList::add(scene::OwnWindow window) {
    MACULA_TRY(windows_, scene::withOwnWindow(windows_, std::move(window)));
    edit({.window = windows_.back(), .isRemoved = false});
    return {};
}

void OwnWindowList::remove(const scene::OwnWindow& window) {
    const scene::OwnWindow removed = window;  // copied: it may refer into the list
    if (std::erase(windows_, removed) == 0) return;
    edit({.window = removed, .isRemoved = true});
}

void OwnWindowList::edit(Edit made) {
    if (folder_) toKeep_.push_back(std::move(made));
    Q_EMIT changed();
    keep();
}

void OwnWindowList::keep() {
    if (!folder_ || toKeep_.empty() || reading_->running() || writing_->running()) return;
    keeping_ = std::exchange(toKeep_, {});
    writing_->start([folder = *folder_, edits = keeping_](Progress&) { return keepIn(folder, edits); });
}

SliceWindowing::SliceWindowing(StudyEditor& session, const PaneContent& content)
    : session_(session), content_(content) {}

void SliceWindowing::applyPreset(int digit) {
    if (!content_.hasStudy()) return;
    if (const auto preset = scene::windowPreset(content_.wantedVolume(), digit))
        propose(preset->window, false);
}

void SliceWindowing::applyOwn(int number) {
    if (!content_.hasStudy() || own_ == nullptr || number < 1) return;
    const auto own = own_->fitting(content_.wantedVolume());
    if (std::size_t(number) <= own.size()) propose(own[std::size_t(number) - 1].window, false);
}

void SliceWindowing::drag(glm::dvec2 byHeights) {
    propose(scene::dragged(content_.wantedWindow(), byHeights, content_.wantedVolume()), true);
}

void SliceWindowing::propose(const std::optional<DisplayWindow>& window, bool isDrag) {
    const bool ofSecond = content_.wantsSecond();
    // The window of a difference is not that of the study: the bar of phases sets it.
    if (!ofSecond && content_.showsDifference()) return;
    const auto edit = [&](scene::StudyState& next) {
        const bool isOwn = ofSecond && !next.secondVolume->linksWindow;
        (isOwn ? next.secondVolume->window : next.slices.window) = window;
    };
    const QString what = ofSecond ? tr("Window of the second volume") : tr("Window");
    if (isDrag) {
        session_.drag(what, edit);
    } else {
        session_.change(what, edit);
    }
}

}  // namespace macula::viewer
