// Which studies a person has read, kept in the study store.
#pragma once

#include <QObject>
#include <QString>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace macula::live {
class StudyKeeper;
}

namespace macula::viewer {

enum class ReadMark {
    unknown,  // the store has not answered yet, or there is none
    unseen,   // never opened on this machine
    seen,     // opened
    read,     // a person marked it
};

// Studies by their UIDs, which only their digests stand for in the store. Lives on the UI thread.
class ReadMarks : public QObject {
    Q_OBJECT

  public:
    // Null: nothing is kept, and marks last for the run.
    explicit ReadMarks(std::shared_ptr<live::StudyKeeper> keeper, QObject* parent = nullptr);

    void letKeeperGo();
    // Asks the store for those that are not known; `changed` follows, later.
    void ask(const std::vector<std::string>& studyInstanceUids);
    ReadMark of(const std::string& studyInstanceUid) const;
    void setRead(const std::string& studyInstanceUid, bool isRead);
    void noteOpened(const std::string& studyInstanceUid);

  Q_SIGNALS:
    void changed();
    void failed();  // a mark could not be stored

  private:
    std::shared_ptr<live::StudyKeeper> keeper_;
    std::map<std::string, ReadMark> marks_;
    std::set<std::string> opened_;  // in this run
};

}  // namespace macula::viewer
