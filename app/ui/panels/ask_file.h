#pragma once

#include <QString>

class QWidget;

namespace app {

/// Asks where to save. `name` is suggested; without a folder it goes to where a file was saved or opened last. What is typed
/// without an ending gets that of `name`, and where a file is in the place already, it is asked about. Empty: nowhere.
QString askWhereToSave(QWidget *parent, const QString &title, const QString &name, const QString &filter);

/// Asks which file to open, beside `path` if that is not empty. Empty: none.
QString askWhatToOpen(QWidget *parent, const QString &title, const QString &path, const QString &filter);

}
