#pragma once

#include <QStandardPaths>

class QWidget;

namespace app {

/// Returns the folder of the learner for files of a kind, or the home folder if there is none.
QString standardFolder(QStandardPaths::StandardLocation kind);

/// Asks where to save a file, and suggests `name`. A name without a folder goes to the folder that was last
/// used to save or open a file. A typed name without an extension gets the extension of `name`. Asks before
/// an existing file is replaced. Returns the path, or an empty text if the learner cancels.
QString askWhereToSave(QWidget *parent, const QString &title, const QString &name, const QString &filter);

/// Asks which file to open, starting in the folder of `path` if that is not empty. Returns the path, or an
/// empty text if the learner cancels.
QString askWhatToOpen(QWidget *parent, const QString &title, const QString &path, const QString &filter);

}
