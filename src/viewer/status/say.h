// Messages of a panel below its controls.
#pragma once

#include <QLabel>
#include <QString>

namespace macula::viewer {

// Shows the label only while the text is not empty.
inline void say(QLabel& label, const QString& text) {
    label.setText(text);
    label.setVisible(!text.isEmpty());
}

}  // namespace macula::viewer
