#pragma once

#include <QByteArray>

class QTextDocument;

namespace app {

/// Returns a document as a PDF file of numbered A4 pages. Needs a QGuiApplication, for its fonts.
QByteArray pdfOf(QTextDocument &document, const QString &title);

}
