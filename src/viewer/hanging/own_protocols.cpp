#include "viewer/hanging/own_protocols.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "base/log.h"
#include "live/store/machine_documents.h"

namespace macula::viewer {

namespace {

constexpr std::int64_t kVersion = 1;

session::DocumentId idOf(const char* name = "hanging protocols") {
    return {.kind = session::DocumentKind::layout, .study = {}, .name = name};
}

}  // namespace

OwnProtocols::OwnProtocols(std::optional<std::filesystem::path> folder, QObject* parent)
    : QObject(parent), folder_(std::move(folder)) {
    if (!folder_) return;
    job_.emplace(this, BackgroundJob<Protocols>::Listener{
                           .ended = [this](const Result<Protocols>& kept) { onKept(kept); }});
    keep();  // reads
}

OwnProtocols::~OwnProtocols() {
    job_.reset();  // its thread ends first
    if (!folder_ || (waiting_.empty() && writing_.empty())) return;
    try {
        // A running write may have failed; storing its edits twice changes nothing.
        writing_.insert(writing_.end(), waiting_.begin(), waiting_.end());
        if (!keepIn(*folder_, writing_)) log::warning("hanging protocols could not be kept");
    } catch (const std::exception&) {
        log::warning("There was no memory to keep hanging protocols.");
    }
}

OwnProtocols::Protocols OwnProtocols::edited(Protocols all, const std::vector<Edit>& edits) {
    for (const Edit& edit : edits) {
        if (!edit.added)
            std::erase_if(all, [&](const auto& each) { return each.name == edit.name; });
        else if (auto next = study::withHangingProtocol(all, *edit.added))
            all = *std::move(next);
    }
    return all;
}

// Runs on the thread of the job, or in the destructor. Without edits nothing is written.
Result<OwnProtocols::Protocols> OwnProtocols::keepIn(const std::filesystem::path& folder,
                                                     const std::vector<Edit>& edits) {
    MACULA_TRY(const std::optional<std::string> json, live::machineDocument(folder, idOf()));
    Protocols stored;
    if (json) {
        auto read = study::hangingProtocolsFromJson(*json);
        if (!read && edits.empty()) return read.error();
        if (read)
            stored = *std::move(read);
        else  // a copy for the version that wrote it
            MACULA_TRY_VOID(
                live::keepMachineDocument(folder, idOf("hanging protocols not understood"), kVersion, *json));
    }
    stored = edited(std::move(stored), edits);
    if (!edits.empty())
        MACULA_TRY_VOID(live::keepMachineDocument(folder, idOf(), kVersion, study::toJson(stored)));
    return stored;
}

Result<void> OwnProtocols::add(const study::HangingProtocol& protocol) {
    MACULA_TRY(const Protocols next, study::withHangingProtocol(all_, protocol));
    edit({.name = protocol.name, .added = protocol});
    return {};
}

void OwnProtocols::remove(const std::string& name) {
    edit({.name = name, .added = {}});
}

void OwnProtocols::edit(Edit made) {
    all_ = edited(std::move(all_), {made});
    Q_EMIT changed();
    if (!folder_) return;
    waiting_.push_back(std::move(made));
    if (!isBusy_) keep();
}

void OwnProtocols::keep() {
    isBusy_ = true;
    writing_ = std::exchange(waiting_, {});
    job_->start([folder = *folder_, edits = writing_](Progress&) { return keepIn(folder, edits); });
}

void OwnProtocols::onKept(const Result<Protocols>& kept) {
    isBusy_ = false;
    writing_.clear();
    if (kept)
        all_ = edited(*kept, waiting_);
    else
        Q_EMIT failed(kept.error());
    Q_EMIT changed();
    if (!waiting_.empty()) keep();
}

}  // namespace macula::viewer
