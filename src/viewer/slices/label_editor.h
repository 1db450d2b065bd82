// Edits the label of a measurement beside it.
#pragma once

#include <QLineEdit>

namespace macula::viewer {

// A line edit that deletes itself: Enter or loss of focus accepts the text, Esc keeps the old one. Cuts the
// text to scene::kLongestLabelBytes of UTF-8.
class LabelEditor : public QLineEdit {
    Q_OBJECT

  public:
    // Within `pane`, as near to `place` as it fits; takes the keyboard focus.
    LabelEditor(QWidget* pane, QPoint place, const QString& text);

  Q_SIGNALS:
    void accepted(const QString& text);  // at most once; differs from the old text

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

  private:
    void finish(bool isAccepted);

    QString before_;
    bool isDone_ = false;
};

}  // namespace macula::viewer
