#include "viewer/help_boxes.h"

#include <QCoreApplication>
#include <QMessageBox>

namespace macula::viewer {

namespace {

QString text(const char* source) {
    return QCoreApplication::translate("Help", source);
}

}  // namespace

void showKeys(QWidget* parent) {
    auto* box =
        new QMessageBox(QMessageBox::NoIcon, text("Keys and Mouse"),
                        text("<table cellspacing='6'>"
                             "<tr><td>Left drag, arrows</td><td>Walk around the patient</td></tr>"
                             "<tr><td>Middle drag, Shift + left drag, Shift + arrows</td><td>Move "
                             "sideways</td></tr>"
                             "<tr><td>Wheel, right drag, Ctrl + left drag, + and −</td><td>Closer, "
                             "farther</td></tr>"
                             "<tr><td>A, P, L, R, S, I</td><td>Look from anterior, posterior, left, "
                             "right, superior, inferior</td></tr>"
                             "<tr><td>Right drag in maximum, minimum, average</td><td>Window: wider to the "
                             "right, brighter up; Ctrl + R resets it</td></tr>"
                             "<tr><td>F</td><td>Fit what is visible</td></tr>"
                             "<tr><td>N</td><td>Patient, study and series over the picture, or "
                             "not</td></tr>"
                             "<tr><td>Ctrl + 1 to 6</td><td>Cinematic, clear, ray cast, maximum, "
                             "minimum, average</td></tr>"
                             "<tr><td>Ctrl + 0</td><td>Shade the ray cast, or not</td></tr>"
                             "<tr><td>Ctrl + T</td><td>Remove the table of a CT, or show it "
                             "again</td></tr>"
                             "<tr><td>Ctrl + U</td><td>No clip</td></tr>"
                             "<tr><td>Ctrl + O, or drop a folder or file</td><td>Open a study</td></tr>"
                             "</table>"),
                        QMessageBox::Close, parent);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setModal(false);
    box->show();
}

void showAbout(QWidget* parent) {
    auto* box = new QMessageBox(
        QMessageBox::NoIcon, text("About Macula"),
        text("<p><b>Macula %1</b></p><p>Path-traced anatomy from DICOM.</p>"
             "<p>Not a medical device, and <b>not for primary diagnosis</b>.</p><p>Licence: Apache-2.0.</p>")
            .arg(QCoreApplication::applicationVersion()),
        QMessageBox::Close, parent);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setModal(false);
    box->show();
}

}  // namespace macula::viewer
