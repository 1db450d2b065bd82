// The words of a measurement, typed where it lies.
#pragma once

#include <QLineEdit>

namespace macula::viewer {

// A line that goes by itself: Enter and a click elsewhere take what was typed, Esc leaves it as it was. In
// UTF-8 no longer than a label may be.
class LabelEditor : public QLineEdit {
    Q_OBJECT

  public:
    // Within `pane`, as near to `place` as it fits; has the keyboard.
    LabelEditor(QWidget* pane, QPoint place, const QString& text);

  signals:
    void accepted(const QString& text);  // once at most; it differs from the text of before

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

  private:
    void finish(bool isAccepted);

    QString before_;
    bool isDone_ = false;
};

}  // namespace macula::viewer
