#pragma once

#include "app/model/web/web_page.h"

#include <QByteArray>
#include <QString>

namespace app {

/// What a web page is made of.
struct PageParts
{
    QString title;
    QString language; ///< "de"
    PageColors light, dark;
    QByteArray data; ///< from packed()
};

/// Returns `json` and `numbers` in one piece, which page/numbers.js unpacks: the size of `json` (4 bytes, little-endian),
/// then both. All of it is compressed (zlib) and written in base64.
QByteArray packed(const QByteArray &json, const QByteArray &numbers);

/// Returns the text of a page. A Content-Security-Policy allows only its own script and style sheet, so that no text
/// from elsewhere can run and nothing is loaded.
QByteArray pageText(const PageParts &parts);

}
