#pragma once

#include "app/model/notebook/notebook.h"

#include <QImage>

#include <functional>

namespace app {

/// Returns a picture of the moment of an entry; null: there is none.
using EntryPicture = std::function<QImage(const NotebookEntry &entry)>;

/// Returns a notebook as a web page in one file, in the language of the program. It loads nothing from elsewhere.
QByteArray notebookHtml(const Notebook &notebook, const LessonLibrary &library, const EntryPicture &picture);
/// Returns the same as a PDF file of A4 pages. It needs a QGuiApplication, for its fonts.
QByteArray notebookPdf(const Notebook &notebook, const LessonLibrary &library, const EntryPicture &picture);

/// Returns `markdown`, a paragraph with **bold** words and `code`, as HTML.
QString htmlOf(const QString &markdown);

}
