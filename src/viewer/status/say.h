// What a panel says below its controls.
#pragma once

#include <QLabel>
#include <QString>

namespace macula::viewer {

// The label takes room only while there is something to say.
inline void say(QLabel& label, const QString& text) {
    label.setText(text);
    label.setVisible(!text.isEmpty());
}

}  // namespace macula::viewer
