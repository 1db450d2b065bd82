// A list of named clips of this study.
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QWidget>
#include <optional>

#include "viewer/editor/study_editor.h"

namespace macula::viewer {

// Shows the named clips of the session's state, and proposes changes to them: a person saves the current clip
// and cuts under a unique name and restores them later. The session outlives it.
class NamedClips : public QWidget {
    Q_OBJECT

  public:
    explicit NamedClips(StudyEditor& session, QWidget* parent = nullptr);

  private:
    QPushButton* addButton(const QString& text, const char* name, void (NamedClips::*does)());
    const std::vector<scene::NamedClip>& clips() const { return session_.state().namedClips; }
    std::optional<std::size_t> chosen() const;
    std::optional<std::size_t> indexOf(const std::string& name) const;
    std::optional<std::string> typedName();  // if it is not usable: nothing, and a message
    void save();
    void apply();
    void rename();
    void remove();
    void showClips();
    void showButtons();

    StudyEditor& session_;
    QListWidget* list_;
    QLineEdit* name_;
    QPushButton* save_;
    QPushButton* apply_;
    QPushButton* rename_;
    QPushButton* remove_;
    QLabel* trouble_;
};

}  // namespace macula::viewer
