// What the Help menu shows.
#pragma once

class QWidget;

namespace macula::viewer {

// Neither waits for anybody.
void showKeys(QWidget* parent);
void showAbout(QWidget* parent);

}  // namespace macula::viewer
