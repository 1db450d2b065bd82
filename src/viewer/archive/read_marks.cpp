#include "viewer/archive/read_marks.h"

#include <array>
#include <set>
#include <string_view>
#include <utility>

#include "live/store/study_keeper.h"
#include "viewer/jobs/post.h"

namespace macula::viewer {

namespace {

constexpr std::int64_t kVersion = 1;
constexpr std::array<std::string_view, 1> kMembers{"read"};

session::DocumentId idOf(const std::string& studyInstanceUid) {
    return {.kind = session::DocumentKind::studyState,
            .study = session::studyIdentity(studyInstanceUid),
            .name = "read"};
}

std::map<std::string, ReadMark> marksIn(session::Store& store, const std::vector<std::string>& uids) {
    std::set<std::string> opened;
    if (const auto studies = store.listStudies())
        for (const session::StudyEntry& entry : studies->entries) opened.insert(entry.identity);
    std::map<std::string, ReadMark> marks;
    for (const std::string& uid : uids) {
        const bool isSeen = opened.contains(session::studyIdentity(uid));
        marks[uid] = isSeen ? ReadMark::seen : ReadMark::unseen;
        const auto document = store.getDocument(idOf(uid));
        if (document && *document) marks[uid] = ReadMark::read;
    }
    return marks;
}

}  // namespace

ReadMarks::ReadMarks(std::shared_ptr<live::StudyKeeper> keeper, QObject* parent)
    : QObject(parent), keeper_(std::move(keeper)) {}

void ReadMarks::letKeeperGo() {
    keeper_.reset();
}

void ReadMarks::ask(const std::vector<std::string>& studyInstanceUids) {
    std::vector<std::string> unknown;
    for (const std::string& uid : studyInstanceUids)
        if (!uid.empty() && !marks_.contains(uid)) unknown.push_back(uid);
    if (unknown.empty() || !keeper_) return;
    keeper_->withStore([home = this, uids = std::move(unknown)](session::Store* store) {
        if (store == nullptr) return;
        post(home, [home, marks = marksIn(*store, uids)] {
            // What a person marked meanwhile stays.
            home->marks_.insert(marks.begin(), marks.end());
            for (const std::string& uid : home->opened_)
                if (home->of(uid) == ReadMark::unseen) home->marks_[uid] = ReadMark::seen;
            Q_EMIT home->changed();
        });
    });
}

ReadMark ReadMarks::of(const std::string& studyInstanceUid) const {
    const auto found = marks_.find(studyInstanceUid);
    return found == marks_.end() ? ReadMark::unknown : found->second;
}

void ReadMarks::setRead(const std::string& studyInstanceUid, bool isRead) {
    if (studyInstanceUid.empty()) return;
    marks_[studyInstanceUid] = isRead ? ReadMark::read : ReadMark::seen;
    Q_EMIT changed();
    if (!keeper_) return;
    keeper_->withStore([home = this, uid = studyInstanceUid, isRead](session::Store* store) {
        if (store == nullptr) return;
        const bool isKept = isRead
                                ? bool(store->putDocument(idOf(uid), kVersion, R"({"read":true})", kMembers))
                                : bool(store->removeDocument(idOf(uid)));
        if (!isKept) post(home, [home] { Q_EMIT home->failed(); });
    });
}

void ReadMarks::noteOpened(const std::string& studyInstanceUid) {
    opened_.insert(studyInstanceUid);
    const auto found = marks_.find(studyInstanceUid);
    if (found == marks_.end()) return ask({studyInstanceUid});
    if (found->second == ReadMark::unseen) found->second = ReadMark::seen;
    Q_EMIT changed();
}

}  // namespace macula::viewer
