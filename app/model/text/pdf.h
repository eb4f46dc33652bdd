#pragma once

#include <QByteArray>

class QTextDocument;

namespace app {

/// Returns a document as a PDF file of numbered A4 pages. A heading that would be the last line of a page begins the next
/// one, and `document` has that page break then. Needs a QGuiApplication, for its fonts.
QByteArray pdfOf(QTextDocument &document, const QString &title);

}
