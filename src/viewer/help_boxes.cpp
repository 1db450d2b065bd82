#include "viewer/help_boxes.h"

#include <QCoreApplication>
#include <QMessageBox>

#include "viewer/keys.h"
#include "viewer/language/core_words.h"

namespace macula::viewer {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(Help)
};

}  // namespace

void showKeys(QWidget* parent) {
    QString rows;
    for (const KeyRow& row : kKeys)
        rows += QStringLiteral("<tr><td>%1</td><td>%2</td></tr>")
                    .arg(chosenFor(row).toHtmlEscaped(),
                         inWindowsLanguage(QString::fromUtf8(row.does)).toHtmlEscaped());
    auto* box = new QMessageBox(QMessageBox::NoIcon, Words::tr("Keys and Mouse"),
                                QStringLiteral("<table cellspacing='6'>%1</table>").arg(rows),
                                QMessageBox::Close, parent);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setModal(false);
    box->show();
}

void showAbout(QWidget* parent) {
    auto* box = new QMessageBox(
        QMessageBox::NoIcon, Words::tr("About Macula"),
        Words::tr(
            "<p><b>Macula %1</b></p><p>Path-traced anatomy from DICOM.</p>"
            "<p>Not a medical device, and <b>not for primary diagnosis</b>.</p><p>Licence: Apache-2.0.</p>")
            .arg(QCoreApplication::applicationVersion()),
        QMessageBox::Close, parent);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setModal(false);
    box->show();
}

}  // namespace macula::viewer
