// Notes on the open study, which stay until a person dismisses them.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <array>
#include <functional>

namespace macula::viewer {

class MessageBar;

// The subject of a note, in the order of notes in the bar.
enum class NoteOn {
    visibility,  // why nothing is seen
    session,     // how the study was restored
    store,       // errors of the store
    preset,
    study,
    archive,  // that a fetched study is not whole
    table,
    second,  // the second volume
    segments,
    dose,     // that one lies on the study
    picture,  // what the device shows of the study
    device,
};

// Notes stay while another study loads, and if that fails. Lives on the UI thread.
class StudyNotes : public QObject {
    Q_OBJECT

  public:
    explicit StudyNotes(QObject* parent = nullptr);

    MessageBar& bar() const { return *bar_; }  // it belongs to the widget that shows it
    QString text() const;                      // empty without notes, or after they were dismissed

    // Takes effect with the next show(). Returns whether the notes changed.
    bool set(NoteOn what, const QStringList& notes);
    bool set(NoteOn what, const QString& note);  // empty: none
    // Asks for notes at each show(), instead of those that were set.
    void setSource(NoteOn what, std::function<QStringList()> source);
    void show();  // also dismissed notes; hides the bar if there are none
    void showIfOther(NoteOn what, const QString& note);

  private:
    static constexpr std::size_t kKinds = std::size_t(NoteOn::device) + 1;

    MessageBar* bar_;
    std::array<QStringList, kKinds> notes_;
    std::array<std::function<QStringList()>, kKinds> sources_;
};

}  // namespace macula::viewer
