// The boxes of the Help menu.
#pragma once

class QWidget;

namespace macula::viewer {

// Both return at once.
void showKeys(QWidget* parent);
void showAbout(QWidget* parent);

}  // namespace macula::viewer
