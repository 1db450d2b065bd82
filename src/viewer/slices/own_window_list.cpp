#include "viewer/slices/own_window_list.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "app/session/machine_documents.h"

namespace macula::viewer {

namespace {

constexpr std::int64_t kVersion = 1;

session::DocumentId documentId() {
    return {.kind = session::DocumentKind::preset, .study = {}, .name = "windows of slices"};
}

Error noMemory() {
    return {
        ErrorCode::outOfMemory, "There is not enough memory to keep windows.", {}, "Close other programs."};
}

}  // namespace

OwnWindowList::OwnWindowList(std::optional<std::filesystem::path> folder, QObject* parent)
    : QObject(parent),
      folder_(std::move(folder)),
      isRead_(!folder_),
      reading_(this, {.progressed = [](const ProgressUpdate&) {},
                      .ended = [this](const Result<std::string>& json) { onRead(json); }}),
      writing_(this, {.progressed = [](const ProgressUpdate&) {},
                      .ended =
                          [this](const Result<bool>& done) {
                              if (!done) emit failed(done.error());
                              if (std::exchange(mustKeep_, false)) keep();
                          }}) {
    if (!folder_) return;
    reading_.start([folder = *folder_](Progress&) -> Result<std::string> {
        try {
            MACULA_TRY(const std::optional<std::string> json, app::machineDocument(folder, documentId()));
            return json.value_or(std::string());
        } catch (const std::exception&) {
            return noMemory();
        }
    });
}

// The threads end before this does.
OwnWindowList::~OwnWindowList() = default;

void OwnWindowList::onRead(const Result<std::string>& json) {
    isRead_ = true;
    std::vector<app::OwnWindow> read;
    if (!json) {
        emit failed(json.error());
    } else if (!json->empty()) {
        if (auto windows = app::ownWindowsFromJson(*json)) {
            read = *std::move(windows);
        } else {
            emit failed({ErrorCode::inputNotUsable,
                         tr("Windows of your own that were kept cannot be read.").toStdString(),
                         {},
                         tr("The next one that you keep takes their place.").toStdString()});
        }
    }
    // What was added before they came stays.
    for (app::OwnWindow& added : std::exchange(windows_, std::move(read))) {
        if (auto all = app::withOwnWindow(windows_, std::move(added))) windows_ = *std::move(all);
    }
    emit changed();
    if (std::exchange(mustKeep_, false)) keep();
}

Result<void> OwnWindowList::add(app::OwnWindow window) {
    MACULA_TRY(windows_, app::withOwnWindow(windows_, std::move(window)));
    emit changed();
    keep();
    return {};
}

void OwnWindowList::remove(const app::OwnWindow& window) {
    if (std::erase(windows_, window) == 0) return;
    emit changed();
    keep();
}

void OwnWindowList::keep() {
    if (!folder_) return;
    if (!isRead_ || writing_.running()) {
        mustKeep_ = true;
        return;
    }
    writing_.start([folder = *folder_, json = app::toJson(windows_)](Progress&) -> Result<bool> {
        try {
            MACULA_TRY_VOID(app::keepMachineDocument(folder, documentId(), kVersion, json));
            return true;
        } catch (const std::exception&) {
            return noMemory();
        }
    });
}

}  // namespace macula::viewer
